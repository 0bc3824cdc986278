#pragma once
#include <string>
#include <vector>

namespace gapcheck::api {

/// What a deck is read with. Its include files are found relative to the working directory, beside the main file,
/// beside the including file, in *INCLUDE_PATH and in `directories`, in this order.
struct Includes {
  std::vector<std::string> directories = {};
  bool skip_missing = false;  ///< a missing file is a warning instead of an error
  /// "NAME=VALUE": values of parameters, in place of the deck's.
  std::vector<std::string> parameters = {};
};

}  // namespace gapcheck::api
