#pragma once
#include <string>
#include <vector>

#include "base/result.hpp"

namespace gapcheck::app {

/// What a path given by the user holds.
struct InputKind {
  bool deck = false;
  std::vector<std::string> files;  ///< of a run: what to read
};

/// A keyword deck has the extension .k, .key or .dyn, or begins with `*` (after comments, `$`). A directory stands for
/// its messag, else its mesNNNN files, else its d3hsp. Every other file is one that the solver wrote. Errors: there is
/// no such file, or a directory without any of these.
Result<InputKind> recognise(const std::string& path);

}  // namespace gapcheck::app
