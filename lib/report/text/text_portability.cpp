#include "report/text/text_portability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/item/describe.hpp"
#include "report/text/paint.hpp"

namespace gapcheck::report {
namespace {

/// "SOFSCL: not read, 3 contacts, first at deck.k:14".
std::string portability_line(const PortabilityNote& note) {
  const bool keyword = note.kind == PortabilityKind::keyword, option = note.kind == PortabilityKind::option;
  std::string line = fmt::format("{}{}: {}, {}",
                                 keyword  ? "*"
                                 : option ? "option "
                                          : "",
                                 printable(note.name), note.other_meaning ? "read, but as something else" : "not read",
                                 count(note.count, "contact"));
  if (!note.file.empty())
    line += fmt::format(", {}{}:{}", note.count > 1 ? "first at " : "at ", printable_path(note.file), note.line);
  return line;
}

}  // namespace

void append_portability(const Report& report, std::size_t limit, std::string& out) {
  if (!report.portability) return;
  const auto& [programs, notes] = *report.portability;
  if (notes.empty()) {
    if (report.contacts.empty())
      out += "\nportability: there are no contacts to compare\n";
    else
      out +=
          fmt::format("\nportability: by its documents, {} reads all keywords, options and fields of these contacts\n",
                      fmt::join(programs, ", "));
    return;
  }
  out += "\nportability: contact input that other programs do not read, according to their documents\n";
  const std::size_t shown = std::min(limit, notes.size());
  for (std::size_t i = 0; i < shown; ++i) {
    if (i == 0 || notes[i].program != notes[i - 1].program) out += fmt::format("  {}\n", notes[i].program);
    out += "    " + portability_line(notes[i]) + '\n';
  }
  if (shown < notes.size()) out += fmt::format("    … and {} more; --all shows them\n", notes.size() - shown);
}

}  // namespace gapcheck::report
