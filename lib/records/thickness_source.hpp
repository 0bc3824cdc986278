#pragma once
#include <string_view>

#include "records/penetration.hpp"

namespace gapcheck {

/// The deck's input that gave a thickness, in the manual's words: "SST/MST".
[[nodiscard]] std::string_view thickness_source(ThicknessRule rule);

}  // namespace gapcheck
