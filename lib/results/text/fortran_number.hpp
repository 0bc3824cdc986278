#pragma once
#include <string>

namespace gapcheck::results {

// Numbers as Fortran's edit descriptors print them, right-aligned in `width`; an exponent of three digits has no
// letter, numbers that do not fit are stars.

/// 1PEw.d: one digit before the point.
[[nodiscard]] std::string scientific(double value, int width, int decimals);
/// Ew.d: a zero before the point.
[[nodiscard]] std::string normalised(double value, int width, int decimals);

}  // namespace gapcheck::results
