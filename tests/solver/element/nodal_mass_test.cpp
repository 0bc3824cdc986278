#include "solver/element/nodal_mass.hpp"

#include "solver/structure_of.hpp"

namespace gapcheck::solver::nodal_mass_test {
namespace {

// Equal shares of ρ A t and ρ V, of the wanted parts only; elements somewhere in space.
TEST(NodalMasses, SharesOfTheWantedParts) {
  const model::Read read = model::read_text(
      "*NODE\n1,3.,1.,0.\n2,5.,1.,0.\n3,5.,2.,0.\n4,3.,2.,0.\n5,7.,1.,0.\n11,4.,4.,4.\n12,6.,4.,4.\n13,6.,5.,4.\n14,4.,"
      "5.,4."
      "\n15,4.,4.,7.\n16,6.,4.,7.\n17,6.,5.,7.\n18,4.,5.,7.\n21,9.,9.,9.\n22,10.,9.,9.\n23,9.,10.,9.\n24,9.,9.,10.\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,2,5,3,3\n*ELEMENT_SOLID\n1,2,11,12,13,14,15,16,17,18\n"
      "2,2,21,22,23,24,24,24,24,24\n*PART\nq\n2,2,2\n*SECTION_SOLID\n2,1\n*MAT_ELASTIC\n2,3.,1000.,0.3\n" +
      elastic_deck(shell_section, 1000, 0.3, 7));
  ASSERT_EQ(read.errors(), 0u) << read.text();
  const double quad = 7 * 2 * 0.1 / 4, triangle = 7 * 1 * 0.1 / 3, brick = 3 * 6.0 / 8, tetrahedron = 3 / 6.0 / 4;
  const std::vector<double> shells{quad, quad + triangle, quad + triangle, quad, triangle};
  for (const bool of_shells : {true, false})
    for (const bool of_solids : {true, false}) {
      const std::vector<double> masses = nodal_masses(read.model, {of_solids, of_shells});
      ASSERT_EQ(masses.size(), 17u);
      for (std::size_t i = 0; i < 17; ++i) {
        const double solid = i < 5 ? 0 : i < 13 ? brick : tetrahedron;
        EXPECT_NEAR(masses[i], (of_shells && i < 5 ? shells[i] : 0) + (of_solids ? solid : 0), 1e-12) << i;
      }
    }
}

}  // namespace
}  // namespace gapcheck::solver::nodal_mass_test
