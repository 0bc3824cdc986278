#include "common/standard_output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace gapcheck::app {

Status write_to_standard_output(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return {};
  return Diagnostic{Severity::error, "standard output", 0,
                    fmt::format("cannot be written: {}", std::generic_category().message(errno != 0 ? errno : EIO))};
}

}  // namespace gapcheck::app
