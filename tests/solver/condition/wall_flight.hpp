#pragma once
#include <memory>
#include <string>
#include <vector>

#include "solver/condition/rigid_walls.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver {

/// A stepper with the walls of a deck; the deck's masses fly with the given velocity.
struct WallFlight {
  Stepper stepper;
  const RigidWalls* walls;
  std::vector<Diagnostic> diagnostics;
  [[nodiscard]] const WallState& wall(std::size_t i = 0) const { return walls->states()[i]; }
};

inline WallFlight fly(const std::string& deck, const Vector& velocity, double step, std::uint8_t held = 0) {
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  const SolverStatus checked = check_walls(read.model);
  EXPECT_TRUE(checked.ok()) << checked.error().message;
  Diagnostics diagnostics;
  Structure structure = build_structure(read.model, {}, diagnostics).value();
  for (Vector& v : structure.state.v) v = velocity;
  for (std::size_t body = 0; body < structure.rigid.size(); ++body)
    structure.rigid.set_motion(body, velocity, Vector::Zero(), structure.state);
  for (std::uint32_t i = 0; i < structure.state.x.size(); ++i) structure.constraints.hold(NodeIndex{i}, held);
  StepSettings settings;
  settings.greatest_step = step;
  auto walls = std::make_unique<RigidWalls>(read.model, structure, diagnostics);
  WallFlight flight{Stepper(std::move(structure), settings), walls.get(), diagnostics.sorted()};
  flight.stepper.add(std::move(walls));
  return flight;
}

inline void run(WallFlight& flight, int steps) {
  for (int i = 0; i < steps; ++i) {
    const SolverStatus status = flight.stepper.step();
    ASSERT_TRUE(status.ok()) << status.error().message;
  }
}

/// A mass of 2 at the given place; node set 1.
inline std::string mass_at(const std::string& place) {
  return "*NODE\n1," + place + "\n*ELEMENT_MASS\n1,1,2.\n*SET_NODE_LIST\n1\n1\n";
}

/// A constant force on all nodes.
class SteadyPush : public Force {
 public:
  explicit SteadyPush(Vector force) : force_(std::move(force)) {}
  void add(State&, Forces& forces) override {
    for (Vector& f : forces.force) f += force_;
  }

 private:
  Vector force_;
};

}  // namespace gapcheck::solver
