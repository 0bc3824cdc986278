#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/file_writer.hpp"
#include "base/result.hpp"

namespace gapcheck::app {

/// Where results go: standard output or a file, which changes when all of it is written. Remembers the first failure.
class Output {
 public:
  /// Empty path: standard output.
  explicit Output(const std::string& path);
  /// False from the first failure on.
  bool write(std::string_view text);
  /// Finishes writing; the first failure, if there was any.
  [[nodiscard]] Status close();
  /// Use ANSI colours: a terminal that is not dumb, and NO_COLOR is not set.
  [[nodiscard]] bool color() const;
  /// Columns of the terminal; 0: not written to one, or not known.
  [[nodiscard]] std::size_t width() const;

 private:
  std::optional<FileWriter> file_;  ///< none: standard output
  Status status_;
};

/// "gapcheck: error: FILE:LINE: message" on standard error; empty file and line 0 are left out.
void print(const Diagnostic& diagnostic);

/// All diagnostics, errors first; with `quiet` only the errors.
void print(const Diagnostics& diagnostics, bool quiet);
/// The same of a list in that order. `more`: how many are not in it.
void print(std::span<const Diagnostic> diagnostics, std::size_t more, bool quiet);

}  // namespace gapcheck::app
