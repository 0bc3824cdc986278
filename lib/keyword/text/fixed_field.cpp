#include "keyword/text/fixed_field.hpp"

namespace gapcheck::keyword {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr int max_whole_power = 19;

/// 10^0 … 10^19, all that fit into 64 bits.
struct WholePowers {
  std::uint64_t of_ten[max_whole_power + 1] = {1};
  constexpr WholePowers() {
    for (int i = 1; i <= max_whole_power; ++i) of_ten[i] = 10 * of_ten[i - 1];
  }
};
constexpr WholePowers whole_powers;

double power_of_two(int exponent) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52); }

/// A product is exact in 128 bits. The top 64 of these decide; the rest only says whether it is nonzero.
double product(std::uint64_t mantissa, std::uint64_t factor) {
  const Wide exact = Wide{mantissa} * factor;
  const auto high = static_cast<std::uint64_t>(exact >> 64);
  if (high == 0) return static_cast<double>(static_cast<std::uint64_t>(exact));
  const int shift = 64 - std::countl_zero(high);
  const bool rest = (exact & ((Wide{1} << shift) - 1)) != 0;
  return static_cast<double>(static_cast<std::uint64_t>(exact >> shift) | static_cast<std::uint64_t>(rest)) *
         power_of_two(shift);
}

/// Both are shifted to the top, so that the whole quotient has 63 or 64 bits: far more than a double keeps, so the
/// remainder only has to say whether it is nonzero.
double quotient(std::uint64_t mantissa, std::uint64_t divisor) {
  const int up = std::countl_zero(mantissa), divisor_up = std::countl_zero(divisor);
  const Wide dividend = Wide{mantissa << up} << 63;
  divisor <<= divisor_up;
  const auto whole = static_cast<std::uint64_t>(dividend / divisor);
  const bool rest = Wide{whole} * divisor != dividend;
  return static_cast<double>(whole | static_cast<std::uint64_t>(rest)) * power_of_two(divisor_up - up - 63);
}

}  // namespace

bool scaled_exactly(std::uint64_t mantissa, int exponent, double& value) {
  if (exponent < -max_whole_power || exponent > max_whole_power) return false;
  if (mantissa == 0)
    value = 0;
  else
    value = exponent < 0 ? quotient(mantissa, whole_powers.of_ten[-exponent])
                         : product(mantissa, whole_powers.of_ten[exponent]);
  return true;
}

#ifdef __SSE2__

bool fixed_field::read_long_real(const char* point, unsigned whole, const char* end, unsigned fraction, int exponent,
                                 double& value) {
  if (whole + fraction == 0 || whole > 16 || fraction > 16 || whole + fraction > max_whole_power) return false;
  const std::uint64_t mantissa =
      sixteen_digits(point, whole, 16) * whole_powers.of_ten[fraction] + sixteen_digits(end, fraction, 16);
  return scaled(mantissa, exponent - static_cast<int>(fraction), value);
}

#endif

}  // namespace gapcheck::keyword
