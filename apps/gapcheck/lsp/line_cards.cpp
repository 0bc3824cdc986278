#include "lsp/line_cards.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>

#include "base/number.hpp"
#include "keyword/parameters.hpp"
#include "model/contact/contact_name.hpp"

namespace gapcheck::app::lsp {
namespace {

using keyword::card_layout;
using keyword::CardLayout;
using Words = std::vector<std::string_view>;

/// Fields of ids in a line of an element.
constexpr std::size_t ids_in_line = 10;

/// The words of a name behind "ELEMENT" and its family.
struct Options {
  Words words;
  [[nodiscard]] bool has(std::string_view word) const { return std::ranges::find(words, word) != words.end(); }
  [[nodiscard]] bool any(std::initializer_list<std::string_view> list) const {
    return std::ranges::any_of(list, [this](std::string_view word) { return has(word); });
  }
  /// Whether there are no others than these.
  [[nodiscard]] bool only(std::initializer_list<std::string_view> list) const {
    return std::ranges::all_of(words,
                               [&](std::string_view word) { return std::ranges::find(list, word) != list.end(); });
  }
};

ElementLines shell_lines(const Options& options) {
  // Without an option it is one line each, in the order that card_order() knows.
  if (options.words.empty() || !options.only({"THICKNESS", "BETA", "MCID", "OFFSET", "DOF", "COMPOSITE", "LONG"}))
    return {};
  ElementLines lines{&card_layout("ELEMENT_SHELL", "card1")};
  if (options.any({"THICKNESS", "BETA", "MCID"})) {
    lines.behind.push_back(options.has("MCID") ? &card_layout("ELEMENT_SHELL_MCID", "card1.2")
                                               : &card_layout("ELEMENT_SHELL_THICKNESS", "card1.2"));
    lines.middle = &card_layout("ELEMENT_SHELL_THICKNESS", "card1.3");
  }
  if (options.has("OFFSET")) lines.behind.push_back(&card_layout("ELEMENT_SHELL_OFFSET", "card2"));
  if (options.has("DOF")) lines.behind.push_back(&card_layout("ELEMENT_SHELL_DOF", "card2"));
  if (options.has("COMPOSITE"))
    lines.ply = options.has("LONG") ? &card_layout("ELEMENT_SHELL_COMPOSITE_LONG", "card2")
                                    : &card_layout("ELEMENT_SHELL_COMPOSITE", "card2");
  return lines;
}

ElementLines thick_shell_lines(const Options& options) {
  if (!options.only({"BETA", "COMPOSITE"})) return {};
  ElementLines lines{&card_layout("ELEMENT_TSHELL", "card1")};
  if (options.has("BETA")) lines.behind.push_back(&card_layout("ELEMENT_TSHELL_BETA", "card2"));
  if (options.has("COMPOSITE")) lines.ply = &card_layout("ELEMENT_TSHELL_COMPOSITE", "card2");
  return lines;
}

ElementLines solid_lines(const Options& options) {
  if (!options.only({"ORTHO", "DOF", "FORMAT2", "H20", "H27", "H64", "T15", "T20", "H8TOH20", "H8TOH27", "H8TOH64",
                     "T4TOT10", "T4TOT15", "TET4TOTET10"}))
    return {};
  // Their whole line has the fields of a shell's.
  ElementLines lines{&card_layout("ELEMENT_SHELL", "card1"), &card_layout("ELEMENT_SOLID_H20", "card2"), 1};
  if (options.any({"H20", "T15", "T20"})) lines.node_lines = 2;
  if (options.has("H27")) lines.node_lines = 3;
  if (options.has("H64")) lines.node_lines = 7;
  if (options.has("ORTHO"))
    for (const char* card : {"card3", "card4"}) lines.behind.push_back(&card_layout("ELEMENT_SOLID_ORTHO", card));
  if (options.has("DOF")) lines.behind.push_back(&card_layout("ELEMENT_SOLID_DOF", "card2"));
  return lines;
}

ElementLines beam_lines(const Options& options) {
  struct Line {
    std::string_view option;
    const CardLayout* card;
  };
  static const std::array order{
      Line{"THICKNESS", &card_layout("ELEMENT_BEAM_THICKNESS", "card2")},
      Line{"SECTION", &card_layout("ELEMENT_BEAM_SECTION", "card2")},
      Line{"SCALAR", &card_layout("ELEMENT_BEAM_SCALAR", "card2")},
      Line{"SCALR", nullptr},
      Line{"PID", &card_layout("ELEMENT_BEAM_PID", "card2")},
      Line{"OFFSET", &card_layout("ELEMENT_BEAM_OFFSET", "card2")},
      Line{"ORIENTATION", &card_layout("ELEMENT_BEAM_ORIENTATION", "card1.2")},
      Line{"WARPAGE", &card_layout("ELEMENT_BEAM_WARPAGE", "card2")},
      Line{"ELBOW", &card_layout("ELEMENT_BEAM_ELBOW", "card2")},
  };
  if (options.words.empty()) return {};
  ElementLines lines{&card_layout("ELEMENT_BEAM", "card1")};
  for (const Line& line : order)
    if (options.has(line.option)) lines.behind.push_back(line.card);
  return lines.behind.size() == options.words.size() ? lines : ElementLines();
}

ElementLines lines_of(std::string_view name) {
  Words words = model::words_of(name);
  if (words.size() < 2 || words.front() != "ELEMENT") return {};
  const std::string_view family = words[1];
  const Options options{Words(words.begin() + 2, words.end())};
  if (family == "SHELL") return shell_lines(options);
  if (family == "TSHELL") return thick_shell_lines(options);
  if (family == "SOLID") return solid_lines(options);
  if (family == "BEAM") return beam_lines(options);
  if (family == "SPH" && options.only({"VOLUME"})) return {&card_layout("ELEMENT_SPH", "card1")};
  if (family == "DISCRETE" && options.only({"LCO"})) {
    ElementLines lines{&card_layout("ELEMENT_DISCRETE", "card1")};
    if (options.has("LCO")) lines.behind.push_back(&card_layout("ELEMENT_DISCRETE_LCO", "card2"));
    return lines;
  }
  if (family == "INERTIA" && options.only({"OFFSET"})) {
    ElementLines lines{&card_layout("ELEMENT_INERTIA", "card1")};
    lines.behind.push_back(&card_layout("ELEMENT_INERTIA", "card2"));
    if (options.has("OFFSET")) lines.behind.push_back(nullptr);
    return lines;
  }
  return {};
}

/// A field of a line of ids of eight columns each.
std::string_view id_field(std::string_view line, std::size_t field, keyword::Format format) {
  if (line.find(',') == std::string_view::npos) {
    const std::size_t width = format == keyword::Format::long_fields ? 20 : format == keyword::Format::i10 ? 10 : 8;
    return trimmed(line.size() > field * width ? line.substr(field * width, width) : std::string_view());
  }
  for (; field > 0; --field) {
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos) return {};
    line.remove_prefix(comma + 1);
  }
  return trimmed(line.substr(0, line.find(',')));
}

/// Whether one of the fields [first, ids_in_line) is neither blank nor zero.
bool names_nodes(std::string_view line, std::size_t first, keyword::Format format) {
  for (std::size_t i = first; i < ids_in_line; ++i)
    if (const std::string_view field = id_field(line, i, format); !field.empty() && parse_integer(field) != 0)
      return true;
  return false;
}

/// A line of plies has a thickness in the columns of an element's nodes: no five whole numbers above 0.
bool can_be_element(std::string_view line, keyword::Format format) {
  for (std::size_t i = 0; i < 5; ++i) {
    const std::string_view field = id_field(line, i, format);
    if (!keyword::is_parameter_reference(field) && parse_integer(field).value_or(0) <= 0) return false;
  }
  return true;
}

}  // namespace

