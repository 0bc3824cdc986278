#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace gapcheck::keyword {

/// Numbers in fixed columns, without a branch per character. Both functions read up to `reach` bytes before the field
/// and as many behind its first column, whatever these hold; the caller sees to it that they can be read. They give
/// false for everything they do not take, which says nothing about the field. Derivation: docs/theory/reading.md.
/// Processors without SSE2: always false.
inline constexpr std::size_t reach = 32;

/// A number of up to eight digits at the right end of a field of 8 to 24 columns, blanks before it; a blank field is
/// zero.
bool read_fixed_integer(const char* at, std::size_t width, std::int64_t& value);

/// A real number with blanks around it in a field of up to 32 columns; a blank field is zero. Takes up to 16 digits
/// before and behind the point, 19 together, and the exponents of C and Fortran (`E+02`, `D2`, `-3`) as long as the
/// result needs no more than 10^±22. Correctly rounded: the same bits as strtod, where the processor rounds to nearest.
bool read_fixed_real(const char* at, std::size_t width, double& value);

/// mantissa · 10^exponent, correctly rounded, by whole numbers of 128 bits; −19 ≤ exponent ≤ 19.
double scaled_exactly(std::uint64_t mantissa, int exponent);

// What follows is inline, since it is called for every field of a mesh.

namespace fixed_field {

inline constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                           1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
inline constexpr std::uint64_t whole_powers_of_ten[] = {1u,
                                                        10u,
                                                        100u,
                                                        1000u,
                                                        10000u,
                                                        100000u,
                                                        1000000u,
                                                        10000000u,
                                                        100000000u,
                                                        1000000000u,
                                                        10000000000u,
                                                        100000000000u,
                                                        1000000000000u,
                                                        10000000000000u,
                                                        100000000000000u,
                                                        1000000000000000u,
                                                        10000000000000000u,
                                                        100000000000000000u,
                                                        1000000000000000000u,
                                                        10000000000000000000u};
inline constexpr std::uint64_t max_exact_mantissa = std::uint64_t{1} << 53;
inline constexpr int max_exact_power = 22;

/// The number of eight decimal digits, one per byte as 0 … 9, the first one in the lowest byte.
inline std::uint64_t eight_digits(std::uint64_t digits) {
  digits = ((digits * (1 + (10u << 8))) >> 8) & 0x00FF00FF00FF00FFu;
  digits = ((digits * (1 + (100u << 16))) >> 16) & 0x0000FFFF0000FFFFu;
  return (digits * (1 + (std::uint64_t{10000} << 32))) >> 32;
}

inline std::uint64_t load_eight(const char* at) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, sizeof bytes);
  return bytes;
}

/// The number that the last `count` ≤ 8 characters before `end` spell, all of them digits.
inline std::uint64_t up_to_eight_digits(const char* end, unsigned count) {
  const unsigned half = 4 * (8 - count);  // of the bits in front of them; all 64 cannot be shifted out at once
  const std::uint64_t wanted = ~std::uint64_t{0} << half << half;
  return eight_digits((load_eight(end - 8) ^ 0x3030303030303030u) & wanted);
}

/// The same for `count` ≤ 16.
inline std::uint64_t up_to_sixteen_digits(const char* end, unsigned count) {
  if (count <= 8) return up_to_eight_digits(end, count);
  return up_to_eight_digits(end - 8, count - 8) * 100000000u + up_to_eight_digits(end, 8);
}

#ifdef __SSE2__

/// One bit per column: what kind of character stands there.
struct Kinds {
  std::uint32_t blank = 0, digit = 0, point = 0;
};

inline Kinds kinds_of_sixteen(const char* at) {
  const __m128i text = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
  const __m128i nine = _mm_set1_epi8(9), from_zero = _mm_sub_epi8(text, _mm_set1_epi8('0'));
  const auto bits = [](__m128i match) { return static_cast<std::uint32_t>(_mm_movemask_epi8(match)); };
  return {bits(_mm_cmpeq_epi8(text, _mm_set1_epi8(' '))), bits(_mm_cmpeq_epi8(_mm_min_epu8(from_zero, nine), from_zero)),
          bits(_mm_cmpeq_epi8(text, _mm_set1_epi8('.')))};
}

inline Kinds kinds_of(const char* at, std::size_t width) {
  Kinds kinds = kinds_of_sixteen(at);
  if (width <= 16) return kinds;
  const Kinds behind = kinds_of_sixteen(at + 16);
  kinds.blank |= behind.blank << 16;
  kinds.digit |= behind.digit << 16;
  kinds.point |= behind.point << 16;
  return kinds;
}

/// Bits 0 … count - 1; count ≤ 32.
inline std::uint32_t low_bits(std::size_t count) { return static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1); }

