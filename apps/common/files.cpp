#include "common/files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "report/describe.hpp"

namespace gapcheck::app {

std::optional<Diagnostic> write_file(const std::string& path, std::string_view text) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (file != nullptr && std::fclose(file) != 0) written = false;
  if (written) return std::nullopt;
  return Diagnostic{Severity::error, path, 0,
                    fmt::format("cannot be written: {}", std::strerror(errno != 0 ? errno : EIO))};
}

std::string line_of(std::string_view program, const Diagnostic& diagnostic) {
  std::string line = fmt::format("{}: {}: ", program, report::name(diagnostic.severity));
  if (!diagnostic.file.empty()) {
    line += report::printable(diagnostic.file);
    if (diagnostic.line != 0) line += fmt::format(":{}", diagnostic.line);
    line += ": ";
  }
  return line + report::printable(diagnostic.message) + '\n';
}

}  // namespace gapcheck::app
