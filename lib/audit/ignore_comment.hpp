#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "audit/ignores.hpp"

namespace gapcheck::audit {

/// A parsed comment, or why it could not be parsed.
struct IgnoreComment {
  std::optional<IgnoreEntry> entry;  ///< without file and line; ids as they are written
  std::string wrong;                 ///< what is wrong and what to write
};

/// Reads what follows `$ gapcheck:`
///     ignore RULES [contact=IDS] [node=IDS] [part=IDS] [element=IDS] [until=YYYY-MM-DD] [because TEXT]
/// RULES: ids, names or beginnings of them; IDS: ids and ranges FIRST-LAST; both with commas. Case and blanks around
/// commas and equals signs do not matter.
[[nodiscard]] IgnoreComment read_ignore_comment(std::string_view text);

}  // namespace gapcheck::audit