/// The exponent that the characters from `begin` to `end` spell: `E+02`, `d2`, `-3`. False: not of this form.
inline bool read_exponent(const char* at, unsigned begin, unsigned end, std::uint32_t digit, int& exponent) {
  const char letter = static_cast<char>(at[begin] | 0x20);
  const bool has_letter = letter == 'e' || letter == 'd';
  const unsigned sign = begin + static_cast<unsigned>(has_letter);
  const bool negative = at[sign] == '-', has_sign = negative || at[sign] == '+';
  const unsigned first = sign + static_cast<unsigned>(has_sign);
  if (!(has_letter || has_sign) || first >= end || end - first > 3) return false;
  if ((~digit & low_bits(end)) >> first != 0) return false;
  int magnitude = at[first] - '0';
  for (unsigned i = first + 1; i < end; ++i) magnitude = 10 * magnitude + (at[i] - '0');
  exponent = negative ? -magnitude : magnitude;
  return true;
}

#endif

}  // namespace fixed_field

#ifdef __SSE2__

inline bool read_fixed_integer(const char* at, std::size_t width, std::int64_t& value) {
  if (width < 8 || width > 24) return false;
  constexpr std::uint64_t zeros = 0x3030303030303030u, blanks = 0x2020202020202020u;
  if (width > 8) {
    const __m128i before = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
    const auto others = ~static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(before, _mm_set1_epi8(' '))));
    if ((others & fixed_field::low_bits(width - 8)) != 0) return false;
  }
  const std::uint64_t text = fixed_field::load_eight(at + width - 8);
  if (text == blanks) {
    value = 0;
    return true;
  }
  const unsigned blank_bits = static_cast<unsigned>(std::countr_zero(text ^ blanks)) & ~7u;
  const std::uint64_t in_front = (std::uint64_t{1} << blank_bits) - 1;
  const std::uint64_t number = (text & ~in_front) | (zeros & in_front);
  // A byte below '0' loses its high bit's zero in the difference, one above '9' in the sum.
  if ((((number + 0x4646464646464646u) | (number - zeros)) & 0x8080808080808080u) != 0) return false;
  value = static_cast<std::int64_t>(fixed_field::eight_digits(number ^ zeros));
  return true;
}

inline bool read_fixed_real(const char* at, std::size_t width, double& value) {
  using namespace fixed_field;
  if (width > 32) return false;
  const Kinds kinds = kinds_of(at, width);
  const std::uint32_t used = ~kinds.blank & low_bits(width);
  if (used == 0) {
    value = 0;
    return true;
  }
  auto first = static_cast<unsigned>(std::countr_zero(used));
  const auto last = static_cast<unsigned>(std::bit_width(used));
  if (used != (low_bits(last) & ~low_bits(first))) return false;  // blanks inside
  const bool negative = at[first] == '-', has_sign = negative || at[first] == '+';
  first += static_cast<unsigned>(has_sign);
  const std::uint32_t others = used & ~(kinds.digit | kinds.point) & ~low_bits(first);
  const unsigned end = others == 0 ? last : static_cast<unsigned>(std::countr_zero(others));
  const std::uint32_t points = kinds.point & low_bits(end) & ~low_bits(first);
  if ((points & (points - 1)) != 0) return false;
  const unsigned point = points == 0 ? end : static_cast<unsigned>(std::countr_zero(points));
  const unsigned whole = point - first, fraction = points == 0 ? 0 : end - point - 1;
  if (whole + fraction == 0 || whole > 16 || fraction > 16 || whole + fraction > 19) return false;
  int exponent = 0;
  if (end != last && !read_exponent(at, end, last, kinds.digit, exponent)) return false;
  exponent -= static_cast<int>(fraction);
  const std::uint64_t mantissa = up_to_sixteen_digits(at + point, whole) * whole_powers_of_ten[fraction] +
                                 up_to_sixteen_digits(at + end, fraction);
  double magnitude = 0;
  if (mantissa <= max_exact_mantissa && exponent >= -max_exact_power && exponent <= max_exact_power)
    magnitude = static_cast<double>(static_cast<std::int64_t>(mantissa)) * powers_of_ten[exponent > 0 ? exponent : 0] /
                powers_of_ten[exponent < 0 ? -exponent : 0];
  else if (exponent >= -19 && exponent <= 19)
    magnitude = scaled_exactly(mantissa, exponent);
  else
    return false;
  value = negative ? -magnitude : magnitude;
  return true;
}

#else

inline bool read_fixed_integer(const char*, std::size_t, std::int64_t&) { return false; }
inline bool read_fixed_real(const char*, std::size_t, double&) { return false; }

#endif

}  // namespace gapcheck::keyword
