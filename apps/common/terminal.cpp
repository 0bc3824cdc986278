#include "common/terminal.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace gapcheck::app {

bool obeys_escapes(int descriptor) {
  const char* terminal = std::getenv("TERM");
  return ::isatty(descriptor) != 0 && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

}  // namespace gapcheck::app
