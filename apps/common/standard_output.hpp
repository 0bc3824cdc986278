#pragma once
#include <string_view>

#include "base/result.hpp"

namespace gapcheck::app {

/// The text to standard output. The error of a full disk, a closed pipe, a closed descriptor.
[[nodiscard]] Status write_to_standard_output(std::string_view text);

}  // namespace gapcheck::app
