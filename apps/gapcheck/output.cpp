#include "output.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "base/system/terminal.hpp"
#include "common/message_line.hpp"
#include "common/standard_output.hpp"

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
  return !file_ && status_.ok() && system::obeys_escapes(system::standard_output) &&
         (no_color == nullptr || *no_color == '\0');
}

std::size_t Output::width() const { return file_ || !status_.ok() ? 0 : system::columns_of(system::standard_output); }

void print(const Diagnostic& diagnostic) { std::fputs(line_of("gapcheck", diagnostic).c_str(), stderr); }

void print(const Diagnostics& diagnostics, bool quiet) { print(diagnostics.sorted(), diagnostics.dropped(), quiet); }

void print(std::span<const Diagnostic> diagnostics, std::size_t more, bool quiet) {
  for (const Diagnostic& diagnostic : diagnostics)
    if (!quiet || diagnostic.severity == Severity::error) print(diagnostic);
  if (more > 0) std::fputs(fmt::format("gapcheck: … and {} more messages\n", more).c_str(), stderr);
}

}  // namespace gapcheck::app
