#include "output.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "common/message_line.hpp"
#include "common/standard_output.hpp"
#include "common/terminal.hpp"

namespace gapcheck::app {

Output::Output(const std::string& path) {
  if (path.empty()) return;
  if (auto file = FileWriter::create(path))
    file_.emplace(std::move(file).value());
  else
    status_ = file.error();
}

bool Output::write(std::string_view text) {
  if (!status_.ok()) return false;
  if (file_) return file_->write(text);
  status_ = write_to_standard_output(text);
  return status_.ok();
}

Status Output::close() {
  if (status_.ok() && file_) status_ = file_->commit();
  return status_;
}

bool Output::color() const {
  const char* no_color = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  return !file_ && status_.ok() && obeys_escapes(STDOUT_FILENO) && (no_color == nullptr || *no_color == '\0');
}

std::size_t Output::width() const {
  winsize size{};
  if (file_ || !status_.ok() || ::isatty(STDOUT_FILENO) == 0) return 0;
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

void print(const Diagnostic& diagnostic) { std::fputs(line_of("gapcheck", diagnostic).c_str(), stderr); }

void print(const Diagnostics& diagnostics, bool quiet) { print(diagnostics.sorted(), diagnostics.dropped(), quiet); }

void print(std::span<const Diagnostic> diagnostics, std::size_t more, bool quiet) {
  for (const Diagnostic& diagnostic : diagnostics)
    if (!quiet || diagnostic.severity == Severity::error) print(diagnostic);
  if (more > 0) std::fputs(fmt::format("gapcheck: … and {} more messages\n", more).c_str(), stderr);
}

}  // namespace gapcheck::app
