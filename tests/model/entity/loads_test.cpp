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

TEST(Loads, Airbags) {
  const Read read = read_text(
      "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n5,1,0,2.,3.,4.,5.,6.\n7.,0.5,8,9\n"
      "*AIRBAG_SIMPLE_PRESSURE_VOLUME_ID\n77,a tyre\n6\n-7.,0.5\n"
      "*AIRBAG_SIMPLE_AIRBAG_MODEL\n5,0,-2\n700.,980.,300.,4,0.7,-11.,100.,1.2\n12,290.\n"
      "*AIRBAG_SIMPLE_AIRBAG_MODEL_ID\n78\n5\n700.,980.,300.,4,-13.,0.1,100.,1.2\n");
  EXPECT_EQ(read.text(), "");
  const std::vector<Airbag>& all = read.model.airbags;
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].kind, Airbag::Kind::pressure_volume);
  EXPECT_EQ(all[0].keyword, "AIRBAG_SIMPLE_PRESSURE_VOLUME");
  EXPECT_EQ(all[0].place.line, 2u);
  EXPECT_EQ(all[0].id, 1);
  EXPECT_EQ(all[0].set, 5);
  EXPECT_TRUE(all[0].parts);
  EXPECT_EQ(all[0].volume_scale, 2);
  EXPECT_EQ(all[0].pressure_scale, 3);
  EXPECT_EQ(all[0].excluded, 4);
  EXPECT_EQ(all[0].damping, 5);
  EXPECT_EQ(all[0].stagnation, 6);
  EXPECT_EQ(all[0].coefficient, 7);
  EXPECT_EQ(all[0].factor, 0.5);
  EXPECT_EQ(all[0].curve, 8);
  EXPECT_EQ(all[1].id, 77);
  EXPECT_EQ(all[1].title, "a tyre");
  EXPECT_EQ(all[1].coefficient, 0);
  EXPECT_EQ(all[1].coefficient_curve, 7);
  EXPECT_EQ(all[1].volume_scale, 1);
  EXPECT_EQ(all[1].pressure_scale, 1);
  EXPECT_EQ(all[2].kind, Airbag::Kind::simple);
  EXPECT_EQ(all[2].id, 3);
  EXPECT_FALSE(all[2].parts);
  EXPECT_EQ(all[2].sensor, -2);
  EXPECT_EQ(all[2].heat_volume, 700);
  EXPECT_EQ(all[2].heat_pressure, 980);
  EXPECT_EQ(all[2].temperature, 300);
  EXPECT_EQ(all[2].curve, 4);
  EXPECT_EQ(all[2].shape, 0.7);
  EXPECT_EQ(all[2].area, 0);
  EXPECT_EQ(all[2].area_curve, 11);
  EXPECT_EQ(all[2].pressure, 100);
  EXPECT_EQ(all[2].density, 1.2);
  EXPECT_EQ(all[2].exit_curve, 12);
  EXPECT_EQ(all[3].id, 78);
  EXPECT_EQ(all[3].shape_curve, 13);
  EXPECT_EQ(all[3].area, 0.1);
  EXPECT_EQ(all[3].exit_curve, 0);
}

// Of tonnes, millimetres and seconds in a deck of kilograms, metres and seconds.
TEST(Loads, AirbagsOfAnIncludeInOtherUnits) {
  const std::string path = testing::TempDir() + "airbags_include.k";
  std::ofstream(path) << "*AIRBAG_SIMPLE_AIRBAG_MODEL\n5,0,0,1.,1.,1e9\n7e8,9.8e8,300.,4,0.7,-11.,0.1,1.2e-12\n12\n"
                         "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n5\n0.2,1.\n";
  const Read read = read_text("*INCLUDE_TRANSFORM\n" + path + "\n,,,,10,1000\n,,\n1000.,1.,0.001\n\n");
  EXPECT_EQ(read.errors(), 0u) << read.text();
  ASSERT_EQ(read.model.airbags.size(), 2u);
  const Airbag& bag = read.model.airbags[0];
  EXPECT_EQ(bag.set, 15);
  EXPECT_EQ(bag.curve, 1004);
  EXPECT_EQ(bag.area_curve, 1011);
  EXPECT_EQ(bag.exit_curve, 1012);
  EXPECT_NEAR(bag.excluded, 1, 1e-12);
  EXPECT_NEAR(bag.heat_volume, 700, 1e-9);
  EXPECT_NEAR(bag.heat_pressure, 980, 1e-9);
  EXPECT_NEAR(bag.pressure, 1e5, 1e-6);
  EXPECT_NEAR(bag.density, 1.2, 1e-12);
  EXPECT_NEAR(bag.pressure_unit, 1e6, 1e-6);
  EXPECT_NEAR(bag.flow_unit, 1000, 1e-9);
  EXPECT_NEAR(bag.area_unit, 1e-6, 1e-18);
  EXPECT_NEAR(read.model.airbags[1].coefficient, 2e5, 1e-6);
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
