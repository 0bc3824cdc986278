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
