#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace gapcheck::results {

/// Takes the next word or number off the front of `text`; empty at its end. Numbers that run together, as in
/// `-1.0E+00-2.0E+00`, are separated; an exponent without letter (`1.5000-345`) has three digits and stays whole.
std::string_view take_token(std::string_view& text);

/// Takes one token off the front and reads it. Nothing: no token, or not a number (`********`).
std::optional<double> take_real(std::string_view& text);
std::optional<std::int64_t> take_integer(std::string_view& text);

}  // namespace gapcheck::results
