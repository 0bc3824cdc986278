#include "keyword/card.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "keyword/text/blanks_in_number.hpp"
#include "keyword/text/line_ends.hpp"

namespace gapcheck::keyword {
namespace {

std::size_t width_in(std::size_t standard, Format format) {
  if (format == Format::long_fields) return std::max<std::size_t>(standard, 20);
  return format == Format::i10 && standard == 8 ? 10 : standard;
}

/// The column after a character that starts in `column`: tabs reach to the next multiple of eight.
std::size_t next_column(char c, std::size_t column) { return c == '\t' ? (column / 8 + 1) * 8 : column + 1; }

/// Calls visit(index, column) for every comma outside parentheses, until it returns false.
template <class Visit>
void for_each_comma(std::string_view line, const Visit& visit) {
  int depth = 0;
  std::size_t column = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '(' || c == '[') ++depth;
    if ((c == ')' || c == ']') && depth > 0) --depth;
    if (c == ',' && depth == 0 && !visit(i, column)) return;
    column = next_column(c, column);
  }
}

std::string quoted(std::string_view text) { return "\"" + std::string(text.substr(0, 80)) + "\""; }

}  // namespace

Cell locate(const CardLayout& layout, Format format, std::size_t field) {
  Cell cell;
  std::size_t end = 0;  // of the field before, in the standard format
  for (std::size_t i = 0;; ++i) {
    const Field& current = layout.fields[i];
    if (current.column > end) {
      const std::size_t gap = current.column - end;
      const std::size_t unused = std::max<std::size_t>(1, gap / std::clamp<std::size_t>(current.width, 1, 10));
      cell.slot += unused;
      cell.column += unused * width_in(gap / unused, format);
    }
    if (format == Format::standard) cell.column = current.column;
    cell.width = width_in(current.width, format);
    if (i == field) return cell;
    ++cell.slot;
    cell.column += cell.width;
    end = static_cast<std::size_t>(current.column) + current.width;
  }
}

Card::Card(const Deck& deck, const Block& block, const CardLayout& layout, std::string_view raw, std::uint32_t line,
           Diagnostics& diagnostics)
    : present_(true),
      line_(line),
      layout_(&layout),
      deck_(&deck),
      block_(&block),
      diagnostics_(&diagnostics),
      raw_(raw) {
  if (raw_.size() > max_line) {
    raw_ = raw_.substr(0, max_line);
    diagnostics.error(deck.file(block.file).path, line,
                      "the line is longer than " + std::to_string(max_line) + " characters; break it or remove it");
  }
  free_format_ = is_free_format();
}

bool Card::is_free_format() const {
  const auto& fields = layout_->fields;
  if (fields.empty() || raw_.find(',') == std::string_view::npos) return false;
  const bool ends_in_text = fields.back().type == FieldType::text;
  if (ends_in_text && fields.size() == 1) return false;
  const Cell last = locate(*layout_, block_->format, fields.size() - 1);
  const std::size_t end = ends_in_text ? last.column : last.column + last.width;
  bool found = false;
  for_each_comma(raw_, [&](std::size_t, std::size_t column) {
    found = column < end;
    return false;
  });
  return found;
}

std::string_view Card::fixed_text(const Cell& cell) const {
  if (raw_.find('\t') == std::string_view::npos)
    return cell.column < raw_.size() ? raw_.substr(cell.column, cell.width) : std::string_view{};
  std::size_t column = 0, begin = raw_.size(), end = raw_.size();
  for (std::size_t i = 0; i < raw_.size(); ++i) {
    if (column >= cell.column) begin = std::min(begin, i);
    if (column >= cell.column + cell.width) {
      end = i;
      break;
    }
    column = next_column(raw_[i], column);
  }
  return raw_.substr(begin, end - begin);
}

std::string_view Card::free_text(std::size_t field) const {
  const std::size_t slot = locate(*layout_, block_->format, field).slot;
  const bool takes_the_rest = field + 1 == layout_->fields.size() && layout_->fields[field].type == FieldType::text;
  std::size_t commas = 0, begin = slot == 0 ? 0 : raw_.size(), end = raw_.size();
  for_each_comma(raw_, [&](std::size_t i, std::size_t) {
    if (++commas == slot) begin = i + 1;
    if (commas == slot + 1 && !takes_the_rest) end = i;
    return commas <= slot;
  });
  return raw_.substr(begin, end - begin);
}

std::string_view Card::raw_text(std::size_t field) const {
  if (!present_ || field == CardLayout::npos || field >= layout_->fields.size()) return {};
  return trimmed(free_format_ ? free_text(field) : fixed_text(locate(*layout_, block_->format, field)));
}

