#include "output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "common/files.hpp"
#include "common/terminal.hpp"

namespace gapcheck::app {

Output::Output(std::string path) : path_(std::move(path)) {
  file_ = path_.empty() ? stdout : std::fopen(path_.c_str(), "wb");
  if (file_ == nullptr) error_ = errno;
}

Output::~Output() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
}

bool Output::write(std::string_view text) {
  if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), file_) != text.size()) error_ = errno != 0 ? errno : EIO;
  return error_ == 0;
}

Status Output::close() {
  if (error_ == 0 && std::fflush(file_) != 0) error_ = errno;
  if (error_ == 0) return {};
  return Diagnostic{Severity::error, path_.empty() ? "standard output" : path_, 0,
                    fmt::format("cannot be written: {}", std::strerror(error_))};
}

bool Output::color() const {
  const char* no_color = std::getenv("NO_COLOR");
  return file_ == stdout && obeys_escapes(STDOUT_FILENO) && (no_color == nullptr || *no_color == '\0');
}

void print(const Diagnostic& diagnostic) { std::fputs(line_of("gapcheck", diagnostic).c_str(), stderr); }

void print(const Diagnostics& diagnostics, bool quiet) {
  for (const Diagnostic& diagnostic : diagnostics.sorted())
    if (!quiet || diagnostic.severity == Severity::error) print(diagnostic);
  if (const std::size_t more = diagnostics.dropped(); more > 0)
    std::fputs(fmt::format("gapcheck: … and {} more messages\n", more).c_str(), stderr);
}

}  // namespace gapcheck::app
