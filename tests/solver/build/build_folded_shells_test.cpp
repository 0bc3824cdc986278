// NFAIL1, NFAIL4 and PSNFAIL of *CONTROL_SHELL.
#include "solver/build/build_folded_shells.hpp"

#include "solver/run_scene.hpp"

namespace gapcheck::solver::build_folded_shells_test {
namespace {

TEST(FoldedShells, ACornerOf180DegreesOrMoreIsFolded) {
  const std::array<Vector, 4> square{Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)};
  EXPECT_FALSE(is_folded(square));
  for (const double z : {0.0, 0.05})
    for (const auto& [way, folded] :
         {std::pair(0.4, false), {z == 0 ? 0.49 : 0.4, false}, {z == 0 ? 0.51 : 0.6, true}, {0.8, true}}) {
      // One corner moves along the diagonal; at one half it lies between its neighbours.
      std::array<Vector, 4> x = square;
      x[2] -= Vector(way, way, -z * (1 - way));
      EXPECT_EQ(is_folded(x), folded) << way << " " << z;
    }
  EXPECT_FALSE(is_folded({square[0], square[1], square[2], square[2]})) << "triangles never are";
}

/// One shell whose corner 3 is pushed along the diagonal until 0.9 of it.
std::string deck(int elform, const std::string& control) {
  return "*NODE\n1,0.,0.,0.,7,7\n2,1.,0.,0.,7,7\n3,1.,1.,0.,0,7\n4,0.,1.,0.,7,7\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
         "*PART\np\n1,1,1\n" +
         fmt::format("*SECTION_SHELL\n1,{},1.,2\n0.1\n", elform) +
         "*MAT_ELASTIC\n1,1.,1000.,0.3\n*CONTROL_SHELL\n\n\n\n" + control +
         "\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n3,1,2,1,-1.\n3,2,2,1,-1.\n*DEFINE_CURVE\n1\n0.,0.\n1.,0.9\n"
         "*CONTROL_TERMINATION\n1.\n*SET_PART_LIST\n7\n1\n*SET_PART_LIST\n8\n2\n";
}

TEST(FoldedShells, FailEndTheRunOrGoOn) {
  const auto failures = [](const std::string& text) {
    RunScene scene(text);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    return scene.run().stepper().failures();
  };
  EXPECT_TRUE(failures(deck(2, "0,0")).empty());
  EXPECT_TRUE(failures(deck(2, "0,1")).empty()) << "NFAIL4 is for shells with four points";
  EXPECT_TRUE(failures(deck(2, "1,0,8")).empty()) << "another part";
  for (const std::string control : {"1,0", "1,0,7"}) {
    const auto found = failures(deck(2, control));
    ASSERT_EQ(found.size(), 1u) << control;
    EXPECT_NEAR(found[0].time, 0.5 / 0.9, 0.02) << "when it lies between its neighbours";
  }
  EXPECT_EQ(failures(deck(16, "0,1")).size(), 1u);
  for (const std::string& text : {deck(2, "2,0"), deck(16, "0,2"), deck(16, "0,0")}) {
    RunScene scene(text);
    EXPECT_EQ(scene.try_to_go(), RunEnd::failed);
    EXPECT_NE(scene.message().find("shell 1"), std::string::npos) << scene.message();
  }
}

TEST(FoldedShells, WhatIsNotCalculatedIsNamed) {
  EXPECT_NE(failure_of(deck(2, "1,0,9")).message.find("PSNFAIL of *CONTROL_SHELL names part set 9"), std::string::npos);
  const model::Read read = model::read_text(deck(2, "100,0"));
  Diagnostics diagnostics;
  ASSERT_TRUE(build_structure(read.model, {}, diagnostics));
  ASSERT_EQ(diagnostics.sorted().size(), 1u);
  EXPECT_NE(diagnostics.sorted()[0].message.find("NFAIL1 = 100 is calculated as 1"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::build_folded_shells_test
