#pragma once
#include <cstdio>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/result.hpp"

namespace gapcheck::app {

/// Where results go: standard output or a file. Remembers the first failure.
class Output {
 public:
  /// Empty path: standard output.
  explicit Output(std::string path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  /// False from the first failure on.
  bool write(std::string_view text);
  /// Finishes writing; the first failure, if there was any.
  [[nodiscard]] Status close();
  /// Use ANSI colours: a terminal that is not dumb, and NO_COLOR is not set.
  [[nodiscard]] bool color() const;

 private:
  std::string path_;
  std::FILE* file_ = nullptr;
  int error_ = 0;
};

/// "gapcheck: error: FILE:LINE: message" on standard error; empty file and line 0 are left out.
void print(const Diagnostic& diagnostic);

/// All diagnostics, errors first; with `quiet` only the errors.
void print(const Diagnostics& diagnostics, bool quiet);

}  // namespace gapcheck::app
