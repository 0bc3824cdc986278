#include "common/message_line.hpp"

#include <fmt/format.h>

#include "report/item/describe.hpp"

namespace gapcheck::app {

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
