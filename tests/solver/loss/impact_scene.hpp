#pragma once
// Impacts of small bodies: what `start` expects of them, and what their run does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "model/read.hpp"
#include "solver/run_scene.hpp"
#include "solver/start/start.hpp"

namespace gapcheck::solver {

/// What is expected of a deck.
struct Expectation {
  explicit Expectation(const std::string& text) {
    Diagnostics diagnostics;
    auto deck = keyword::read_deck_text("*KEYWORD\n" + text + "*END\n", "scene.k", {}, diagnostics);
    if (!deck) {
      ADD_FAILURE() << deck.error().message;
      return;
    }
    auto model = model::read_model(deck.value(), diagnostics);
    if (!model) {
      ADD_FAILURE() << model.error().message;
      return;
    }
    contact::SurfaceStore surfaces(model.value());
    report = follow_start(deck.value(), model.value(), surfaces, diagnostics).report;
    for (const StartRefusal& refusal : report.refused) refused += refusal.why + "\n";
  }
  [[nodiscard]] const ExpectedContacts& all() const {
    static const ExpectedContacts nothing;
    return report.expected ? *report.expected : nothing;
  }
  /// The worst one.
  [[nodiscard]] ExpectedContact worst() const { return all().contacts.empty() ? ExpectedContact{} : all().contacts[0]; }
  StartReport report;
  std::string refused;
};

/// What the run does.
struct RunImpact {
  double depth = 0;  ///< largest penetration of all nodes that a contact pushes
  /// Largest share of its release depth that any of them has reached.
  double share = 0;
  std::uint64_t released = 0;
  double touched = std::numeric_limits<double>::infinity();  ///< time of the first cycle with a force
  double way_back = 0;                                       ///< velocity of the last node along z at the end
};

inline RunImpact run_impact(const std::string& deck) {
  RunImpact impact;
  RunScene scene(deck);
  EXPECT_TRUE(scene.prepared()) << scene.message();
  if (!scene.prepared()) return impact;
  scene.go([&](const Run& run) {
    impact.way_back = run.stepper().state().v.back().z();
    for (const ContactView& view : run.contacts()) {
      impact.released += view.state().released;
      for (const ContactNode& node : view.nodes()) {
        if (node.kind != ContactNode::Kind::touching) continue;
        impact.touched = std::min(impact.touched, run.stepper().state().time);
        impact.depth = std::max(impact.depth, node.penetration);
        impact.share = std::max(impact.share, node.penetration / node.release_depth);
      }
    }
  });
  return impact;
}

/// A part of n x n shells of `side` at the height z, centred on the axis; node ids from 1000 part + 1 on.
inline std::string shell_sheet(int part, int n, double side, double z) {
  const double from = -n * side / 2;
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", 1000 * part + 1 + j * (n + 1) + i, from + side * i,
                           from + side * j, z);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = 1000 * part + 1 + j * (n + 1) + i;
      shells += fmt::format("{},{},{},{},{},{}\n", 1000 * part + 1 + j * n + i, part, a, a + 1, a + n + 2, a + n + 1);
    }
  return nodes + shells;
}

/// A part of n x n x layers bricks of `side`, its lowest nodes at the height z.
inline std::string brick_block(int part, int n, int layers, double side, double z) {
  const double from = -n * side / 2;
  const int row = n + 1, level = row * row;
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  for (int k = 0; k <= layers; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", 1000 * part + 1 + k * level + j * row + i, from + side * i,
                             from + side * j, z + side * k);
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = 1000 * part + 1 + k * level + j * row + i;
        solids += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", 1000 * part + 1 + (k * n + j) * n + i, part, a, a + 1,
                              a + row + 1, a + row, a + level, a + level + 1, a + level + row + 1, a + level + row);
      }
  return nodes + solids;
}

/// *PART with a section and a material of its own; steel in mm, ms, kg, GPa.
inline std::string shell_part(int part, double thickness, const std::string& material) {
  return fmt::format("*PART\np{0}\n{0},{0},{0}\n*SECTION_SHELL\n{0},2\n{1},{1},{1},{1}\n", part, thickness) + material;
}
inline std::string solid_part(int part, const std::string& material) {
  return fmt::format("*PART\np{0}\n{0},{0},{0}\n*SECTION_SOLID\n{0},1\n", part) + material;
}
/// `held`: CON1 of a rigid material: 7 holds all, 4 all but the motion along z.
inline std::string rigid_steel(int id, int held = 0, double density = 7.85e-6) {
  return fmt::format("*MAT_RIGID\n{},{},210.,0.3\n{},{},{}\n\n", id, density, held == 0 ? 0 : 1, held,
                     held == 0 ? 0 : 7);
}
inline std::string elastic_steel(int id, double density = 7.85e-6) {
  return fmt::format("*MAT_ELASTIC\n{},{},210.,0.3\n", id, density);
}
/// Down, if positive.
inline std::string thrown(int part, double speed) {
  return fmt::format("*INITIAL_VELOCITY_GENERATION\n{},2,0.,0.,0.,{:.17g}\n0.,0.,0.,0.,0.,1.\n", part, -speed);
}
/// `first_step`: DTINIT, for rigid parts alone; 0: none.
inline std::string ends_at(double time, double first_step = 0, double tssfac = 0.9) {
  return fmt::format("*CONTROL_TERMINATION\n{:.12g},\n*CONTROL_TIMESTEP\n{:.12g},{}\n", time, first_step, tssfac);
}

/// The cards of a contact.
struct ImpactContact {
  std::string type = "AUTOMATIC_NODES_TO_SURFACE";
  int a = 2, b = 1;  ///< parts
  double sst = 0, mst = 0;
  int soft = 0;
  double sofscl = 0.1, sfs = 1, vdc = 0, fs = 0;
  [[nodiscard]] std::string text() const {
    const bool single = type == "AUTOMATIC_SINGLE_SURFACE";
    return fmt::format("*CONTACT_{}\n{},{},{},{}\n{},0.,0.,0.,{}\n{},{},{:.17g},{:.17g}\n{},{:.17g}\n", type,
                       single ? 0 : a, single ? 0 : b, single ? 5 : 3, single ? 0 : 3, fs, vdc, sfs, 1., sst, mst, soft,
                       sofscl);
  }
};

}  // namespace gapcheck::solver
