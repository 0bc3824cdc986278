#include "base/system/terminal.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace gapcheck::system {

void prepare_standard_streams() {
  // A closed standard output would otherwise become the first file that is opened. A folder cannot be written, by
  // the name /dev/stdout neither.
  for (const int fd : {standard_input, standard_output, standard_error})
    if (::fcntl(fd, F_GETFD) == -1)
      static_cast<void>(fd == standard_error ? ::open("/dev/null", O_WRONLY) : ::open("/", O_RDONLY));
}

bool is_terminal(int descriptor) { return ::isatty(descriptor) != 0; }

bool obeys_escapes(int descriptor) {
  const char* terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  return is_terminal(descriptor) && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

std::size_t columns_of(int descriptor) {
  winsize size{};
  return is_terminal(descriptor) && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace gapcheck::system
