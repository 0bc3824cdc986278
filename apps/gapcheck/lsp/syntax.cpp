#include "lsp/syntax.hpp"

#include <algorithm>
#include <utility>

#include "base/number.hpp"
#include "base/parallel.hpp"
#include "keyword/card.hpp"
#include "keyword/keyword_line.hpp"
#include "keyword/known_keywords.hpp"
#include "keyword/text/line_ends.hpp"
#include "lsp/scope.hpp"
#include "model/unknown_keyword.hpp"

namespace gapcheck::app::lsp {
namespace {

using keyword::CardLayout;
using keyword::Field;
using keyword::FieldType;

/// Enough to show that a file is not a deck, or has another format.
constexpr std::size_t most_faults_in_a_piece = 100;
/// To find the nearest known keyword takes a while.
constexpr std::size_t most_names_looked_up = 20;

/// The fields of a card that are numbers, in a format.
struct NumberCells {
  struct Cell {
    std::size_t field, column, width;
    bool id;
  };
  std::vector<Cell> cells;
  NumberCells(const CardLayout& layout, keyword::Format format) {
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
      const Field& field = layout.fields[i];
      if (field.type == FieldType::text || field.name == "unused") continue;
      const keyword::Cell at = keyword::locate(layout, format, i);
      const bool id = field.type == FieldType::integer && field.id != keyword::IdKind::plain;
      cells.push_back({i, at.column, at.width, id});
    }
  }
};

/// Digits with a point and a sign at most, without one where an id is wanted: most fields, at a glance.
bool is_plain_number(std::string_view text, bool id) {
  std::size_t at = text.front() == '-' ? 1 : 0, digits = 0;
  bool point = id;
  for (; at < text.size(); ++at) {
    if (static_cast<unsigned>(text[at] - '0') < 10)
      ++digits;
    else if (text[at] == '.' && !point)
      point = true;
    else
      return false;
  }
  return digits > 0 && digits < 18;
}

/// Other fields for whole numbers are not judged by fractions: some of them mean two things.
bool is_number(std::string_view text, bool id) {
  return is_plain_number(text, id) || (id ? parse_integer(text).has_value() : parse_real(text).has_value());
}

/// What makes a field more than the columns that it has: free format, tabs, parameters, expressions.
constexpr std::string_view special = ",\t&<";

bool has_special(std::string_view text) {
  return std::any_of(special.begin(), special.end(), [text](char c) { return text.find(c) != std::string_view::npos; });
}

/// True if all fields of a line in fixed columns are blank or numbers.
bool is_fine(std::string_view line, const NumberCells& numbers) {
  if (line.size() > keyword::Card::max_line) return false;
  for (const NumberCells::Cell& cell : numbers.cells) {
    std::size_t begin = cell.column, end = std::min(cell.column + cell.width, line.size());
    while (begin < end && line[begin] == ' ') ++begin;
    if (begin >= end) continue;
    while (line[end - 1] == ' ') --end;
    if (!is_number(line.substr(begin, end - begin), cell.id)) return false;
  }
  return true;
}

/// What the cards say of the fields of a line.
void add_field_faults(const keyword::Card& card, const NumberCells& numbers, std::uint32_t line,
                      const Diagnostics& said, std::vector<LineFault>& faults) {
  for (const NumberCells::Cell& cell : numbers.cells) {
    const std::string_view written = card.written(cell.field);
    // Parameters may be defined in any file.
    if (written.empty() || keyword::is_parameter_reference(written) || is_number(written, cell.id)) continue;
    const std::size_t before = said.sorted().size();
    static_cast<void>(cell.id ? static_cast<double>(card.integer(cell.field)) : card.real(cell.field));
    const std::vector<Diagnostic> all = said.sorted();
    if (all.size() == before) continue;
    const auto begin = static_cast<std::size_t>(written.data() - card.raw_line().data());
    const auto about = std::find_if(all.begin(), all.end(), [&](const Diagnostic& each) {
      return std::none_of(faults.begin(), faults.end(),
                          [&](const LineFault& fault) { return fault.line == line && fault.message == each.message; });
    });
    if (about != all.end()) faults.push_back({line, begin, begin + written.size(), about->severity, about->message});
  }
}

/// A name that the manual does not have, in the words of the rule.
void add_name_fault(const std::string& name, std::uint32_t line, std::size_t length, std::size_t& looked_up,
                    std::vector<LineFault>& faults) {
  if (name.empty()) {
    faults.push_back(
        {line, 0, length, Severity::error, "a keyword line without a name; give the keyword or remove it"});
    return;
  }
  if (keyword::standing_of(name) == keyword::Standing::known) return;
  const model::UnknownKeyword unknown{name, {}, 1, false};
  const std::string nearest = looked_up++ < most_names_looked_up ? model::nearest_keyword(unknown) : std::string();
  faults.push_back({line, 0, length, model::severity(unknown, nearest), model::describe(unknown, nearest)});
}

}  // namespace

