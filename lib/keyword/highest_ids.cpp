#include "keyword/highest_ids.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <string_view>

#include "base/number.hpp"
#include "keyword/card.hpp"
#include "keyword/rows.hpp"

namespace gapcheck::keyword {
namespace {

/// `count` fields of `width` columns, the first of them an id.
CardLayout columns(std::size_t count, std::uint16_t width, IdKind kind) {
  CardLayout layout{"ids", {}};
  for (std::size_t i = 0; i < count; ++i)
    layout.fields.push_back({"id" + std::to_string(i), static_cast<std::uint16_t>(i * width), width, FieldType::integer,
                             i == 0 ? kind : IdKind::plain});
  return layout;
}

/// The highest id in the first field of all rows.
std::int64_t highest_of_rows(const Deck& deck, const Block& block, const CardLayout& id) {
  std::atomic<std::int64_t> highest{0};
  Diagnostics unused;  // the readers of the block report its faults
  const auto take = [&](std::size_t, const Rows& rows) {
    const std::int64_t best = *std::max_element(rows.integers.begin(), rows.integers.begin() + rows.count);
    for (std::int64_t before = highest; before < best && !highest.compare_exchange_weak(before, best);) continue;
  };
  read_rows_in_pieces(
      deck, block, id, unused, [](std::size_t) {}, take);
  return highest;
}

/// Whether the name of a block has a word.
bool has_word(std::string_view name, std::string_view word) {
  for (std::size_t at = name.find(word); at != std::string_view::npos; at = name.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (at > 0 && name[at - 1] == '_' && (end == name.size() || name[end] == '_')) return true;
  }
  return false;
}

std::size_t count_words(std::string_view name, std::initializer_list<std::string_view> words) {
  return static_cast<std::size_t>(
      std::count_if(words.begin(), words.end(), [&](std::string_view word) { return has_word(name, word); }));
}

constexpr std::size_t ids_in_line = 10;

/// How the elements of a block are spread over lines.
struct ElementLines {
  std::size_t behind = 0;     ///< lines after the nodes of each
  std::size_t of_nodes = 0;   ///< solids: lines with nodes if the first one has none
  bool middle_nodes = false;  ///< shells: one line more if the first names nodes N5 to N8
  bool plies = false;         ///< any number of lines, up to one that can only be an element
  [[nodiscard]] bool one_each() const { return behind == 0 && of_nodes == 0 && !middle_nodes && !plies; }
};

ElementLines lines_of(std::string_view name) {
  ElementLines lines;
  if (name.starts_with("ELEMENT_SHELL")) {
    lines.middle_nodes = count_words(name, {"THICKNESS", "BETA", "MCID"}) > 0;
    lines.behind = (lines.middle_nodes ? 1 : 0) + count_words(name, {"OFFSET", "DOF"});
    lines.plies = has_word(name, "COMPOSITE");
  } else if (name.starts_with("ELEMENT_SOLID")) {
    lines.of_nodes = has_word(name, "H64")                          ? 7
                     : has_word(name, "H27")                        ? 3
                     : count_words(name, {"H20", "T15", "T20"}) > 0 ? 2
                                                                    : 1;
    lines.behind = 2 * count_words(name, {"ORTHO"}) + count_words(name, {"DOF"});
  } else if (name.starts_with("ELEMENT_TSHELL")) {
    lines.behind = count_words(name, {"BETA"});
    lines.plies = has_word(name, "COMPOSITE");
  } else if (name.starts_with("ELEMENT_BEAM")) {
    lines.behind = count_words(
        name, {"THICKNESS", "SECTION", "SCALAR", "SCALR", "PID", "OFFSET", "ORIENTATION", "WARPAGE", "ELBOW"});
  } else if (name.starts_with("ELEMENT_INERTIA")) {
    lines.behind = 1 + count_words(name, {"OFFSET"});
  } else if (name.starts_with("ELEMENT_DISCRETE")) {
    lines.behind = count_words(name, {"LCO"});
  }
  return lines;
}

/// A line of plies has a thickness in the columns of an element's nodes: no five whole numbers above 0.
bool can_be_element(const Card& card) {
  for (std::size_t i = 0; i < 5; ++i) {
    const auto number = parse_integer(card.written(i));
    if (!is_parameter_reference(card.written(i)) && (!number || *number <= 0)) return false;
  }
  return true;
}

void skip(CardReader& reader, std::size_t lines) {
  for (; lines > 0 && !reader.at_end(); --lines) reader.skip();
}

std::int64_t highest_of_lines(const Deck& deck, const Block& block, const ElementLines& lines) {
  static const CardLayout ids = columns(ids_in_line, 8, IdKind::element);
  std::int64_t highest = 0;
  Diagnostics unused;
  for (CardReader reader(deck, block, unused); !reader.at_end();) {
    const Card card = reader.next(ids);
    if (trimmed(card.raw_line()).empty() || (lines.plies && !can_be_element(card))) continue;
    highest = std::max(highest, card.integer(std::size_t{0}));
    const auto named = [&](std::size_t first) {
      for (std::size_t i = first; i < ids_in_line; ++i)
        if (!card.blank(i) && card.integer(i) != 0) return true;
      return false;
    };
    if (lines.of_nodes > 0 && !named(2)) skip(reader, lines.of_nodes);
    skip(reader, lines.behind + (lines.middle_nodes && named(6) ? 1 : 0));
  }
  return highest;
}

/// Families whose rows begin with the id of an element.
bool has_element_ids(std::string_view name) {
  constexpr std::array<std::string_view, 9> families{"SHELL",    "SOLID", "TSHELL",  "BEAM",  "DISCRETE",
                                                     "SEATBELT", "MASS",  "INERTIA", "PLOTEL"};
  constexpr std::array<std::string_view, 6> others{"_SOURCE", "_PULLEY", "_SPHERE", "_PART", "_NODE_SET", "_MATRIX"};
  const std::string_view rest = name.substr(std::min(name.size(), std::string_view("ELEMENT_").size()));
  const auto begins = [&](std::string_view family) {
    return rest.starts_with(family) && (rest.size() == family.size() || rest[family.size()] == '_');
  };
  const auto contains = [&](std::string_view part) { return rest.find(part) != std::string_view::npos; };
  // *ELEMENT_SEATBELT_RETRACTOR and its like number things of their own.
  return std::any_of(families.begin(), families.end(), begins) &&
         std::none_of(others.begin(), others.end(), contains) && !rest.starts_with("SEATBELT_");
}

}  // namespace

bool is_node_or_element(std::string_view name) {
  return name == "NODE" || name.starts_with("NODE_") || name.starts_with("ELEMENT_");
}

void HighestIds::update(const Deck& deck) {
  static const CardLayout node = columns(1, 8, IdKind::node), element = columns(1, 8, IdKind::element);
  for (const std::span<const Block> blocks = deck.blocks(); next_ < blocks.size(); ++next_) {
    const Block& block = blocks[next_];
    if (block.name == "NODE") {
      node_ = std::max(node_, highest_of_rows(deck, block, node));
    } else if (block.name.starts_with("ELEMENT_") && has_element_ids(block.name)) {
      const ElementLines lines = lines_of(block.name);
      element_ = std::max(
          element_, lines.one_each() ? highest_of_rows(deck, block, element) : highest_of_lines(deck, block, lines));
    }
  }
}

}  // namespace gapcheck::keyword
