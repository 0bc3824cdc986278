#include "plates.hpp"

#include <fmt/format.h>

#include <iterator>

namespace gapcheck::bench {
namespace {

constexpr double spacing = 5.0;

struct Writer {
  std::string text;
  int node = 0, element = 0;

  void add_node(double x, double y, double z) {
    fmt::format_to(std::back_inserter(text), "{:8}{:16.8E}{:16.8E}{:16.8E}\n", ++node, x, y, z);
  }
  void add_shell(int part, int a, int b, int c, int d) {
    fmt::format_to(std::back_inserter(text), "{:8}{:8}{:8}{:8}{:8}{:8}\n", ++element, part, a, b, c, d);
  }
};

void add_plate_nodes(Writer& writer, int n, double x, double y, double z) {
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) writer.add_node(x + spacing * i, y + spacing * j, z);
  }
}

void add_plate_shells(Writer& writer, int n, int part, int first_node) {
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = first_node + j * (n + 1) + i;
      writer.add_shell(part, a, a + 1, a + n + 2, a + n + 1);
    }
  }
}

constexpr const char* head = R"(*KEYWORD
*CONTROL_TERMINATION
     0.001
*MAT_ELASTIC
         1  7.85E-09  210000.0       0.3
*SECTION_SHELL
         1         2       1.0         2
       1.0       1.0       1.0       1.0
*PART
lower plate
         1         1         1
*PART
upper plate
         2         1         1
*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID
         1all parts
         0         0         5         0
       0.0
       1.0       1.0
)";

}  // namespace

std::string plates_deck(int n, bool stray) {
  const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  Writer writer;
  writer.text.reserve(220 * cells + 10000);
  writer.text += head;
  if (stray) writer.text += "*PART\nstray shell\n         3         1         1\n";
  writer.text += "*NODE\n";
  add_plate_nodes(writer, n, 0, 0, 0);
  add_plate_nodes(writer, n, 0.3 * spacing, 0.4 * spacing, 0.7);
  const int per_plate = (n + 1) * (n + 1), first_stray = writer.node + 1;
  if (stray) add_plate_nodes(writer, 1, 150000.0, 0, 0);
  writer.text += "*ELEMENT_SHELL\n";
  add_plate_shells(writer, n, 1, 1);
  add_plate_shells(writer, n, 2, 1 + per_plate);
  if (stray) add_plate_shells(writer, 1, 3, first_stray);
  writer.text += "*END\n";
  return std::move(writer.text);
}

}  // namespace gapcheck::bench
