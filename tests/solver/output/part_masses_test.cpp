#include "solver/output/part_masses.hpp"

#include <gtest/gtest.h>

#include "solver/output/plot.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::part_masses_test {
namespace {

// Two parts that share an edge; the sum over the parts is that of the nodes.
TEST(PartMasses, SharedNodesAreSharedByMass) {
  const model::Read read = model::read_text(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,3.,0.,0.\n4,0.,1.,0.\n5,1.,1.,0.\n6,3.,1.,0.\n"
      "*ELEMENT_SHELL\n1,1,1,2,5,4\n2,2,2,3,6,5\n" +
      elastic_deck(shell_section, 1000, 0.3, 7) + "*PART\nq\n2,1,2\n*MAT_RIGID\n2,3.,1000.,0.3\n");
  const PartMasses masses(read.model, contact::element_sizes(read.model));
  State state;
  state.v.assign(6, Vector::Zero());
  state.v[1] = {0, 0, 2};
  const auto parts = masses.motion(state);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].mass, 7 * 0.1, 1e-15);
  EXPECT_NEAR(parts[1].mass, 3 * 2 * 0.1, 1e-15);
  EXPECT_NEAR(parts[0].kinetic, 0.7 / 4 / 2 * 4, 1e-15);
  EXPECT_NEAR(parts[1].momentum.z(), 0.6 / 4 * 2, 1e-15);
}

// ρ V / 8 for each corner of a brick, ρ V / 4 of a tetrahedron, ρ A L / 2 of a beam; each element counts, the first
// too.
TEST(PartMasses, SolidsAndBeams) {
  const model::Read read = model::read_text(
      brick_bar(2, {2, 1, 1}) + elastic_deck(solid_section, 1000, 0.3, 6) +
      "*NODE\n101,0.,0.,5.\n102,1.,0.,5.\n103,0.,1.,5.\n104,0.,0.,6.\n105,0.,0.,9.\n*ELEMENT_SOLID\n"
      "9,2,101,102,103,104,104,104,104,104\n*ELEMENT_BEAM\n1,3,104,105\n*PART\nt\n2,1,1\n*PART\nb\n3,3,1\n"
      "*SECTION_BEAM\n3,3\n0.02\n");
  const PartMasses masses(read.model, contact::element_sizes(read.model));
  State state;
  state.v.assign(read.model.mesh.nodes.size(), Vector::Zero());
  state.v[0] = {1, 0, 0};                 // a corner of the first brick
  state.v[1] = {0, 1, 0};                 // of both bricks
  state.v[12] = {0, 0, 1};                // of the tetrahedron
  state.v[15] = state.v[16] = {0, 0, 2};  // the beam, and the top of the tetrahedron
  const auto parts = masses.motion(state);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(parts[0].mass, 6 * 4, 1e-12);
  EXPECT_NEAR((parts[0].momentum - Vector(1.5, 3, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(parts[0].kinetic, 0.5 * 1.5 + 0.5 * 3, 1e-12);
  EXPECT_NEAR(parts[1].mass, 1, 1e-12);
  EXPECT_NEAR(parts[1].momentum.z(), 0.25 * (1 + 2), 1e-12);
  EXPECT_NEAR(parts[2].mass, 6 * 0.02 * 3, 1e-12);
  EXPECT_NEAR(parts[2].kinetic, 0.5 * 0.36 * 4, 1e-12);
}

TEST(PartMasses, HostileElementsCountNothing) {
  const model::Read read =
      model::read_text("*NODE\n1,0.,0.,0.\n2,1e30,0.,0.\n3,1e30,1e30,0.\n*ELEMENT_SHELL\n1,1,1,2,3,3\n2,9,1,2,3,3\n" +
                       elastic_deck("*SECTION_SHELL\n1,2\n1e30\n", 1, 0.3, 1e300));
  const PartMasses masses(read.model, contact::element_sizes(read.model));
  State state;
  state.v.assign(3, Vector::Zero());
  for (const PartMotion& part : masses.motion(state)) EXPECT_EQ(part.kinetic, 0);
}

}  // namespace
}  // namespace gapcheck::solver::part_masses_test
