#pragma once
#include <string>
#include <vector>

#include "base/result.hpp"
#include "model/assumption.hpp"

namespace gapcheck::app {

/// For CLI11: empty, or what is wrong with one value of --as-if.
[[nodiscard]] std::string check_assumption(const std::string& text);

/// What --as-if asks for; `millimetre`: in the deck's unit of length, 0 = not given. Error: the workshop's check
/// without a unit of length.
[[nodiscard]] Result<std::vector<model::Assumption>> assumptions(const std::vector<std::string>& texts,
                                                                 double millimetre);

}  // namespace gapcheck::app
