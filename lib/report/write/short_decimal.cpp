#include "report/write/short_decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gapcheck::report {
namespace {

constexpr std::array<std::uint64_t, 10> powers{1,       10,        100,        1'000,       10'000,
                                               100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};
/// Smaller numbers are shorter with an exponent.
constexpr double without_exponent = 1e-4;

/// digits / 10^places without zeros at its end.
char* write_decimal(bool negative, std::uint64_t digits, int places, char* out) {
  if (negative) *out++ = '-';
  const std::uint64_t unit = powers[static_cast<std::size_t>(places)];
  out = std::to_chars(out, out + short_decimal_room, digits / unit).ptr;
  std::uint64_t decimals = digits % unit;
  if (decimals == 0) return out;
  *out = '.';
  for (int place = places; place > 0; --place, decimals /= 10) out[place] = static_cast<char>('0' + decimals % 10);
  out += 1 + places;
  while (out[-1] == '0') --out;
  return out;
}

}  // namespace

char* write_short_decimal(double value, char* out) {
  constexpr int places = 8;
  constexpr double unit = powers[places];
  // From here on 15 digits would not hold all decimals.
  constexpr double limit = 1e7;
  const double size = std::abs(value);
  // Not a number compares as false.
  if (!(size < limit) || (size < without_exponent && size != 0)) return nullptr;
  // Both the digits and the unit are exact, so their quotient is what a reader makes of the text.
  const auto digits = static_cast<std::uint64_t>(size * unit + 0.5);
  if (static_cast<double>(digits) / unit != size) return nullptr;
  return write_decimal(std::signbit(value), digits, places, out);
}

char* write_six_digits(double value, char* out) {
  constexpr double limit = 1e5, low = 1e5, high = 1e6;
  const double size = std::abs(value);
  if (!(size < limit) || !(size >= without_exponent)) return nullptr;
  std::size_t places = 1;
  while (places + 1 < powers.size() && size * static_cast<double>(powers[places]) < low) ++places;
  const double scaled = size * static_cast<double>(powers[places]);
  const double digits = std::floor(scaled + 0.5);
  // A product is off by up to 2^-53 of itself, 1e-10 here.
  constexpr double doubt = 1e-9;
  if (!(digits >= low && digits < high) || std::abs(scaled - digits) > 0.5 - doubt) return nullptr;
  return write_decimal(std::signbit(value), static_cast<std::uint64_t>(digits), static_cast<int>(places), out);
}

}  // namespace gapcheck::report
