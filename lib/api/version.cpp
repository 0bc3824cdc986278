#include <gapcheck/version.hpp>

namespace gapcheck::api {

std::string_view version() { return GAPCHECK_VERSION; }

}  // namespace gapcheck::api
