#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::contact_patch_test {
namespace {

/// A cube of side 1 of n × n × 2 bricks, on the plane z = `start`.
struct Cube {
  int part, n;
  double start;
  [[nodiscard]] int id(int i, int j, int k) const { return 1000 * part + (k * (n + 1) + j) * (n + 1) + i; }

  [[nodiscard]] std::string mesh() const {
    std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
    for (int k = 0; k <= 2; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          nodes +=
              fmt::format("{},{:.17g},{:.17g},{:.17g}\n", id(i, j, k), double(i) / n, double(j) / n, start + 0.5 * k);
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          solids += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", id(i, j, k), part, id(i, j, k), id(i + 1, j, k),
                                id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1),
                                id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1));
    return nodes + solids + fmt::format("*PART\ncube\n{},1,1\n", part);
  }
  /// The faces at the bottom (level 0) or the top (2), with normals outwards.
  [[nodiscard]] std::string faces(int level) const {
    std::string text;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        text += level == 0
                    ? fmt::format("{},{},{},{}\n", id(i, j, 0), id(i, j + 1, 0), id(i + 1, j + 1, 0), id(i + 1, j, 0))
                    : fmt::format("{},{},{},{}\n", id(i, j, 2), id(i + 1, j, 2), id(i + 1, j + 1, 2), id(i, j + 1, 2));
    return text;
  }
};

enum class By { parts, segments, single_surface };

std::string contact(const Cube& lower, const Cube& upper, By by, int soft) {
  if (by == By::single_surface) return fmt::format("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.\n1.,1.\n{}\n", soft);
  if (by == By::parts) return fmt::format("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0.\n1.,1.\n{}\n", soft);
  return "*SET_SEGMENT\n11\n" + lower.faces(2) + "*SET_SEGMENT\n12\n" + upper.faces(0) +
         fmt::format("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n11,12\n0.\n1.,1.\n{}\n", soft);
}

/// Two cubes, one on the other, under a pressure of 1 until they rest: root mean square of σzz + 1 over all bricks, and
/// its largest value. Exact would be 0.
struct Misfit {
  double rms = 0, largest = 0;
};

Misfit press(int below, int above, By by, int soft) {
  const Cube lower{1, below, 0}, upper{2, above, 1};
  std::string held = "*SET_NODE_LIST\n1\n", load = "*LOAD_SEGMENT\n";
  for (int j = 0; j <= below; ++j)
    for (int i = 0; i <= below; ++i) held += fmt::format("{}\n", lower.id(i, j, 0));
  for (int j = 0; j < above; ++j)
    for (int i = 0; i < above; ++i)
      load += fmt::format("1,1.,0.,{},{},{},{}\n", upper.id(i, j, 2), upper.id(i + 1, j, 2), upper.id(i + 1, j + 1, 2),
                          upper.id(i, j + 1, 2));
  RunScene scene(lower.mesh() + upper.mesh() +
                 "*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,1.,1000.,0.\n*DEFINE_CURVE\n1\n0.,0.\n1.,1.\n100.,1.\n" + held +
                 "*BOUNDARY_SPC_SET\n1,0,1,1,1\n" + load + "*DAMPING_GLOBAL\n0,20.\n*CONTROL_TERMINATION\n4.\n" +
                 contact(lower, upper, by, soft));
  EXPECT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const SolidElements& solids = scene.run().stepper().structure().solids;
  Misfit misfit;
  for (std::size_t e = 0; e < solids.size(); ++e) {
    const double wrong = std::abs(solids.point(e).stress[zz] + 1);
    misfit.rms += wrong * wrong / static_cast<double>(solids.size());
    misfit.largest = std::max(misfit.largest, wrong);
  }
  misfit.rms = std::sqrt(misfit.rms);
  return misfit;
}

class ContactPatch : public testing::TestWithParam<By> {};

// Masses, and with them the springs of SOFT = 1 and 2, follow each node's share of the surface.
TEST_P(ContactPatch, SpringsByMassGiveTheStressOfMatchingMeshes) {
  for (const int soft : {1, 2}) EXPECT_LT(press(4, 4, GetParam(), soft).largest, 1e-3) << "SOFT " << soft;
}

TEST_P(ContactPatch, SpringsByMassAreNearTheStressOfOtherMeshes) {
  for (const int soft : {1, 2}) EXPECT_LT(press(4, 6, GetParam(), soft).rms, 0.1) << "SOFT " << soft;
}

// SOFT = 0 gives a node at the edge of the surface the spring of one within it (contact rules, section 6.1), so that it
// takes more than its share. By parts it must be no worse than by the segments that meet.
TEST_P(ContactPatch, SpringsByMaterialFavourTheEdges) {
  EXPECT_NEAR(press(4, 4, GetParam(), 0).rms, 0.186, 0.01);
  EXPECT_NEAR(press(4, 6, GetParam(), 0).rms, 0.316, 0.02);
}

INSTANTIATE_TEST_SUITE_P(All, ContactPatch, testing::Values(By::parts, By::segments, By::single_surface),
                         [](const auto& by) {
                           return by.param == By::parts      ? "parts"
                                  : by.param == By::segments ? "segments"
                                                             : "single_surface";
                         });

}  // namespace
}  // namespace gapcheck::solver::contact_patch_test
