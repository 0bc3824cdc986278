#pragma once
#include <string>
#include <vector>

namespace gapcheck::api {

/// How the include files of a deck are found: relative to the working directory, beside the main file, beside the
/// including file, in *INCLUDE_PATH and in `directories`, in this order.
struct Includes {
  std::vector<std::string> directories = {};
  bool skip_missing = false;  ///< a missing file is a warning instead of an error
};

}  // namespace gapcheck::api
