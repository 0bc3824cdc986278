#include "base/system/clock.hpp"

namespace gapcheck::system {

bool local_time(std::time_t time, std::tm& parts) { return ::localtime_s(&parts, &time) == 0; }

}  // namespace gapcheck::system
