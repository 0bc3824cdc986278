#pragma once

namespace gapcheck::report {

/// The longest text that these functions write: a sign, seven digits, a point and eight digits.
inline constexpr int short_decimal_room = 17;

/// Writes the shortest text that reads back as `value`, if it has at most eight decimals and is below ten million, as
/// most numbers of decks are; the same text as fmt's "{}", in a fraction of its time. Returns the end of the text, or
/// nullptr if `value` is not such a number (then nothing is written).
///
/// Of all texts with up to 15 digits at most one reads back as a given double, so one that does is the shortest.
[[nodiscard]] char* write_short_decimal(double value, char* out);

/// Writes six digits of `value` as fmt's "{:.6g}" does, if it lies between 1e-4 and 1e5 and is not so near to the
/// middle of two such texts that a product rounded once could be on the wrong side. Returns the end of the text, or
/// nullptr where that is left to fmt (then nothing is written).
[[nodiscard]] char* write_six_digits(double value, char* out);

}  // namespace gapcheck::report
