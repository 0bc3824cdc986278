#pragma once
#include <string_view>

namespace gapcheck::api {

/// Version of the library that is linked: "0.1.0". Until 1.0 a new second number may change the interface; the CMake
/// package accepts the same second number only.
[[nodiscard]] std::string_view version();

}  // namespace gapcheck::api