LineCards::LineCards(const Text& text, const Keyword& keyword)
    : text_(text), keyword_(keyword), order_(card_order(text, keyword)), elements_(lines_of(keyword.name)) {}

const CardLayout* LineCards::next(std::string_view line) {
  const std::size_t row = row_++;
  if (elements_.first == nullptr) return order_.at(row);
  if (next_ < rest_.size()) return rest_[next_++];
  // Between elements reading skips it.
  if (trimmed(line).empty()) return order_.at(row);
  if (begun_ && elements_.ply != nullptr && !can_be_element(line, keyword_.format)) return elements_.ply;
  begin(line);
  return elements_.first;
}

void LineCards::begin(std::string_view line) {
  begun_ = true;
  next_ = 0;
  rest_.clear();
  if (elements_.node_lines > 0 && !names_nodes(line, 2, keyword_.format))
    rest_.assign(elements_.node_lines, elements_.nodes);
  rest_.insert(rest_.end(), elements_.behind.begin(), elements_.behind.end());
  if (elements_.middle != nullptr && names_nodes(line, 6, keyword_.format))
    rest_.insert(rest_.begin() + 1, elements_.middle);
}

void LineCards::skip_to(std::uint32_t line) {
  // Where one card repeats, it does not matter how often.
  const bool repeats = elements_.first == nullptr && order_.cycle.size() == 1;
  const std::size_t enough = repeats ? order_.head.size() : static_cast<std::size_t>(-1);
  if (row_ >= enough) return;
  text_.for_each_line(keyword_.line + 1, line, [&](std::uint32_t, std::string_view each) {
    if (!each.starts_with('$')) static_cast<void>(next(each));
    return row_ < enough;
  });
}

CardLine card_at(const Text& text, std::span<const Keyword> outline, std::uint32_t line) {
  CardLine card{keyword_at(outline, line), nullptr, 0};
  if (card.keyword == nullptr || line == card.keyword->line) return card;
  LineCards cards(text, *card.keyword);
  cards.skip_to(line);
  card.row = cards.row();
  if (!text.line(line).starts_with('$')) card.layout = cards.next(text.line(line));
  return card;
}

}  // namespace gapcheck::app::lsp
