#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace gapcheck::audit_test {

/// A flat plate of nx x ny square shells with side 5: part, first node and first element are `id`, `id` * 1000 + 1.
struct Plate {
  int id = 1;
  double z = 0, x = 0, y = 0, thickness = 1;
  int nx = 3, ny = 3;
  [[nodiscard]] std::int64_t node(int i, int j) const { return 1000 * id + 1 + j * (nx + 1) + i; }

  [[nodiscard]] std::string nodes() const {
    std::string text;
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        text += fmt::format("{:8}{:16}{:16}{:16}\n", node(i, j), x + 5.0 * i, y + 5.0 * j, z);
    return text;
  }
  [[nodiscard]] std::string elements() const {
    std::string text;
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        text += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", 1000 * id + 1 + j * nx + i, id, node(i, j), node(i + 1, j),
                            node(i + 1, j + 1), node(i, j + 1));
    return text;
  }
  /// Part with section, mesh.
  [[nodiscard]] std::string deck() const {
    return fmt::format("*PART\nplate\n{:10}{:10}         1\n*SECTION_SHELL\n{:10}         2\n{:10}{:10}{:10}{:10}\n",
                       id, id, id, thickness, thickness, thickness, thickness) +
           "*NODE\n" + nodes() + "*ELEMENT_SHELL\n" + elements();
  }
};

inline const std::string elastic_steel = "*MAT_ELASTIC\n         1   7.85e-9  210000.       0.3\n";
inline const std::string single_surface =
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         1\n         0         0         5\n\n\n";

/// Plates in one single-surface contact.
template <class... Plates>
std::string plates_deck(const Plates&... plates) {
  return "*KEYWORD\n" + elastic_steel + (plates.deck() + ...) + single_surface + "*END\n";
}

}  // namespace gapcheck::audit_test
