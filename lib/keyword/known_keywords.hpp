#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace gapcheck::keyword {

/// Whether a keyword's name is one of the manual's.
enum class Standing : std::uint8_t {
  known,
  other_form,  ///< begins with a known name, but a word behind it is not one of its family
  unknown,
};

/// Of a name in capitals without `*`: "ELEMENT_SHELL_THICKNESS". The words ID and TITLE may be anywhere behind the
/// first one. Families that the audit does not need are known as a whole (known_keywords.txt).
[[nodiscard]] Standing standing_of(std::string_view name);

/// The longest known name that a name of Standing::other_form begins with; empty for all others.
[[nodiscard]] std::string known_beginning(std::string_view name);

/// The known keyword that a misspelt name is nearest to: letters missing, added, replaced or swapped, underscores
/// missing, or words in another order; only few of them, and few in each word. Names that differ in digits alone are
/// not near. Of equally near ones that with the longest common beginning, then the first by name. Empty if none is
/// near, and for names of more than 100 characters.
[[nodiscard]] std::string nearest_keyword(std::string_view name);

}  // namespace gapcheck::keyword
