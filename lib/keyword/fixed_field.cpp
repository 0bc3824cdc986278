#include "keyword/fixed_field.hpp"

#include <cmath>

namespace gapcheck::keyword {
namespace {

__extension__ using Wide = unsigned __int128;

/// The nearest double, ties to even. The top 64 bits hold all that is needed if the rest only says whether it is zero.
double rounded(Wide value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  if (high == 0) return static_cast<double>(static_cast<std::uint64_t>(value));
  const int shift = 64 - std::countl_zero(high);
  const bool rest = (value & ((Wide{1} << shift) - 1)) != 0;
  const std::uint64_t top = static_cast<std::uint64_t>(value >> shift) | static_cast<std::uint64_t>(rest);
  return std::ldexp(static_cast<double>(top), shift);
}

}  // namespace

double scaled_exactly(std::uint64_t mantissa, int exponent) {
  if (mantissa == 0) return 0;
  if (exponent >= 0) return rounded(Wide{mantissa} * fixed_field::whole_powers_of_ten[exponent]);
  const std::uint64_t divisor = fixed_field::whole_powers_of_ten[-exponent];
  const int shift = std::countl_zero(mantissa);
  const Wide dividend = Wide{mantissa << shift} << 64;
  const Wide quotient = dividend / divisor;
  const bool rest = quotient * divisor != dividend;
  return std::ldexp(rounded(quotient | static_cast<Wide>(rest)), -64 - shift);
}

}  // namespace gapcheck::keyword
