#pragma once
#include <string>
#include <vector>

#include "base/file_bytes.hpp"
#include "base/result.hpp"

namespace gapcheck::results {

/// The kind of a path given by the user.
struct InputKind {
  bool deck = false;
  bool directory = false;
  std::vector<std::string> files;  ///< of a run: the files to read
};

/// Whether the first line that is neither empty nor a comment of a deck (`$`) is a keyword.
/// Reads on as far as that takes.
[[nodiscard]] bool begins_as_deck(FileBytes& file);

/// A keyword deck has the extension .k, .key or .dyn, or begins with `*` (after comments, `$`). A directory means its
/// messag, else its mesNNNN files, else its d3hsp. Every other file is solver output. Errors: no such file, or a
/// directory without any of these.
[[nodiscard]] Result<InputKind> recognise(const std::string& path);

/// The logs to read where no deck is expected: files as they are, of a directory those that recognise() finds.
[[nodiscard]] Result<std::vector<std::string>> log_files(const std::vector<std::string>& paths);

}  // namespace gapcheck::results