/// What each piece begins with.
std::vector<SyntaxCheck::State> SyntaxCheck::states(const Text& text) {
  std::vector<State> all;
  all.reserve(text.pieces().size());
  State state;
  for (std::size_t p = 0; p < text.pieces().size(); ++p) {
    all.push_back(state);
    const Piece& piece = *text.pieces()[p];
    std::size_t data = 0;
    for (const Piece::Mark& mark : piece.marks) {
      if (state.ended) break;
      keyword::KeywordLine read = keyword::read_keyword_line(next_line(piece.bytes, mark.offset, data), state.of_file);
      state.ended = read.name == "END";
      state.keyword = std::move(read.name);
      state.format = read.format;
    }
    if (piece.marks.empty()) {
      state.row = state.order.least(state.row + piece.rows);
      continue;
    }
    state.order = card_order(state.keyword, state.format, text, {p, data});
    state.row = state.order.least(piece.rows);
  }
  return all;
}

SyntaxCheck::Checked SyntaxCheck::checked(const Text& text, std::size_t number, const State& before) {
  const Piece& piece = *text.pieces()[number];
  Checked result{before, {}};
  State state = before;
  std::size_t looked_up = 0;
  const Scope scope;
  std::map<const CardLayout*, NumberCells> cells;
  const CardLayout* layout = nullptr;
  const NumberCells* numbers = nullptr;
  keyword::Block block;
  block.name = state.keyword;
  block.format = state.format;
  const bool specials = has_special(piece.bytes);
  std::uint32_t line = 0;
  std::size_t mark = 0;
  for (std::size_t at = 0; at < piece.bytes.size() && !state.ended; ++line) {
    if (result.faults.size() >= most_faults_in_a_piece) break;
    const std::string_view bytes = next_line(piece.bytes, at, at);
    if (mark < piece.marks.size() && piece.marks[mark].line == line) {
      keyword::KeywordLine read = keyword::read_keyword_line(bytes, state.of_file);
      add_name_fault(read.name, line, bytes.size(), looked_up, result.faults);
      state.ended = read.name == "END";
      block.name = read.name;
      block.format = read.format;
      state.order = card_order(read.name, read.format, text, {number, at});
      state.row = 0;
      cells.clear();
      layout = nullptr;
      ++mark;
      continue;
    }
    if (bytes.starts_with('$')) continue;
    const CardLayout* const card = state.order.at(state.row++);
    if (card == nullptr || !state.order.checked) continue;
    if (card != layout) {
      layout = card;
      numbers = &cells.try_emplace(card, *card, block.format).first->second;
    }
    if (!(specials && has_special(bytes)) && is_fine(bytes, *numbers)) continue;
    Diagnostics said;
    const keyword::Card read(scope.deck(), block, *card, bytes, line + 1, said);
    add_field_faults(read, *numbers, line, said, result.faults);
  }
  return result;
}

std::vector<LineFault> SyntaxCheck::check(const Text& text) {
  const std::vector<State> before = states(text);
  std::map<std::shared_ptr<const Piece>, Checked> now;
  std::vector<std::size_t> open;
  std::vector<Checked*> results(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto& piece = text.pieces()[i];
    const auto found = known_.find(piece);
    const bool same = found != known_.end() && found->second.before == before[i];
    const auto [entry, fresh] = now.try_emplace(piece, same ? std::move(found->second) : Checked{});
    results[i] = &entry->second;
    if (!same) open.push_back(i);
  }
  parallel_for(open.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) *results[open[i]] = checked(text, open[i], before[open[i]]);
  });
  looked_at_ = open.size();
  known_ = std::move(now);
  std::vector<LineFault> faults;
  for (std::size_t i = 0; i < results.size(); ++i)
    for (const LineFault& fault : results[i]->faults) {
      if (faults.size() == most_faults) return faults;
      faults.push_back(fault);
      faults.back().line += text.first_line(i);
    }
  return faults;
}

}  // namespace gapcheck::app::lsp