void Card::report(std::size_t field, const std::string& problem) const {
  const std::uint64_t bit = std::uint64_t{1} << (field % 64);
  if ((reported_ & bit) != 0) return;
  reported_ |= bit;
  diagnostics_->error(deck_->file(block_->file).path, line_,
                      "*" + block_->name + ", field " + layout_->fields[field].name + ": " + problem);
}

/// With what is likely meant and the line, if blanks are the cause.
void Card::report_not_a_number(std::size_t field, std::string_view raw, const std::string& problem) const {
  const Cell at = cell(field);
  const NumberField number{raw_, raw, field, size(), at.column, at.width, free_format_};
  const std::string cause = about_blanks(number);
  if (cause.empty()) return report(field, problem);
  const std::uint64_t bit = std::uint64_t{1} << (field % 64);
  if ((reported_ & bit) != 0) return;
  reported_ |= bit;
  const bool zero = only_zeros(raw);
  diagnostics_->add(
      {zero ? Severity::warning : Severity::error, deck_->file(block_->file).path, line_,
       "*" + block_->name + ", field " + layout_->fields[field].name + ": " + cause + (zero ? "; read as 0" : ""),
       marked_line(number)});
}

void report_missing_parameter(std::string_view name, const std::string& file, std::uint32_t line,
                              const std::string& where, Diagnostics& diagnostics) {
  diagnostics.error_of_cause(
      "the parameter " + quoted(name) + " is not defined before it is used",
      "define it with *PARAMETER, or give it with --param " + std::string(name.substr(0, 80)) + "=VALUE", file, line,
      where);
}

void Card::report_missing(std::size_t field, std::string_view name) const {
  const std::uint64_t bit = std::uint64_t{1} << (field % 64);
  if ((reported_ & bit) != 0) return;
  reported_ |= bit;
  report_missing_parameter(name, deck_->file(block_->file).path, line_,
                           "*" + block_->name + ", field " + layout_->fields[field].name, *diagnostics_);
}

/// The value of an expression; nothing (and a report) if it has none.
std::optional<ParameterValue> Card::evaluated(std::size_t field, std::string_view expression) const {
  Parameters::Missing missing;
  const auto value = deck_->parameters().evaluate(expression, block_->scope, block_->order, &missing);
  if (value) return value.value();
  if (missing.name.empty())
    report_not_a_number(field, expression, value.error().message);
  else if (!missing.told)
    report_missing(field, missing.name);
  return std::nullopt;
}

/// A warning if an expression fills its fixed columns and the line goes on: what is behind them is not part of it.
void Card::warn_if_cut(std::size_t field, std::string_view raw) const {
  if (free_format_ || raw_.find('\t') != std::string_view::npos) return;
  const Cell cell = locate(*layout_, block_->format, field);
  const std::size_t end = cell.column + cell.width;
  if (end >= raw_.size() || raw_[end - 1] == ' ' ||
      std::string_view("0123456789.*/()eE").find(raw_[end]) == std::string_view::npos)
    return;
  diagnostics_->warning(deck_->file(block_->file).path, line_,
                        "*" + block_->name + ", field " + layout_->fields[field].name + ": the expression " +
                            quoted(raw) + " fills its " + std::to_string(cell.width) +
                            " columns, and the line goes on; if it is cut off, define it with *PARAMETER_EXPRESSION");
}

/// The value of `&name`, `-&name`, `<expression>` or an expression with parameters; nothing (and a report) if it has
/// none.
std::optional<ParameterValue> Card::substituted(std::size_t field, std::string_view raw) const {
  if (raw.front() == '<') {
    if (raw.back() == '>' && raw.size() > 2) return evaluated(field, raw.substr(1, raw.size() - 2));
    report(field, quoted(raw) + " lacks the closing \">\"");
    return std::nullopt;
  }
  const bool negative = raw.starts_with("-&");
  const bool reference = negative || raw.starts_with('&');
  const auto name = reference ? trimmed(raw.substr(negative ? 2 : 1)) : std::string_view{};
  const ParameterValue* value = deck_->parameters().find(name, block_->scope, block_->order);
  if (value == nullptr && (!reference || !is_plain_name(name))) {
    warn_if_cut(field, raw);
    return evaluated(field, raw);
  }
  if (value == nullptr) {
    report_missing(field, name);
    return std::nullopt;
  }
  if (Parameters::is_unknown(*value)) return std::nullopt;
  if (std::holds_alternative<std::string>(*value)) {
    report(field, "the parameter " + quoted(name) + " is a text, and a number is needed; define it as type R or I");
    return std::nullopt;
  }
  if (!negative) return *value;
  if (const auto* integer = std::get_if<std::int64_t>(value))
    return *integer == std::numeric_limits<std::int64_t>::min() ? *integer : -*integer;
  return -std::get<double>(*value);
}

