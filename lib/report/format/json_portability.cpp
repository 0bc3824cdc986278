#include "report/format/json_portability.hpp"

#include <utility>

namespace gapcheck::report {

void append_portability(const Portability& portability, Buffer& out) {
  out.append(std::string_view(",\n\"portability\":["));
  bool first = true;
  for (const PortabilityNote& note : portability.notes) {
    out.append(std::string_view(std::exchange(first, false) ? "\n  " : ",\n  "));
    Members object(out);
    object.string("program", note.program);
    object.plain("kind", name(note.kind));
    object.string("name", note.name);
    object.plain("use", note.other_meaning ? "other" : "none");
    object.integer("count", note.count);
    if (!note.file.empty()) object.string("file", note.file);
    if (note.line != 0) object.integer("line", note.line);
    object.string("source", note.source);
    object.close();
  }
  out.push_back(']');
}

}  // namespace gapcheck::report
