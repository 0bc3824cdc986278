#include "results/text/printed_number.hpp"

#include <charconv>
#include <cmath>

#include "base/number.hpp"

namespace gapcheck::results {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == ','; }

std::size_t digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// Where the exponent that may start at `at` ends; `at` if there is none.
std::size_t exponent_end(std::string_view text, std::size_t at, bool has_point) {
  if (at >= text.size()) return at;
  const char c = text[at];
  if (c == 'E' || c == 'e' || c == 'D' || c == 'd') {
    const std::size_t sign = at + 1 < text.size() && is_sign(text[at + 1]) ? at + 2 : at + 1;
    const std::size_t end = digits(text, sign);
    if (end == sign) return at;
    // In 1.0E+002.0 the last digit belongs to the next number.
    return end < text.size() && text[end] == '.' && end > sign + 1 ? end - 1 : end;
  }
  if (!is_sign(c) || !has_point) return at;
  const std::size_t end = digits(text, at + 1);
  const bool next_number = end < text.size() && text[end] == '.';
  return end == at + 4 && !next_number ? end : at;
}

/// Where the number at the front of the text ends; 0 if there is none.
std::size_t number_end(std::string_view text) {
  const std::size_t begin = !text.empty() && is_sign(text[0]) ? 1 : 0;
  std::size_t at = digits(text, begin);
  std::size_t count = at - begin;
  const bool has_point = at < text.size() && text[at] == '.';
  if (has_point) {
    const std::size_t fraction = digits(text, at + 1);
    count += fraction - at - 1;
    at = fraction;
  }
  return count == 0 ? 0 : exponent_end(text, at, has_point);
}

}  // namespace

std::string_view take_token(std::string_view& text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  std::size_t end = number_end(text);
  const bool number = end > 0 && (end == text.size() || is_blank(text[end]) || is_sign(text[end]) ||
                                  is_digit(text[end]) || text[end] == '.');
  if (!number)
    for (end = 0; end < text.size() && !is_blank(text[end]);) ++end;
  const std::string_view token = text.substr(0, end);
  text.remove_prefix(end);
  return token;
}

std::optional<double> take_real(std::string_view& text) {
  const std::string_view token = take_token(text);
  // Nearly all numbers are in C's form, and a file may have many millions of them.
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error == std::errc{} && end == token.data() + token.size() && std::isfinite(value)) return value;
  return parse_real(token);
}

std::optional<std::int64_t> take_integer(std::string_view& text) { return parse_integer(take_token(text)); }

}  // namespace gapcheck::results
