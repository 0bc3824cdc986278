#include "model/entity/loads.hpp"

#include <fstream>

#include "model/read.hpp"

namespace gapcheck::model::loads_test {
namespace {

TEST(Loads, ConcentratedLoads) {
  const Read read = read_text(
      "*LOAD_NODE_SET\n"
      "         2         1         4       2.5         6         0         0         0\n\n"
      "         3         5         4\n"
      "*LOAD_NODE_POINT\n7,4,4,1.,0,1,2,3\n*LOAD_RIGID_BODY\n8,3,9\n");
  const auto& loads = read.model.loads.concentrated;
  ASSERT_EQ(loads.size(), 4u) << read.text();
  EXPECT_TRUE(loads[0].nodes.set);
  EXPECT_EQ(loads[0].nodes.id, 2);
  EXPECT_EQ(loads[0].keyword, "LOAD_NODE_SET");
  EXPECT_EQ(loads[2].keyword, "LOAD_NODE_POINT");
  EXPECT_EQ(loads[3].keyword, "LOAD_RIGID_BODY");
  EXPECT_EQ(loads[0].freedom, 1);
  EXPECT_EQ(loads[0].curve, 4);
  EXPECT_EQ(loads[0].scale, 2.5);
  EXPECT_EQ(loads[0].system, 6);
  EXPECT_EQ(loads[1].freedom, 5);
  EXPECT_EQ(loads[1].scale, 1);
  EXPECT_FALSE(loads[2].nodes.set);
  EXPECT_EQ(loads[2].nodes.id, 7);
  EXPECT_TRUE(loads[3].rigid);
  EXPECT_EQ(loads[3].part, 8);
}

TEST(Loads, Pressures) {
  const Read read = read_text(
      "*LOAD_SEGMENT_ID\n1,a\n4,2.,0.5,1,2,3,4\n2,b\n4,1.,0.,1,2,3,0,5\n6,7,8\n3,c\n4,1.,0.,1,2,3\n"
      "*LOAD_SEGMENT_SET\n         9         4       3.0       0.1\n"
      "*LOAD_SHELL_ELEMENT\n11,4\n*LOAD_SHELL_SET_ID\n1,d\n12,4\n");
  const auto& loads = read.model.loads.pressures;
  ASSERT_EQ(loads.size(), 6u) << read.text();
  EXPECT_EQ(loads[0].nodes, (std::array<std::int64_t, 4>{1, 2, 3, 4}));
  EXPECT_EQ(loads[0].keyword, "LOAD_SEGMENT_ID");
  EXPECT_EQ(loads[3].keyword, "LOAD_SEGMENT_SET");
  EXPECT_EQ(loads[4].keyword, "LOAD_SHELL_ELEMENT");
  EXPECT_EQ(loads[0].scale, 2);
  EXPECT_EQ(loads[0].arrival, 0.5);
  EXPECT_EQ(loads[1].nodes[3], 0);
  EXPECT_EQ(loads[2].curve, 4);
  EXPECT_EQ(loads[3].kind, PressureLoad::Kind::segment_set);
  EXPECT_EQ(loads[3].id, 9);
  EXPECT_EQ(loads[3].arrival, 0.1);
  EXPECT_EQ(loads[4].kind, PressureLoad::Kind::shell);
  EXPECT_EQ(loads[4].id, 11);
  EXPECT_EQ(loads[5].kind, PressureLoad::Kind::shell_set);
  EXPECT_EQ(loads[5].id, 12);
}

TEST(Loads, BodyLoadsAndDamping) {
  const Read read = read_text(
      "*LOAD_BODY_Z\n5,9.81\n*LOAD_BODY_X\n6\n*LOAD_BODY_PARTS\n3\n"
      "*DAMPING_GLOBAL\n0,2.\n*DAMPING_GLOBAL\n7,0.,0.,1.,0.5\n");
  const Loads& loads = read.model.loads;
  ASSERT_EQ(loads.bodies.size(), 2u) << read.text();
  EXPECT_EQ(loads.bodies[0].keyword, "LOAD_BODY_Z");
  EXPECT_EQ(loads.bodies[0].axis, 2);
  EXPECT_EQ(loads.bodies[0].scale, 9.81);
  EXPECT_EQ(loads.bodies[1].axis, 0);
  EXPECT_EQ(loads.bodies[1].curve, 6);
  ASSERT_EQ(loads.body_parts.size(), 1u);
  EXPECT_EQ(loads.body_parts[0].part_set, 3);
  ASSERT_TRUE(loads.damping.has_value());
  EXPECT_EQ(loads.damping->curve, 7);
  EXPECT_EQ(loads.damping->factors, (std::array<double, 6>{0, 1, 0.5, 0, 0, 0}));
}

// Millimetres, tonnes and milliseconds come as metres, kilograms and seconds.
TEST(Loads, UnitsOfIncludes) {
  const std::string path = testing::TempDir() + "loads_include.k";
  std::ofstream(path) << "*LOAD_NODE_POINT\n7,1,4\n7,5,4\n*LOAD_SEGMENT_SET\n9,4,1.,5.\n*LOAD_BODY_X\n4\n"
                         "*DAMPING_GLOBAL\n0,2.\n";
  const Read read = read_text("*INCLUDE_TRANSFORM\n" + path + "\n100,,,,10,1000\n,,\n1000.,0.001,0.001\n\n");
  EXPECT_EQ(read.errors(), 0u) << read.text();
  const Loads& loads = read.model.loads;
  ASSERT_EQ(loads.concentrated.size(), 2u);
  EXPECT_EQ(loads.concentrated[0].nodes.id, 107);
  EXPECT_EQ(loads.concentrated[0].curve, 1004);
  EXPECT_NEAR(loads.concentrated[0].scale, 1e6, 1e-6);
  EXPECT_NEAR(loads.concentrated[1].scale, 1e3, 1e-9);
  EXPECT_EQ(loads.pressures[0].id, 19);
  EXPECT_NEAR(loads.pressures[0].scale, 1e12, 1);
  EXPECT_NEAR(loads.pressures[0].arrival, 0.005, 1e-15);
  EXPECT_NEAR(loads.bodies[0].scale, 1e3, 1e-9);
  EXPECT_NEAR(loads.damping->value, 2e3, 1e-9);
}

TEST(Loads, HourglassAndSteps) {
  const Read read = read_text(
      "*HOURGLASS_TITLE\nfirst\n4,5,0.05,0,1.2,0.03\n*PART\np\n1,1,1,0,4\n*CONTROL_HOURGLASS\n4,0.07\n"
      "*CONTROL_BULK_VISCOSITY\n2.,0.1\n*CONTROL_TIMESTEP\n1e-6,0.5,0,0.,-2e-6,7\n"
      "*CONTROL_TERMINATION\n0.1,500,0.01,5.\n");
  EXPECT_EQ(read.errors(), 0u) << read.text();
  const HourglassControl& control = read.model.hourglass.at(4);
  EXPECT_EQ(control.ihq, 5);
  EXPECT_EQ(control.qm, 0.05);
  EXPECT_EQ(control.q1, 1.2);
  EXPECT_EQ(control.q2, 0.03);
  EXPECT_EQ(read.model.parts[0].hourglass_id, 4);
  const Controls& controls = read.model.controls;
  EXPECT_EQ(controls.ihq, 4);
  EXPECT_EQ(controls.qh, 0.07);
  EXPECT_EQ(controls.bulk_q1, 2);
  EXPECT_EQ(controls.bulk_q2, 0.1);
  EXPECT_EQ(controls.dtinit, 1e-6);
  EXPECT_EQ(controls.dt2ms, -2e-6);
  EXPECT_EQ(controls.lctm, 7);
  EXPECT_EQ(controls.endcyc, 500);
  EXPECT_EQ(controls.dtmin, 0.01);
  EXPECT_EQ(controls.endeng, 5);
}

}  // namespace
}  // namespace gapcheck::model::loads_test
