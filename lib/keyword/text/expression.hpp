#pragma once
#include <functional>
#include <string_view>

#include "base/result.hpp"

namespace gapcheck::keyword {

/// A number in an expression, and whether its type is integer: digits alone, and parameters of type I.
struct ExpressionNumber {
  double value = 0;
  bool whole = false;
};

/// The value of an arithmetic expression: + - * / % ** (right to left, before a sign), parentheses, names with or
/// without `&`, `pi`, and the functions sin cos tan csc sec ctn asin acos atan atan2 sinh cosh tanh asinh acosh atanh
/// sqrt abs sign exp log log10 min max mod int aint nint anint float (angles in radians; all arithmetic in double).
/// Integers divide as such: 2/5 is 0, 2.0/5 is 0.4 (manual, *PARAMETER_EXPRESSION); a negative power of an integer is
/// real. `value_of` gives the value of a name. Bounded in depth and length; errors say what is wrong: syntax, a name,
/// division by zero, a non-finite value.
Result<double> evaluate_expression(std::string_view text,
                                   const std::function<Result<ExpressionNumber>(std::string_view)>& value_of);

}  // namespace gapcheck::keyword
