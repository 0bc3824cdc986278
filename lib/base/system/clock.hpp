#pragma once
#include <ctime>

namespace gapcheck::system {

/// The time of the place, in parts. False: there are none for it.
[[nodiscard]] bool local_time(std::time_t time, std::tm& parts);

}  // namespace gapcheck::system
