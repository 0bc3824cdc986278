#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "keyword/transform.hpp"

namespace gapcheck::keyword {

enum class FieldType : std::uint8_t { integer, real, text };

/// One field of a card: column and width in the standard format.
struct Field {
  std::string name;          ///< lower case, as in the manual; repeated fields share it
  std::uint16_t column = 0;  ///< from 0
  std::uint16_t width = 0;
  FieldType type = FieldType::integer;
  IdKind id = IdKind::plain;  ///< which offset of *INCLUDE_TRANSFORM applies to it
};

/// One line of a keyword.
struct CardLayout {
  std::string name;  ///< "card1", "A"
  std::vector<Field> fields;
  /// Position of a field, or npos.
  [[nodiscard]] std::size_t index(std::string_view field) const;
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};

/// The card layouts of one keyword.
struct KeywordLayout {
  std::string name;  ///< without `*`, without option suffixes: "CONTACT_AUTOMATIC_SINGLE_SURFACE"
  std::vector<CardLayout> cards;
  [[nodiscard]] const CardLayout* card(std::string_view name) const;
};

/// The table of all known keywords, generated data with the project's corrections on top; built on first use.
/// Exact name only; nullptr if the keyword is not known.
[[nodiscard]] const KeywordLayout* find_layout(std::string_view keyword);

/// The names in the table that begin with `prefix`, ascending.
[[nodiscard]] std::vector<std::string_view> layout_names(std::string_view prefix);

/// The layout that the program relies on: keyword and card must be in the table (a test checks all uses).
[[nodiscard]] const CardLayout& card_layout(std::string_view keyword, std::string_view card);

/// The known keyword that a name with option suffixes belongs to: trailing `_TOKEN`s are dropped until a name is known.
[[nodiscard]] const KeywordLayout* find_layout_of(std::string_view name_with_options);

}  // namespace gapcheck::keyword
