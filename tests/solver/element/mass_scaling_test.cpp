#include "solver/element/mass_scaling.hpp"

#include <gtest/gtest.h>

#include "solver/structure_of.hpp"

namespace gapcheck::solver::mass_scaling_test {
namespace {

double total_mass(const Structure& structure) {
  double sum = 0;
  for (const double mass : structure.state.mass) sum += mass;
  return sum;
}

double first_step(Structure structure) {
  StepSettings settings;
  settings.time_step_factor = 0.9;
  Stepper stepper(std::move(structure), settings);
  EXPECT_TRUE(stepper.begin_step().ok());
  return stepper.next_step();
}

std::string scaled(const std::string& deck, double dt2ms) {
  return deck + fmt::format("*CONTROL_TIMESTEP\n0.,0.9,0,0.,{}\n", dt2ms);
}

// A row of bricks, the first of them a tenth as long: with DT2MS below zero it alone gets mass, so much that its step
// is TSSFAC |DT2MS|.
TEST(MassScaling, NegativeScalesShortElementsOnly) {
  std::string deck = brick_bar(3, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0, 7);
  for (const std::string corner : {"\n1,0,0,0", "\n5,0,1,0", "\n9,0,0,1", "\n13,0,1,1"}) {
    const std::size_t zero = deck.find(corner) + corner.find(',') + 1;
    deck.replace(zero, 1, "0.9");
  }
  const Structure plain = structure_of(deck);
  const double own = first_step(plain);
  for (const double factor : {2.0, 3.5}) {
    const double target = factor * own / 0.9;
    const Structure heavy = structure_of(scaled(deck, -target));
    EXPECT_NEAR(first_step(heavy), 0.9 * target, 1e-12);
    EXPECT_NEAR(total_mass(heavy), total_mass(plain) + heavy.added_mass, 1e-12);
    EXPECT_GT(heavy.added_mass, 0);
    EXPECT_EQ(heavy.state.mass[3], plain.state.mass[3]);  // of the last brick, which is long enough
  }
  EXPECT_EQ(structure_of(scaled(deck, -own / 0.9 / 2)).added_mass, 0);
}

// DT2MS above zero gives every element the same step: the mass of a regular plate changes by the square.
TEST(MassScaling, PositiveScalesAll) {
  const std::string deck = plate(3, 2, {0.5, 0.4, 0}) + elastic_deck(shell_section, 1000, 0.3, 7);
  const Structure plain = structure_of(deck);
  const double own = first_step(plain);
  for (const double factor : {0.5, 3.0}) {
    const Structure changed = structure_of(scaled(deck, factor * own / 0.9));
    EXPECT_NEAR(total_mass(changed), factor * factor * total_mass(plain), 1e-9 * total_mass(changed));
    EXPECT_NEAR(changed.state.inertia[0], factor * factor * plain.state.inertia[0], 1e-12);
    EXPECT_NEAR(first_step(changed), factor * own, 1e-12);
  }
}

}  // namespace
}  // namespace gapcheck::solver::mass_scaling_test
