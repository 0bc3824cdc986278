// One scene for every penalty contact that is calculated: a plate thrown on a plate, normals towards one another.
#include <gtest/gtest.h>

#include <string>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::contact_types_test {
namespace {

enum class Way : std::uint8_t { one, two, single };

struct Type {
  const char* code;
  const char* keyword;
  Way way;
  double distance;  ///< of the mid-surfaces when they touch
};

/// n x n shells of a part, the nodes from part · 1000 on; `up`: where the normals point.
std::string sheet(int part, int n, double size, double offset, double z, bool up) {
  std::string text = "*NODE\n";
  const int first = part * 1000;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      text += fmt::format("{},{},{},{}\n", first + i + j * (n + 1), offset + size * i / n, offset + size * j / n, z);
  text += "*ELEMENT_SHELL\n";
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = first + i + j * (n + 1), b = a + 1, c = a + n + 2, d = a + n + 1;
      text += fmt::format("{},{},{},{},{},{}\n", a, part, a, up ? b : d, c, up ? d : b);
    }
  return text + fmt::format("*PART\nsheet\n{},1,1\n", part);
}

class ContactTypes : public testing::TestWithParam<Type> {};

TEST_P(ContactTypes, ThrowTheUpperPlateBack) {
  const Type& type = GetParam();
  constexpr double speed = 0.5;
  RunSettings settings;
  settings.until = 0.4;
  // Upper plate: part 2, side A.
  RunScene scene(
      sheet(1, 3, 1, 0, 0, true) + sheet(2, 3, 0.8, 0.1, type.distance + 0.01, false) +
          "*SECTION_SHELL\n1,2\n0.04\n*MAT_ELASTIC\n1,1.,1000.,0.3\n*CONTROL_TERMINATION\n1.\n" +
          fmt::format("*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.,{}\n0.,0.,0.,0.,0.,1.\n", -speed) +
          "*SET_PART_LIST\n1\n1,2\n*CONTACT_" + type.keyword +
          (type.way == Way::single ? "\n1,0,2\n0.\n1.,1.\n0\n0.,0,0,1\n" : "\n2,1,3,3\n0.\n1.,1.\n0\n0.,0,0,1\n"),
      settings);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const Vector momentum = scene.momentum();
  const auto upper = [&](NodeIndex node) { return scene.read().model.mesh.nodes.id[node.value] >= 2000; };
  bool of_upper = false, of_lower = false;
  double greatest = 0, first = -1, impulse = 0;
  scene.go([&](const solver::Run& run) {
    ASSERT_EQ(run.contacts().size(), 1u);
    const ContactState& state = run.contacts()[0].state();
    Vector on_upper = Vector::Zero(), all = Vector::Zero();
    const Forces& external = run.stepper().external();
    for (std::uint32_t i = 0; i < external.force.size(); ++i) {
      all += external.force[i];
      if (upper(NodeIndex{i})) on_upper += external.force[i];
    }
    ASSERT_LE(all.norm(), 1e-12 * (1 + on_upper.norm())) << "opposite";
    ASSERT_GE(on_upper.z(), 0);
    if (type.way == Way::single) {
      ASSERT_EQ(state.force_a, Vector::Zero());
    } else {
      ASSERT_LE((state.force_a - on_upper).norm(), 1e-12 * (1 + on_upper.norm()));
      ASSERT_LE((state.force_a + state.force_b).norm(), 1e-12 * (1 + on_upper.norm()));
    }
    for (const ContactNode& node : run.contacts()[0].nodes()) (upper(node.node) ? of_upper : of_lower) = true;
    if (on_upper.z() > 0 && first < 0) first = run.stepper().state().time;
    greatest = std::max(greatest, on_upper.z());
    impulse += on_upper.z() * run.stepper().next_step();
  });
  EXPECT_TRUE(of_upper);
  EXPECT_EQ(of_lower, type.way != Way::one) << "nodes of SURFB are tracked two-way only";
  EXPECT_NEAR(first, 0.01 / speed, 0.01) << "at the right distance";
  // Upper plate: mass 0.64 x 0.04. It gives the lower one (0.04) some of its momentum.
  EXPECT_GT(impulse, 0.5 * 0.64 * 0.04 * speed);
  EXPECT_LT((scene.momentum() - momentum).norm(), 1e-12 * momentum.norm());
  EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(All, ContactTypes,
                         testing::Values(Type{"t3", "SURFACE_TO_SURFACE", Way::two, 0},
                                         Type{"a3", "AUTOMATIC_SURFACE_TO_SURFACE", Way::two, 0.04},
                                         Type{"t4", "SINGLE_SURFACE", Way::single, 0.04},
                                         Type{"t5", "NODES_TO_SURFACE", Way::one, 0},
                                         Type{"a5", "AUTOMATIC_NODES_TO_SURFACE", Way::one, 0.04},
                                         Type{"t10", "ONE_WAY_SURFACE_TO_SURFACE", Way::one, 0},
                                         Type{"a10", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", Way::one, 0.04},
                                         Type{"t13", "AUTOMATIC_SINGLE_SURFACE", Way::single, 0.04},
                                         Type{"a13", "AIRBAG_SINGLE_SURFACE", Way::single, 0.04},
                                         Type{"m3", "FORMING_SURFACE_TO_SURFACE", Way::two, 0.04},
                                         Type{"a3_mortar", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", Way::two, 0.04},
                                         Type{"t13_mortar", "AUTOMATIC_SINGLE_SURFACE_MORTAR", Way::single, 0.04},
                                         Type{"m3_mortar", "FORMING_SURFACE_TO_SURFACE_MORTAR", Way::two, 0.04},
                                         Type{"m5", "FORMING_NODES_TO_SURFACE", Way::one, 0.04},
                                         Type{"m10", "FORMING_ONE_WAY_SURFACE_TO_SURFACE", Way::one, 0.04}),
                         [](const auto& one) { return std::string(one.param.code); });

// No free edge of the upper plate meets one of the lower plate, which it falls through.
TEST(ContactTypesEdges, EdgeOnlyHoldsNoNodesOffSegments) {
  for (const char* keyword : {"AUTOMATIC_GENERAL", "AUTOMATIC_GENERAL_EDGEONLY"}) {
    RunSettings settings;
    settings.until = 0.2;
    RunScene scene(sheet(1, 3, 1, 0, 0, true) + sheet(2, 3, 0.8, 0.1, 0.05, false) +
                       "*SECTION_SHELL\n1,2\n0.04\n*MAT_ELASTIC\n1,1.,1000.,0.3\n*CONTROL_TERMINATION\n1.\n"
                       "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.,-0.5\n0.,0.,0.,0.,0.,1.\n"
                       "*SET_PART_LIST\n1\n1,2\n*CONTACT_" +
                       keyword + "\n1,0,2\n0.\n1.,1.\n",
                   settings);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double greatest = 0;
    scene.go([&](const solver::Run& run) {
      for (const Vector& force : run.stepper().external().force) greatest = std::max(greatest, force.norm());
    });
    EXPECT_EQ(greatest == 0, std::string(keyword).ends_with("EDGEONLY")) << keyword << greatest;
  }
}

}  // namespace
}  // namespace gapcheck::solver::contact_types_test
