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
/// and as many after its first column, whatever these hold; the caller ensures that they are readable. They return
/// false for everything they do not handle, which says nothing about the field. Derivation: docs/theory/reading.md.
/// Processors without SSE2: always false.
inline constexpr std::size_t reach = 32;

/// A number of up to eight digits at the right end of a field of 8 to 24 columns, blanks before it; a blank field is
/// zero.
bool read_fixed_integer(const char* at, std::size_t width, std::int64_t& value);

/// A real number with blanks around it in a field of up to 31 columns; a blank field is zero. Handles up to 16 digits
/// before and after the point, 19 together, and the exponents of C and Fortran (`E+02`, `D2`, `-3`) as long as the
/// result needs no more than 10^±22. Correctly rounded: the same bits as strtod, where the processor rounds to nearest.
bool read_fixed_real(const char* at, std::size_t width, double& value);

/// mantissa · 10^exponent, correctly rounded, by whole numbers of 128 bits. False unless −19 ≤ exponent ≤ 19.
bool scaled_exactly(std::uint64_t mantissa, int exponent, double& value);

// What follows is inline, since it is called for every field of a mesh.

namespace fixed_field {

inline constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                           1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
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

/// mantissa · 10^exponent, correctly rounded; by one operation on exact doubles where that is enough.
inline bool scaled(std::uint64_t mantissa, int exponent, double& value) {
  if (mantissa > max_exact_mantissa || exponent < -max_exact_power || exponent > max_exact_power)
    return scaled_exactly(mantissa, exponent, value);
  const auto exact = static_cast<double>(static_cast<std::int64_t>(mantissa));
  value = exponent < 0 ? exact / powers_of_ten[-exponent] : exact * powers_of_ten[exponent];
  return true;
}

/// A number with `whole` digits before `point` and `fraction` before `end`. False: too many digits, none, or too large
/// a power of ten.
bool read_long_real(const char* point, unsigned whole, const char* end, unsigned fraction, int exponent, double& value);

#ifdef __SSE2__

/// One bit per column: the kind of character there.
struct Kinds {
  std::uint32_t blank = 0, digit = 0, point = 0;
};

inline Kinds kinds_of_sixteen(const char* at) {
  const __m128i text = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
  const __m128i nine = _mm_set1_epi8(9), from_zero = _mm_sub_epi8(text, _mm_set1_epi8('0'));
  const auto bits = [](__m128i match) { return static_cast<std::uint32_t>(_mm_movemask_epi8(match)); };
  return {bits(_mm_cmpeq_epi8(text, _mm_set1_epi8(' '))),
          bits(_mm_cmpeq_epi8(_mm_min_epu8(from_zero, nine), from_zero)),
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

/// The number that the last `count` ≤ 16 digits before `end` spell, with a point before the last `fraction` of them; 16
/// means that there is none. Digits and point together are at most 16 characters.
inline std::uint64_t sixteen_digits(const char* end, unsigned count, unsigned fraction) {
  static constexpr std::uint8_t last_bytes[32] = {0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,
                                                  0,   0,   0,   0,   0,   255, 255, 255, 255, 255, 255,
                                                  255, 255, 255, 255, 255, 255, 255, 255, 255, 255};
  const auto load = [](const void* from) { return _mm_loadu_si128(static_cast<const __m128i*>(from)); };
  const __m128i text = _mm_xor_si128(load(end - 16), _mm_set1_epi8('0'));
  const __m128i behind_point = load(last_bytes + fraction);
  // The digits before the point move up by one place, onto it.
  const __m128i joined =
      _mm_or_si128(_mm_and_si128(behind_point, text), _mm_andnot_si128(behind_point, _mm_slli_si128(text, 1)));
  const __m128i digits = _mm_and_si128(joined, load(last_bytes + count));
  // Ones and tens to hundreds, these to ten thousands, these to two numbers of eight digits.
  const __m128i tens = _mm_mullo_epi16(_mm_and_si128(digits, _mm_set1_epi16(0xFF)), _mm_set1_epi16(10));
  const __m128i pairs = _mm_add_epi16(tens, _mm_srli_epi16(digits, 8));
  const __m128i fours = _mm_madd_epi16(pairs, _mm_set1_epi32(100 | 1 << 16));
  const __m128i eights = _mm_madd_epi16(_mm_packs_epi32(fours, fours), _mm_set1_epi32(10000 | 1 << 16));
  const auto both = static_cast<std::uint64_t>(_mm_cvtsi128_si64(eights));
  return (both & 0xFFFFFFFFu) * 100000000u + (both >> 32);
}

/// The exponent in these columns: `E+02`, `d2`, `-3`. `digit` has a bit for every column that holds a digit.
inline bool read_exponent(const char* at, unsigned begin, unsigned end, std::uint32_t digit, int& exponent) {
  if (end - begin == 4) {  // as most programs write it
    const bool negative = at[begin + 1] == '-', has_sign = negative || at[begin + 1] == '+';
    if ((at[begin] & 0xDE) == 'D' && has_sign && (digit >> (begin + 2) & 3u) == 3u) {
      const int magnitude = 10 * at[begin + 2] + at[begin + 3] - 11 * '0';
      exponent = negative ? -magnitude : magnitude;
      return true;
    }
  }
  const char letter = static_cast<char>(at[begin] | 0x20);
  const bool has_letter = letter == 'e' || letter == 'd';
  const unsigned sign = begin + static_cast<unsigned>(has_letter);
  const bool negative = at[sign] == '-', has_sign = negative || at[sign] == '+';
  const unsigned first = sign + static_cast<unsigned>(has_sign);
  if (!(has_letter || has_sign) || first >= end || end - first > 3) return false;
  if ((~digit & low_bits(end)) >> first != 0) return false;
  const int ones = at[end - 1] - '0', tens = end - first > 1 ? at[end - 2] - '0' : 0;
  const int magnitude = ones + 10 * tens + (end - first > 2 ? 100 * (at[first] - '0') : 0);
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
  if (width >= 32) return false;
  const Kinds kinds = kinds_of(at, width);
  const std::uint32_t used = ~kinds.blank & low_bits(width);
  if (used == 0) {
    value = 0;
    return true;
  }
  auto first = static_cast<unsigned>(std::countr_zero(used));
  const auto last = static_cast<unsigned>(std::bit_width(used));
  const std::uint32_t without_blanks = used >> first;
  if ((without_blanks & (without_blanks + 1)) != 0) return false;  // blanks inside
  const bool negative = at[first] == '-', has_sign = negative || at[first] == '+';
  first += static_cast<unsigned>(has_sign);
  const std::uint32_t others = (used & ~(kinds.digit | kinds.point)) >> first;
  const unsigned length = others == 0 ? last - first : static_cast<unsigned>(std::countr_zero(others));
  const unsigned end = first + length;
  const std::uint32_t points = (kinds.point >> first) & low_bits(length);
  if ((points & (points - 1)) != 0) return false;
  const auto point = static_cast<unsigned>(std::bit_width(points));  // digits before it, and itself
  const unsigned count = length - static_cast<unsigned>(points != 0), fraction = points == 0 ? 0 : length - point;
  int exponent = 0;
  if (end != last && !read_exponent(at, end, last, kinds.digit, exponent)) return false;
  double magnitude = 0;
  if (count == 0 || length > 16) {
    const unsigned whole = count - fraction;
    if (!read_long_real(at + first + whole, whole, at + end, fraction, exponent, magnitude)) return false;
  } else if (!scaled(sixteen_digits(at + end, count, points == 0 ? 16 : fraction),
                     exponent - static_cast<int>(fraction), magnitude)) {
    return false;
  }
  value = negative ? -magnitude : magnitude;
  return true;
}

#else

inline bool read_fixed_integer(const char*, std::size_t, std::int64_t&) { return false; }
inline bool read_fixed_real(const char*, std::size_t, double&) { return false; }

#endif

}  // namespace gapcheck::keyword
