#pragma once
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "solver/run_scene.hpp"

namespace gapcheck::solver {

/// A block of bricks as a part of its own (section and material given), node ids from 10000 · part.
struct MortarBlock {
  int part = 1;
  std::array<int, 3> n{1, 1, 1};
  Vector origin = Vector::Zero(), size = Vector::Ones();
  double shake = 0;  ///< of the nodes inside a level, in its plane, as a share of the bricks; not on the last level
  int material = 1;

  [[nodiscard]] int id(int i, int j, int k) const { return 10000 * part + (k * (n[1] + 1) + j) * (n[0] + 1) + i; }
  [[nodiscard]] Vector place(int i, int j, int k) const {
    const Vector brick(size.x() / n[0], size.y() / n[1], size.z() / n[2]);
    Vector x = origin + Vector(i * brick.x(), j * brick.y(), k * brick.z());
    const bool inside = i > 0 && j > 0 && i < n[0] && j < n[1] && k < n[2];
    if (inside) x += shake * Vector(brick.x() * std::sin(3.1 * i + 7.7 * j), brick.y() * std::cos(5.3 * i - j), 0);
    return x;
  }
  [[nodiscard]] std::string mesh() const {
    std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i) {
          const Vector x = place(i, j, k);
          nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", id(i, j, k), x.x(), x.y(), x.z());
        }
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
          solids += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", id(i, j, k), part, id(i, j, k), id(i + 1, j, k),
                                id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1),
                                id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1));
    return nodes + solids + fmt::format("*PART\nblock\n{},{},{}\n", part, part + 100, material) +
           fmt::format("*SECTION_SOLID\n{},1\n", part + 100);
  }
  /// The faces at the bottom (first) or top, normals outwards.
  [[nodiscard]] std::string faces(bool top) const {
    std::string text;
    const int k = top ? n[2] : 0;
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        text += top ? fmt::format("{},{},{},{}\n", id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k))
                    : fmt::format("{},{},{},{}\n", id(i, j, k), id(i, j + 1, k), id(i + 1, j + 1, k), id(i + 1, j, k));
    return text;
  }
  /// Ids of the nodes of a level, one per line.
  [[nodiscard]] std::string level(int k) const {
    std::string text;
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) text += fmt::format("{}\n", id(i, j, k));
    return text;
  }
};

/// A sheet of shells as a part of its own, node ids from 10000 · part: a grid from `origin` along two edges.
struct MortarSheet {
  int part = 1;
  int n = 1, m = 1;  ///< shells along the edges
  Vector origin = Vector::Zero(), first = {1, 0, 0}, second = {0, 1, 0};
  double thickness = 0.1;
  int material = 1;

  [[nodiscard]] int id(int i, int j) const { return 10000 * part + j * (n + 1) + i; }
  [[nodiscard]] std::string mesh() const {
    std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) {
        const Vector x = origin + first * i / n + second * j / m;
        nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", id(i, j), x.x(), x.y(), x.z());
      }
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i)
        shells +=
            fmt::format("{},{},{},{},{},{}\n", id(i, j), part, id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
    return nodes + shells + fmt::format("*PART\nsheet\n{},{},{}\n", part, part + 100, material) +
           fmt::format("*SECTION_SHELL\n{0},2\n{1},{1},{1},{1}\n", part + 100, thickness);
  }
};

/// Sums of all forces of a run in this cycle, from the nodes and with their moments.
struct ForceSums {
  Vector force = Vector::Zero(), moment = Vector::Zero();
  double size = 0, arm = 0;

  explicit ForceSums(const solver::Run& run) {
    const Forces& f = run.stepper().external();
    const State& state = run.stepper().state();
    for (std::size_t i = 0; i < f.force.size(); ++i) {
      force += f.force[i];
      moment += state.x[i].cross(f.force[i]) + f.moment[i];
      size += f.force[i].norm();
      arm = std::max(arm, state.x[i].norm());
    }
  }
};

}  // namespace gapcheck::solver
