#include "common/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "report/item/describe.hpp"

namespace gapcheck::app {

Status write_file(const std::string& path, std::string_view text) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (file != nullptr && std::fclose(file) != 0) written = false;
  if (written) return {};
  return Diagnostic{Severity::error, path, 0,
                    fmt::format("cannot be written: {}", std::strerror(errno != 0 ? errno : EIO))};
}

Status replace_file(const std::string& path, std::string_view text) {
  std::error_code failed;
  // Anything that is not a regular file, such as /dev/stdout, is written and not replaced.
  const auto status = std::filesystem::symlink_status(path, failed);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return write_file(path, text);
  const std::string beside = fmt::format("{}.{}.part", path, ::getpid());
  if (const Status written = write_file(beside, text); !written.ok()) {
    std::filesystem::remove(beside, failed);
    return Diagnostic{Severity::error, path, 0, written.error().message};
  }
  std::filesystem::rename(beside, path, failed);
  if (!failed) return {};
  const std::string why = failed.message();
  std::filesystem::remove(beside, failed);
  return Diagnostic{Severity::error, path, 0, "cannot be written: " + why};
}

std::string line_of(std::string_view program, const Diagnostic& diagnostic) {
  std::string line = fmt::format("{}: {}: ", program, report::name(diagnostic.severity));
  if (!diagnostic.file.empty()) {
    line += report::printable_path(diagnostic.file);
    if (diagnostic.line != 0) line += fmt::format(":{}", diagnostic.line);
    line += ": ";
  }
  return line + report::printable(diagnostic.message) + '\n';
}

}  // namespace gapcheck::app
