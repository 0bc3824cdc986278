// A node is never behind a segment if another one is nearer, however far behind itself that one looks (contact rules,
// section 3.4): when the contact starts, and in the run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solver/contact_scene.hpp"

namespace gapcheck::solver::nearer_segments_test {
namespace {

/// A segment of 10 x 10, which looks 7 behind itself, and node 9 at 3 below, beside its edge; with a segment of 1 x 1
/// there, above the node, which looks 0.7 behind itself.
std::string beside(bool small_one) {
  return std::string(
             "*NODE\n1,0.,0.,0.\n2,10.,0.,0.\n3,10.,10.,0.\n4,0.,10.,0.\n5,10.,5.,0.\n6,11.,5.,0.\n7,11.,6.,0.\n"
             "8,10.,6.,0.\n9,10.5,5.5,-3.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,5,6,7,8\n*ELEMENT_MASS\n9,9,1.\n"
             "*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n1.\n*MAT_ELASTIC\n1,1e-3,1000.,0.25\n"
             "*SET_NODE_LIST\n1\n9\n*SET_SHELL_LIST\n1\n1") +
         (small_one ? ",2" : "") + "\n*CONTACT_NODES_TO_SURFACE\n1,1,4,1\n\n\n0\n0.,0,0,1\n";
}

TEST(NearerSegments, ANodeUnderASmallSegmentIsNotBehindALargeOne) {
  for (const bool small_one : {false, true}) {
    ContactScene scene(beside(small_one));
    ASSERT_EQ(scene.initial.penetrations.size(), small_one ? 0U : 1U);
    scene.step(3);
    EXPECT_EQ(scene.result().touching, small_one ? 0U : 1U);
    EXPECT_EQ(scene.result().moved, 0U);
  }
}

}  // namespace
}  // namespace gapcheck::solver::nearer_segments_test
