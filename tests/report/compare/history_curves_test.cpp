#include "report/compare/history_curves.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gapcheck::report::history_curves_test {
namespace {

// Each file's curves are named after their entity, and have a value for each state.
TEST(HistoryCurves, NamedAfterTheirEntities) {
  results::RunResults run;
  const Vector zero = Vector::Zero();
  run.secforc.states = {{0, {{3, {1, 2, 2}, zero, zero, 1}}}, {1, {{3, {4, 0, 3}, zero, zero, 1}}}};
  run.spcforc.states = {{0, {{5, true, false, {1, 0, 0}, zero}, {0, true, false, {7, 0, 0}, zero}}}};
  run.bndout.states = {{0, {{results::BoundaryKind::velocity, true, 9, {0, 0, 2}, 8, zero}}}};
  run.rwforc.states = {{0, {{4, 6, {6, 0, 0}}}}};
  results::BodyMotion body;
  body.body = 2;
  body.rotation = {0, 0, 1};
  run.rbdout.states = {{0, {body}}};
  run.swforc.states = {{0, {{results::WeldForce::Kind::beam, 11, 1, 2, false, 0, 0, 0, 0}}}};
  run.elout.states = {{0,
                       {{results::StressKind::beam, 1, 1, {1, 2, 3, 4, 5, 6}, {}, 1},
                        {results::StressKind::shell, 1, 1, {}, {{{1, 2, 3, 4, 5, 6}, 0.5, 0, true}, {}}, 2}}}};
  run.deforc.states = {{0, {{21, false, {3, 0, 4}, -5, 0.25}, {22, true, {0, 0, 6}, 6, 0.5}}}};
  run.abstat.states = {{0, {{41, 1, 2, 3, 4, 5, 6, 7, 8, 9}}}};
  run.jntforc.states = {{0, {{31, false, {0, 3, 4}, {1, 0, 0}}}}};
  run.intfor.surfaces = {{7, 1, "lid"}, {0, 0, "surface 2"}};
  run.intfor.forces = true;
  run.intfor.states = {{0, {{8, {0, 6, 8}}, {9, {}}}}};
  results::GlobalState global;
  global.walls = {{1, 3.5}};
  run.glstat = {global};
  const auto value = [list = curves(run)](const std::string& name) -> double {
    for (const Curve& curve : list)
      if (curve.name == name) return curve.values.back();
    ADD_FAILURE() << name << " is missing";
    return 0;
  };
  EXPECT_EQ(value("secforc section 3 x-force"), 4);
  EXPECT_EQ(value("secforc section 3 resultant force"), 5);
  EXPECT_EQ(value("secforc section 3 z-moment"), 0);
  EXPECT_EQ(value("spcforc node 5 x-force"), 1);
  EXPECT_EQ(value("spcforc all nodes x-force"), 7);
  EXPECT_EQ(value("bndout velocity body 9 z-force"), 2);
  EXPECT_EQ(value("bndout velocity body 9 energy"), 8);
  EXPECT_EQ(value("rwforc wall 4 normal force"), 6);
  EXPECT_EQ(value("rbdout body 2 z-rotation"), 1);
  EXPECT_EQ(value("swforc spotweld beam 11 shear force"), 2);
  EXPECT_EQ(value("elout beam 1 torsion"), 6);
  EXPECT_EQ(value("elout shell 1 point 1 zx-stress"), 6);
  EXPECT_EQ(value("elout shell 1 point 1 plastic strain"), 0.5);
  EXPECT_EQ(value("elout shell 1 point 2 xx-stress"), 0);
  EXPECT_EQ(value("deforc spring 21 resultant force"), -5);
  EXPECT_EQ(value("deforc spring 21 change in length"), 0.25);
  EXPECT_EQ(value("deforc spring 22 z-moment"), 6);
  EXPECT_EQ(value("deforc spring 22 relative rotation"), 0.5);
  EXPECT_EQ(value("abstat airbag 41 volume"), 1);
  EXPECT_EQ(value("abstat airbag 41 pressure"), 2);
  EXPECT_EQ(value("abstat airbag 41 internal energy"), 3);
  EXPECT_EQ(value("abstat airbag 41 flow in"), 4);
  EXPECT_EQ(value("abstat airbag 41 flow out"), 6);
  EXPECT_EQ(value("abstat airbag 41 mass"), 7);
  EXPECT_EQ(value("abstat airbag 41 temperature"), 8);
  EXPECT_EQ(value("jntforc joint 31 resultant force"), 5);
  EXPECT_EQ(value("jntforc joint 31 x-moment"), 1);
  EXPECT_EQ(value("intfor contact 7 side B largest pressure"), 8);
  EXPECT_EQ(value("intfor contact 7 side B resultant force"), 10);
  EXPECT_EQ(value("intfor surface 2 largest pressure"), 9);
  EXPECT_EQ(value("glstat stonewall energy of wall 1"), 3.5);
}

// A support has curves of what it holds, entities keep theirs when others appear or change places.
TEST(HistoryCurves, OfRowsThatComeAndGo) {
  results::RunResults run;
  run.spcforc.states = {{0, {{5, true, false, {1, 0, 0}, {}}}},
                        {1, {{6, true, true, {2, 0, 0}, {3, 0, 0}}, {5, true, true, {4, 0, 0}, {5, 0, 0}}}},
                        {2, {{5, true, false, {6, 0, 0}, {}}, {0, true, false, {7, 0, 0}, {}}}}};
  const std::vector<Curve> list = curves(run);
  EXPECT_EQ(list.size(), 20u);  // forces of 5, 6 and all, moments of 5 and 6
  const auto values = [&](const std::string& name) {
    for (const Curve& curve : list)
      if (curve.name == name) return curve.values;
    return std::vector<double>();
  };
  EXPECT_EQ(values("spcforc node 5 x-force"), (std::vector<double>{1, 4, 6}));
  EXPECT_EQ(values("spcforc node 5 x-moment"), std::vector<double>{5});
  EXPECT_EQ(values("spcforc node 6 resultant moment"), std::vector<double>{3});
  EXPECT_EQ(values("spcforc all nodes x-force"), std::vector<double>{7});
}

}  // namespace
}  // namespace gapcheck::report::history_curves_test
