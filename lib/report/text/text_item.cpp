#include "report/text/text_item.hpp"

#include <fmt/format.h>

#include "report/item/describe.hpp"

namespace gapcheck::report {

std::string line_of(const Item& item, std::size_t indent) {
  std::string line = fmt::format("{:{}}{} {}: ", "", indent, printable(item.id), printable(item.rule));
  if (!item.file.empty()) line += printable_path(item.file);
  if (!item.file.empty() && item.line != 0) line += fmt::format(":{}", item.line);
  if (!item.file.empty()) line += ": ";
  if (item.contact != 0) line += fmt::format("contact {}: ", item.contact);
  return line + printable(item.message) + '\n';
}

}  // namespace gapcheck::report
