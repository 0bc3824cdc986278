#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "model/read.hpp"
#include "solver/build/build.hpp"
#include "solver/step.hpp"

namespace gapcheck::solver {

/// The structure of a deck; the test fails where it cannot be built.
inline Structure structure_of(const std::string& deck, const BuildSettings& settings = {}) {
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  Diagnostics diagnostics;
  auto built = build_structure(read.model, settings, diagnostics);
  if (!built) {
    ADD_FAILURE() << built.error().message;
    return {};
  }
  return std::move(built).value();
}

inline Failure failure_of(const std::string& deck) {
  const model::Read read = model::read_text(deck);
  Diagnostics diagnostics;
  auto built = build_structure(read.model, {}, diagnostics);
  if (!built) return built.error();
  ADD_FAILURE() << "the structure was built";
  return {};
}

/// Steps until state().time has reached `time`.
inline SolverStatus run_until(Stepper& stepper, double time) {
  while (stepper.state().time < time)
    if (SolverStatus status = stepper.step(); !status.ok()) return status;
  return {};
}

inline std::string elastic_deck(const std::string& section, double young, double poisson, double density) {
  return "*PART\np\n1,1,1\n" + section + fmt::format("*MAT_ELASTIC\n1,{},{},{}\n", density, young, poisson);
}

/// Nodes of a grid, x fastest, from id 1; spacing by axis.
inline std::string grid_nodes(int nx, int ny, int nz, const Vector& spacing) {
  std::string text = "*NODE\n";
  for (int k = 0, id = 1; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i, ++id)
        text += fmt::format("{},{},{},{}\n", id, i * spacing.x(), j * spacing.y(), k * spacing.z());
  return text;
}

/// A bar of nx x 1 x 1 bricks along x; the nodes of station i are 1 + i + (nx + 1) k, k = 0 … 3.
inline std::string brick_bar(int nx, const Vector& spacing) {
  std::string text = grid_nodes(nx, 1, 1, spacing) + "*ELEMENT_SOLID\n";
  const int row = nx + 1, layer = 2 * row;
  for (int i = 1; i <= nx; ++i)
    text += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", i, i, i + 1, i + 1 + row, i + row, i + layer, i + 1 + layer,
                        i + 1 + row + layer, i + row + layer);
  return text;
}

/// A plate of nx x ny quads in z = 0.
inline std::string plate(int nx, int ny, const Vector& spacing) {
  std::string text = grid_nodes(nx, ny, 0, spacing) + "*ELEMENT_SHELL\n";
  for (int j = 0, id = 1; j < ny; ++j)
    for (int i = 1; i <= nx; ++i, ++id) {
      const int a = i + j * (nx + 1);
      text += fmt::format("{},1,{},{},{},{}\n", id, a, a + 1, a + nx + 2, a + nx + 1);
    }
  return text;
}

inline const std::string solid_section = "*SECTION_SOLID\n1,1\n";
inline const std::string shell_section = "*SECTION_SHELL\n1,2,0.8333333333,2\n0.1\n";

}  // namespace gapcheck::solver
