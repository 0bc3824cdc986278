#include "common/message_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/item/describe.hpp"

namespace gapcheck::app {

std::string line_of(std::string_view program, const Diagnostic& diagnostic) {
  std::string line = fmt::format("{}: {}: ", program, report::name(diagnostic.severity));
  if (!diagnostic.file.empty()) {
    line += report::printable_path(diagnostic.file);
    if (diagnostic.line != 0) line += fmt::format(":{}", diagnostic.line);
    line += ": ";
  }
  line += report::printable(diagnostic.message) + '\n';
  // Indented, so that no line of a deck begins one of the output.
  for (std::string_view rest = diagnostic.excerpt; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    line += "    " + report::printable(rest.substr(0, end)) + '\n';
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return line;
}

}  // namespace gapcheck::app
