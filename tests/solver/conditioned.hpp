#pragma once
#include <memory>
#include <vector>

#include "solver/condition/conditions.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver {

/// A structure with the conditions of its deck.
struct Conditioned {
  Structure structure;
  std::vector<std::unique_ptr<Force>> forces;
  SolverStatus status;
  std::string warnings;  ///< one per line

  /// The stepper that runs it.
  [[nodiscard]] Stepper stepper(StepSettings settings) && {
    Stepper result(std::move(structure), settings);
    for (auto& force : forces) result.add(std::move(force));
    return result;
  }
};

inline Conditioned conditioned(const std::string& deck) {
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  Diagnostics diagnostics;
  auto built = build_structure(read.model, {}, diagnostics);
  Conditioned result;
  if (!built) {
    ADD_FAILURE() << built.error().message;
    return result;
  }
  result.structure = std::move(built).value();
  result.status = apply_conditions(read.model, result.structure, result.forces, diagnostics);
  for (const Diagnostic& d : diagnostics.sorted())
    result.warnings += fmt::format("{}:{}: {}\n", d.file, d.line, d.message);
  return result;
}

/// A structure whose conditions must be good.
inline Conditioned good(const std::string& deck) {
  Conditioned result = conditioned(deck);
  EXPECT_TRUE(result.status.ok()) << result.status.error().message;
  return result;
}

inline StepSettings fixed_step(double step) {
  StepSettings settings;
  settings.greatest_step = step;
  settings.energy_tolerance = 1e-9;
  return settings;
}

/// Runs a number of steps; the test fails where one does.
inline void run(Stepper& stepper, int steps) {
  for (int i = 0; i < steps; ++i) {
    const SolverStatus status = stepper.step();
    ASSERT_TRUE(status.ok()) << status.error().message;
  }
}

/// A rigid box of density 2 with the sides 1, 2 and 3 as part 7 (nodes 11 to 18).
inline const std::string rigid_box =
    "*NODE\n11,0.,0.,0.\n12,1.,0.,0.\n13,1.,2.,0.\n14,0.,2.,0.\n15,0.,0.,3.\n16,1.,0.,3.\n17,1.,2.,3.\n18,0.,2.,3.\n"
    "*ELEMENT_SOLID\n9,7,11,12,13,14,15,16,17,18\n*PART\nbox\n7,7,7\n*SECTION_SOLID\n7,1\n";

inline const std::string rigid_material = "*MAT_RIGID\n7,2.,1000.,0.3\n";

/// A node with a mass of 2 at the origin.
inline const std::string point_mass = "*NODE\n1,0.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n";

}  // namespace gapcheck::solver
