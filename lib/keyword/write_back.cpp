#include "keyword/write_back.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/number.hpp"
#include "keyword/text/line_ends.hpp"

namespace gapcheck::keyword {
namespace {

/// Digits that distinguish every double from its neighbours.
constexpr int all_digits = 17;

/// `1.5e-05` as `1.5e-5`, `12` as `12.`: forms that deck readers accept, as short as possible.
std::string tidied(std::string text) {
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) {
    if (text.find('.') == std::string::npos) text += '.';
    return text;
  }
  std::size_t digits = exponent + 1;
  if (text[digits] == '+')
    text.erase(digits, 1);
  else
    ++digits;
  while (digits + 1 < text.size() && text[digits] == '0') text.erase(digits, 1);
  return text;
}

std::string in_columns(std::string line, const Cell& cell, const std::string& number) {
  if (line.size() < cell.column) line.resize(cell.column, ' ');
  const std::size_t covered = std::min(cell.width, line.size() - cell.column);
  line.replace(cell.column, covered, std::string(cell.width - number.size(), ' ') + number);
  return line;
}

/// `written` is a view into `line`.
std::string between_commas(const Card& card, std::string_view line, std::size_t field, const std::string& number) {
  const std::string_view written = card.written(field);
  std::string result(line);
  if (!written.empty()) {
    result.replace(static_cast<std::size_t>(written.data() - line.data()), written.size(), number);
    return result;
  }
  // A blank field: after the comma before it, or after commas that are still missing.
  std::size_t at = 0;
  for (std::size_t slot = 0; slot < card.cell(field).slot; ++slot) {
    const std::size_t comma = result.find(',', at);
    if (comma == std::string::npos) {
      result += ',';
      at = result.size();
    } else {
      at = comma + 1;
    }
  }
  return result.insert(at, number);
}

}  // namespace

std::string number_text(double value, std::size_t width) {
  if (!std::isfinite(value)) return "";
  if (value == 0) return width == 1 ? "0" : "0.";
  std::string best;
  double best_error = 0;
  const auto consider = [&](std::string text) {
    text = tidied(std::move(text));
    if (width > 0 && text.size() > width) return;
    const auto read = parse_real(text);
    if (!read) return;
    const double error = std::abs(*read - value);
    if (!best.empty() && (error > best_error || (error == best_error && text.size() >= best.size()))) return;
    best = std::move(text);
    best_error = error;
  };
  consider(fmt::format("{}", value));
  if (!best.empty() && best_error == 0) return best;
  // More digits are nearer: the first of each form that fits is its best.
  const auto consider_form = [&](const auto& form) {
    for (int digits = all_digits; digits >= 0; --digits) {
      std::string text = form(digits);
      if (width > 0 && tidied(text).size() > width) continue;
      return consider(std::move(text));
    }
  };
  consider_form([&](int digits) { return fmt::format("{:.{}e}", value, digits); });
  // Larger ones would not fit any field.
  if (std::abs(value) < 1e20) consider_form([&](int digits) { return fmt::format("{:.{}f}", value, digits); });
  return best;
}

Status check_replaceable(const Card& card, std::size_t field) {
  const std::string_view written = card.written(field);
  if (is_parameter_reference(written)) return plain_error(fmt::format("{} is a parameter", written.substr(0, 80)));
  if (!card.free_format() && card.raw_line().find('\t') != std::string_view::npos)
    return plain_error("the line has tabs in fixed columns");
  if (card.free_format() && written.empty() && card.raw_line().find_first_of("([") != std::string_view::npos)
    return plain_error("the line has commas that do not part fields");
  if (card.raw_line().size() >= Card::max_line) return plain_error("the line is too long");
  return {};
}

std::string with_number(const Card& card, std::size_t field, double value) {
  const std::string_view line = card.raw_line();
  const Cell cell = card.cell(field);
  // A blank before the number is worth a digit, for less strict readers.
  std::string number = number_text(value, card.free_format() ? 0 : cell.width - 1);
  if (number.empty()) number = number_text(value, cell.width);
  return number.empty() ? std::string(line) : with_text(card, field, number);
}

std::string with_text(const Card& card, std::size_t field, std::string_view text) {
  const std::string_view line = card.raw_line();
  if (card.free_format()) return between_commas(card, line, field, std::string(text));
  const Cell cell = card.cell(field);
  return text.size() > cell.width ? std::string(line) : in_columns(std::string(line), cell, std::string(text));
}

std::string card_line(const CardLayout& layout, Format format,
                      std::span<const std::pair<std::string_view, std::string>> fields) {
  std::string line;
  for (const auto& [name, text] : fields)
    line = in_columns(std::move(line), locate(layout, format, layout.index(name)), text);
  return line;
}

LineIndex::LineIndex(std::string_view bytes) : bytes_(bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    starts_.push_back(at);
    const void* newline = std::memchr(bytes.data() + at, '\n', bytes.size() - at);
    if (newline == nullptr) break;
    at = static_cast<std::size_t>(static_cast<const char*>(newline) - bytes.data()) + 1;
  }
}

std::string_view LineIndex::line(std::uint32_t number) const {
  if (number == 0 || number > starts_.size()) return {};
  const std::size_t begin = starts_[number - 1];
  const std::size_t end = number < starts_.size() ? starts_[number] : bytes_.size();
  std::string_view line = bytes_.substr(begin, end - begin);
  if (line.ends_with('\n')) line.remove_suffix(1);
  return without_returns(line);
}

std::string with_lines(std::string_view bytes, const LineIndex& index, std::span<const LineEdit> edits) {
  std::string result;
  result.reserve(bytes.size() + bytes.size() / 16);
  std::size_t copied = 0;
  for (const LineEdit& edit : edits) {
    if (edit.line == 0 || edit.line > index.size()) continue;
    const std::string_view line = index.line(edit.line);
    const auto begin = static_cast<std::size_t>(line.data() - bytes.data());
    result.append(bytes.substr(copied, begin - copied));
    // The last line may have no end: then that of the others.
    const std::string_view behind = bytes.substr(begin + line.size());
    const bool returns = behind.starts_with('\r') || (behind.empty() && bytes.find("\r\n") != std::string_view::npos);
    for (const char c : edit.text) {
      if (c == '\n' && returns) result += '\r';
      result += c;
    }
    copied = begin + line.size();
  }
  result.append(bytes.substr(copied));
  return result;
}

}  // namespace gapcheck::keyword
