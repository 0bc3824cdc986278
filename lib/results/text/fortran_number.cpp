#include "results/text/fortran_number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace gapcheck::results {
namespace {

std::string aligned(const std::string& text, int width) {
  const auto wanted = static_cast<std::size_t>(width);
  return text.size() > wanted ? std::string(wanted, '*') : std::string(wanted - text.size(), ' ') + text;
}

std::string exponent(int value) {
  const char sign = value < 0 ? '-' : '+';
  return std::abs(value) < 100 ? fmt::format("E{}{:02}", sign, std::abs(value))
                               : fmt::format("{}{:03}", sign, std::abs(value));
}

const char* not_finite(double value) { return std::isnan(value) ? "NaN" : value < 0 ? "-Infinity" : "Infinity"; }

/// Sign, digits without point and exponent of the first digit.
struct Parts {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

Parts parts_of(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", std::abs(value), digits - 1);
  const std::size_t letter = text.find('e');
  Parts parts{value < 0, text.substr(0, letter), std::atoi(text.c_str() + letter + 1)};
  if (digits > 1) parts.digits.erase(1, 1);
  return parts;
}

}  // namespace

std::string scientific(double value, int width, int decimals) {
  if (!std::isfinite(value)) return aligned(not_finite(value), width);
  const Parts parts = parts_of(value, decimals + 1);
  return aligned(
      (parts.negative ? "-" : "") + parts.digits.substr(0, 1) + "." + parts.digits.substr(1) + exponent(parts.exponent),
      width);
}

std::string normalised(double value, int width, int decimals) {
  if (!std::isfinite(value)) return aligned(not_finite(value), width);
  const Parts parts = parts_of(value, decimals);
  return aligned((parts.negative ? "-0." : "0.") + parts.digits + exponent(value == 0 ? 0 : parts.exponent + 1), width);
}

}  // namespace gapcheck::results
