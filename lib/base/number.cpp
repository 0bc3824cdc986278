#include "base/number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace gapcheck {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Plain form accepted by from_chars, using the whole text.
std::optional<double> plain_real(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // from_chars leaves the value unchanged here: too small counts as zero, too large is not a number.
    const auto e = text.find_first_of("eE");
    const bool small = e != std::string_view::npos ? e + 1 < text.size() && text[e + 1] == '-'
                                                   : text.find_first_of("123456789.") == text.find('.');
    return small ? std::optional(0.0) : std::nullopt;
  }
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Without a leading plus; empty if anything but a number follows it.
std::string_view without_plus(std::string_view text) {
  if (text.empty() || text.front() != '+') return text;
  text.remove_prefix(1);
  return !text.empty() && (is_digit(text.front()) || text.front() == '.') ? text : std::string_view();
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  text = without_plus(trimmed(text));
  if (text.empty()) return std::nullopt;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  const auto real = parse_real(text);
  if (!real || *real != std::floor(*real) || std::abs(*real) > 9.0e15) return std::nullopt;
  return static_cast<std::int64_t>(*real);
}

std::optional<double> parse_real(std::string_view text) {
  text = without_plus(trimmed(text));
  if (text.empty()) return std::nullopt;
  const std::string_view unsigned_part = text.front() == '-' ? text.substr(1) : text;
  // Keeps out "nan", "inf" and a second sign.
  if (unsigned_part.empty() || !(is_digit(unsigned_part.front()) || unsigned_part.front() == '.')) return std::nullopt;
  std::array<char, 256> buffer{};
  std::size_t length = 0;
  bool rewritten = false, exponent = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (length + 2 >= buffer.size()) return plain_real(text);
    char c = text[i];
    if (c == 'd' || c == 'D') {
      c = 'e';
      rewritten = true;
    }
    const bool sign = c == '+' || c == '-';
    if (sign && i > 0 && !exponent) {
      buffer[length++] = 'e';
      exponent = rewritten = true;
    }
    if (c == 'e' || c == 'E') exponent = true;
    buffer[length++] = c;
  }
  if (!rewritten) return plain_real(text);
  return plain_real({buffer.data(), length});
}

}  // namespace gapcheck
