#pragma once
#include <functional>
#include <string_view>

#include "base/result.hpp"

namespace gapcheck::keyword {

/// The value of an arithmetic expression: + - * / % ** (right to left, before a sign), parentheses, names with or
/// without `&`, `pi`, and the functions sin cos tan csc sec ctn asin acos atan atan2 sinh cosh tanh asinh acosh atanh
/// sqrt abs sign exp log log10 min max mod int aint nint anint float (angles in radians; all arithmetic in double).
/// `value_of` gives the value of a name. Bounded in depth and length; errors say what is wrong: syntax, a name,
/// division by zero, a non-finite value.
Result<double> evaluate_expression(std::string_view text,
                                   const std::function<Result<double>(std::string_view)>& value_of);

}  // namespace gapcheck::keyword
