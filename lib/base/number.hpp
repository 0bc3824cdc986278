#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace gapcheck {

/// The text without leading and trailing blanks and tabs.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// A whole number as decks write it: sign, digits; `12.0` and `1.2E1` count as 12 (pre-processors write them).
/// Blank text, a fraction, a number beyond 64 bits: nothing.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

/// A real number as decks and result files write it: C forms plus Fortran's `1.5-3`, `1.0D+2`, `.5`, `5.`; correctly
/// rounded. Blank text, `nan`, `inf`, hexadecimal, overflow to infinity: nothing. Never throws, never allocates.
[[nodiscard]] std::optional<double> parse_real(std::string_view text);

}  // namespace gapcheck
