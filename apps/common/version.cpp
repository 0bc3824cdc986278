#include "common/version.hpp"

#include <fmt/format.h>

#include "commit.hpp"

namespace gapcheck::app {

std::string_view version() { return GAPCHECK_VERSION; }

std::string version_line(std::string_view program) {
  return fmt::format("{} {} (commit {}, {}, CGAL {}, {})", program, version(), GAPCHECK_COMMIT, GAPCHECK_COMPILER,
                     GAPCHECK_CGAL_VERSION, GAPCHECK_BUILD_TYPE);
}

}  // namespace gapcheck::app