namespace {

/// Products and sums of decimals miss whole numbers by rounding: 100 * 0.07 is 7.000000000000001.
std::optional<std::int64_t> whole(double value) {
  constexpr double rounding = 1e-9;
  const double nearest = std::round(value);
  if (!(std::abs(value - nearest) <= rounding) || std::abs(value) > 9.0e15) return std::nullopt;
  return static_cast<std::int64_t>(nearest);
}

}  // namespace

bool Card::blank(std::size_t field) const { return raw_text(field).empty(); }

std::int64_t Card::integer(std::size_t field, std::int64_t default_value) const {
  const auto raw = raw_text(field);
  if (raw.empty()) return default_value;
  std::optional<std::int64_t> value;
  if (is_parameter_reference(raw)) {
    const auto found = substituted(field, raw);
    if (!found) return default_value;
    const auto* real = std::get_if<double>(&*found);
    value = real != nullptr ? whole(*real) : std::get<std::int64_t>(*found);
  } else {
    value = parse_integer(raw);
  }
  if (!value) {
    report_not_a_number(field, raw, quoted(raw) + " is not a whole number of at most 18 digits; correct the field");
    return only_zeros(raw) ? 0 : default_value;
  }
  if (*value == 0) return 0;
  const std::int64_t offset =
      deck_->transform(block_->transform).offset[static_cast<std::size_t>(layout_->fields[field].id)];
  std::int64_t shifted = 0;
  // Some fields give an id with a minus sign as a switch: the id after it is shifted.
  if (*value > 0 ? __builtin_add_overflow(*value, offset, &shifted)
                 : __builtin_sub_overflow(*value, offset, &shifted)) {
    report(field, quoted(raw) + " is too large an id for the offset of its include");
    return default_value;
  }
  return shifted;
}

double Card::real(std::size_t field, double default_value) const {
  const auto raw = raw_text(field);
  if (raw.empty()) return default_value;
  std::optional<double> value;
  if (is_parameter_reference(raw)) {
    const auto found = substituted(field, raw);
    if (!found) return default_value;
    const auto* integer = std::get_if<std::int64_t>(&*found);
    value = integer != nullptr ? static_cast<double>(*integer) : std::get<double>(*found);
  } else {
    value = parse_real(raw);
  }
  if (!value || std::abs(*value) > max_real) {
    report_not_a_number(field, raw,
                        quoted(raw) + (value ? " is larger than 1e30" : " is not a number") + "; correct the field");
    return only_zeros(raw) ? 0 : default_value;
  }
  return *value;
}

std::string_view Card::text(std::size_t field) const {
  const auto raw = raw_text(field);
  if (raw.size() < 2 || raw.front() != '&') return raw;
  // Headings may start with a literal ampersand: only a text parameter of that name counts.
  const ParameterValue* value = deck_->parameters().find(trimmed(raw.substr(1)), block_->scope, block_->order);
  const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return text != nullptr ? std::string_view(*text) : raw;
}

CardReader::CardReader(const Deck& deck, const Block& block, Diagnostics& diagnostics)
    : deck_(&deck),
      block_(&block),
      diagnostics_(&diagnostics),
      rest_(block.body),
      line_(block.line),
      next_line_(block.line + 1) {
  advance();
}

void CardReader::advance() {
  if (!end_) last_line_ = line_;
  while (!rest_.empty()) {
    const auto end = rest_.find('\n');
    current_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    current_ = without_returns(current_);
    line_ = next_line_++;
    if (!current_.starts_with('$')) return;
  }
  current_ = {};
  line_ = next_line_;
  end_ = true;
}

bool CardReader::at_end() const { return end_; }
std::string_view CardReader::peek() const { return current_; }
std::uint32_t CardReader::peek_line() const { return line_; }

Card CardReader::peek(const CardLayout& layout) const {
  if (!end_) return {*deck_, *block_, layout, current_, line_, *diagnostics_};
  Card none;
  none.line_ = line_;
  none.layout_ = &layout;
  return none;
}

Card CardReader::next(const CardLayout& layout) {
  Card card = peek(layout);
  advance();
  return card;
}

void CardReader::skip() { advance(); }

const std::string& CardReader::file() const { return deck_->file(block_->file).path; }

}  // namespace gapcheck::keyword
