#pragma once
#include <string_view>

#include "records/report.hpp"

namespace gapcheck::fuzz {

/// Two plates of one shell each that penetrate, and a tie that does not hold.
[[nodiscard]] std::string_view sample_deck();
/// What the audit says about it.
[[nodiscard]] const Report& sample_audit();
/// What the solver's log of such a deck says.
[[nodiscard]] const Report& sample_log();

}  // namespace gapcheck::fuzz
