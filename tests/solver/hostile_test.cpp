// Decks that make no sense: a clear failure before the first cycle or a clean end, never positions that are not
// numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::hostile_test {
namespace {

/// What a test changes of a deck that makes sense: two shells, one thrown at the other.
struct Cards {
  std::string corner = "5,0.2,0.2,0.11";  ///< a node of the upper shell
  std::string section = "*SECTION_SHELL\n1,2\n0.1\n";
  std::string material = "*MAT_ELASTIC\n1,1.,1000.,0.3\n";
  std::string part = "*PART\nq\n2,1,1\n";
  std::string velocity = "*INITIAL_VELOCITY\n4\n0.,0.,-2.\n";
  std::string end = "*CONTROL_TERMINATION\n0.05\n";
  std::string contact = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n0.\n1.,1.\n";
  std::string more;
  [[nodiscard]] std::string deck() const {
    return "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n" + corner +
           "\n6,0.8,0.2,0.11\n7,0.8,0.8,0.11\n8,0.2,0.8,0.11\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n*PART\np\n1,1,"
           "1\n" +
           part + section + material + "*SET_NODE_LIST\n4\n5,6,7,8\n" + velocity + end + contact + more;
  }
};

enum class Wanted : std::uint8_t {
  refused,  ///< before the first cycle, by an error of the reader or a failure
  stopped,  ///< a failure of the run
  runs,     ///< to its end; with a warning where `says` is not empty
};

struct Hostile {
  const char* name;
  Cards cards;
  Wanted wanted;
  const char* says;  ///< in the failure, or else among the warnings
};

class HostileDeck : public testing::TestWithParam<Hostile> {};

TEST_P(HostileDeck, EndsClearly) {
  const Hostile& hostile = GetParam();
  RunScene scene(hostile.cards.deck());
  const auto end = scene.try_to_go();
  std::string said = scene.message() + "\n" + scene.read().text();
  for (const Diagnostic& d : scene.diagnostics().sorted()) said += d.message + "\n";
  const bool failed = !end || *end == RunEnd::failed;
  switch (hostile.wanted) {
    case Wanted::refused:
      EXPECT_TRUE(!scene.prepared() || scene.read().errors() > 0) << said;
      break;
    case Wanted::stopped:
      EXPECT_TRUE(failed) << said;
      break;
    case Wanted::runs:
      EXPECT_FALSE(failed) << said;
      break;
  }
  EXPECT_NE(said.find(hostile.says), std::string::npos) << said;
  EXPECT_EQ(failed, !scene.message().empty());
  if (failed) return;
  for (const Vector& x : scene.state().x) EXPECT_TRUE(x.allFinite()) << said;
  for (const Vector& v : scene.state().v) EXPECT_TRUE(v.allFinite()) << said;
  EXPECT_TRUE(std::isfinite(scene.energies().total()));
}

Cards with(std::string Cards::*card, const std::string& text) {
  Cards cards;
  cards.*card = text;
  return cards;
}

std::string contact_with(const std::string& card_3, const std::string& sides = "2,1,3,3") {
  return "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + sides + "\n0.\n" + card_3 + "\n";
}

INSTANTIATE_TEST_SUITE_P(
    All, HostileDeck,
    testing::Values(
        Hostile{"nothing_wrong", {}, Wanted::runs, ""},
        Hostile{"zero_density", with(&Cards::material, "*MAT_ELASTIC\n1,0.,1000.,0.3\n"), Wanted::refused,
                "out of range"},
        Hostile{"negative_density", with(&Cards::material, "*MAT_ELASTIC\n1,-1.,1000.,0.3\n"), Wanted::refused,
                "out of range"},
        Hostile{"zero_modulus", with(&Cards::material, "*MAT_ELASTIC\n1,1.,0.,0.3\n"), Wanted::refused, "out of range"},
        Hostile{"poisson_one_half", with(&Cards::material, "*MAT_ELASTIC\n1,1.,1000.,0.5\n"), Wanted::refused,
                "out of range"},
        Hostile{"poisson_two", with(&Cards::material, "*MAT_ELASTIC\n1,1.,1000.,2.\n"), Wanted::refused,
                "out of range"},
        Hostile{"modulus_not_a_number", with(&Cards::material, "*MAT_ELASTIC\n1,1.,nan,0.3\n"), Wanted::refused,
                "is not a number"},
        Hostile{"huge_modulus", with(&Cards::material, "*MAT_ELASTIC\n1,1.,1e300,0.3\n"), Wanted::refused,
                "is larger than 1e30"},
        Hostile{"tiny_density", with(&Cards::material, "*MAT_ELASTIC\n1,1e-300,1000.,0.3\n"), Wanted::stopped,
                "would not come to its end"},
        Hostile{"zero_thickness", with(&Cards::section, "*SECTION_SHELL\n1,2\n0.\n"), Wanted::refused, "thickness"},
        Hostile{"negative_thickness", with(&Cards::section, "*SECTION_SHELL\n1,2\n-0.1\n"), Wanted::refused,
                "thickness"},
        Hostile{"huge_thickness", with(&Cards::section, "*SECTION_SHELL\n1,2\n1e300\n"), Wanted::refused,
                "is larger than 1e30"},
        Hostile{"huge_points", with(&Cards::section, "*SECTION_SHELL\n1,2,0.83,2000000000\n0.1\n"), Wanted::runs,
                "NIP"},
        Hostile{"rule_that_is_missing", with(&Cards::section, "*SECTION_SHELL\n1,2,,,,-7\n0.1\n"), Wanted::refused,
                "rule 7"},
        Hostile{"rule_of_huge_count",
                with(&Cards::section, "*SECTION_SHELL\n1,2,,,,-7\n0.1\n*INTEGRATION_SHELL\n7,2000000000\n0.,1.\n"),
                Wanted::refused, "NIP"},
        Hostile{"rule_not_a_number",
                with(&Cards::section, "*SECTION_SHELL\n1,2,,,,-7\n0.1\n*INTEGRATION_SHELL\n7,1\nnan,1.\n"),
                Wanted::refused, "is not a number"},
        Hostile{"plies_without_thickness",
                with(&Cards::part, "*PART\nq\n2,1,1\n*ELEMENT_SHELL_COMPOSITE\n3,2,1,2,3,4\n1,0.\n"), Wanted::refused,
                "ply of material 1"},
        Hostile{"no_section", with(&Cards::section, ""), Wanted::refused, "section"},
        Hostile{"no_material", with(&Cards::material, ""), Wanted::refused, "material"},
        Hostile{"no_part", with(&Cards::part, ""), Wanted::refused, "part 2"},
        Hostile{"coordinate_not_a_number", with(&Cards::corner, "5,nan,0.2,0.11"), Wanted::refused, "is not a number"},
        Hostile{"coordinate_infinite", with(&Cards::corner, "5,inf,0.2,0.11"), Wanted::refused, "is not a number"},
        Hostile{"coordinate_huge", with(&Cards::corner, "5,1e300,0.2,0.11"), Wanted::refused, "is larger than 1e30"},
        Hostile{"corners_on_one_point", with(&Cards::corner, "5,0.8,0.2,0.11"), Wanted::runs, ""},
        Hostile{"velocity_not_a_number", with(&Cards::velocity, "*INITIAL_VELOCITY\n4\n0.,0.,nan\n"), Wanted::refused,
                "is not a number"},
        Hostile{"velocity_huge", with(&Cards::velocity, "*INITIAL_VELOCITY\n4\n0.,0.,-1e300\n"), Wanted::refused,
                "is larger than 1e30"},
        Hostile{"slsfac_negative", with(&Cards::more, "*CONTROL_CONTACT\n-0.1,0.\n"), Wanted::refused, "SLSFAC"},
        Hostile{"slsfac_huge", with(&Cards::more, "*CONTROL_CONTACT\n1e300,0.\n"), Wanted::refused,
                "is larger than 1e30"},
        Hostile{"sfs_huge", with(&Cards::contact, contact_with("1e200,1e200")), Wanted::refused, "is larger than 1e30"},
        Hostile{"sfs_negative", with(&Cards::contact, contact_with("-1.,-1.")), Wanted::refused, "SFSA"},
        Hostile{"sst_huge", with(&Cards::contact, contact_with("1.,1.,1e300,1e300")), Wanted::refused,
                "is larger than 1e30"},
        Hostile{"friction_not_a_number",
                with(&Cards::contact, "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\nnan,nan\n1.,1.\n"),
                Wanted::refused, "is not a number"},
        Hostile{"contact_without_surface", with(&Cards::contact, contact_with("1.,1.", "99,98,3,3")), Wanted::runs,
                "contact 1 does nothing"},
        Hostile{"contact_of_missing_sets", with(&Cards::contact, contact_with("1.,1.", "99,98,2,4")), Wanted::runs,
                "contact 1 does nothing"},
        Hostile{"contact_with_itself", with(&Cards::contact, contact_with("1.,1.", "2,2,3,3")), Wanted::runs, ""},
        Hostile{"contact_without_cards", with(&Cards::contact, "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n"),
                Wanted::refused, "card 1"},
        Hostile{"end_zero", with(&Cards::end, "*CONTROL_TERMINATION\n0.\n"), Wanted::refused, "ENDTIM"},
        Hostile{"end_negative", with(&Cards::end, "*CONTROL_TERMINATION\n-1.\n"), Wanted::refused, "ENDTIM"},
        Hostile{"end_not_a_number", with(&Cards::end, "*CONTROL_TERMINATION\nnan\n"), Wanted::refused,
                "is not a number"},
        Hostile{"end_huge", with(&Cards::end, "*CONTROL_TERMINATION\n1e300\n"), Wanted::refused, "is larger than 1e30"},
        Hostile{"tssfac_zero", with(&Cards::more, "*CONTROL_TIMESTEP\n0.,0.\n"), Wanted::runs, ""},
        Hostile{"tssfac_negative", with(&Cards::more, "*CONTROL_TIMESTEP\n0.,-1.\n"), Wanted::refused, "TSSFAC"},
        Hostile{"tssfac_not_a_number", with(&Cards::more, "*CONTROL_TIMESTEP\n0.,nan\n"), Wanted::refused,
                "is not a number"},
        Hostile{"tssfac_tiny", with(&Cards::more, "*CONTROL_TIMESTEP\n0.,1e-300\n"), Wanted::stopped,
                "would not come to its end"},
        Hostile{"held_and_moved",
                with(&Cards::more,
                     "*BOUNDARY_SPC_NODE\n5,0,0,0,1\n*DEFINE_CURVE\n1\n0.,0.\n1.,1.\n"
                     "*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,3,0,1\n"),
                Wanted::refused, "node 5"},
        Hostile{"load_not_a_number",
                with(&Cards::more, "*DEFINE_CURVE\n1\n0.,nan\n1.,nan\n*LOAD_NODE_POINT\n5,3,1,1.\n"), Wanted::refused,
                "is not a number"},
        Hostile{"load_huge", with(&Cards::more, "*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*LOAD_NODE_POINT\n5,3,1,1e300\n"),
                Wanted::refused, "is larger than 1e30"},
        Hostile{"relaxation_of_no_cycles", with(&Cards::more, "*CONTROL_DYNAMIC_RELAXATION\n-250,,,,,,,1\n"),
                Wanted::refused, "NRCYCK"},
        Hostile{"relaxation_without_loss", with(&Cards::more, "*CONTROL_DYNAMIC_RELAXATION\n,,1.,,,,,1\n"),
                Wanted::refused, "DRFCTR"},
        Hostile{"relaxation_tolerance_huge", with(&Cards::more, "*CONTROL_DYNAMIC_RELAXATION\n,1e10,,,,,,1\n"),
                Wanted::refused, "DRTOL"},
        Hostile{"relaxation_not_a_number", with(&Cards::more, "*CONTROL_DYNAMIC_RELAXATION\n,,,nan,,,,1\n"),
                Wanted::refused, "is not a number"},
        Hostile{"relaxation_of_tiny_steps", with(&Cards::more, "*CONTROL_DYNAMIC_RELAXATION\n,,,1.,1e-300,,,1\n"),
                Wanted::stopped, "would not come to its end"},
        Hostile{"relaxation_of_nothing", with(&Cards::more, "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,1\n"), Wanted::runs,
                ""},
        Hostile{"mass_negative", with(&Cards::more, "*ELEMENT_MASS\n1,5,-100.\n"), Wanted::refused, "mass 1"},
        Hostile{"mass_not_a_number", with(&Cards::more, "*ELEMENT_MASS\n1,5,nan\n"), Wanted::refused,
                "is not a number"},
        Hostile{"damping_negative", with(&Cards::more, "*DAMPING_GLOBAL\n0,-1e6\n"), Wanted::stopped, "at time"},
        Hostile{"equation_of_nothing", with(&Cards::more, "*CONSTRAINED_LINEAR_GLOBAL\n7\n"), Wanted::refused,
                "constraint 7"},
        Hostile{"equation_not_a_number", with(&Cards::more, "*CONSTRAINED_LINEAR_GLOBAL\n7\n5,1,nan\n6,1,1.\n"),
                Wanted::refused, "is not a number"},
        Hostile{"equation_of_a_missing_node", with(&Cards::more, "*CONSTRAINED_LINEAR_GLOBAL\n7\n99,1,1.\n6,1,1.\n"),
                Wanted::refused, "node 99"},
        Hostile{"local_equation_not_a_number", with(&Cards::more, "*CONSTRAINED_LINEAR_LOCAL\n7\n5,1,0,nan\n"),
                Wanted::refused, "is not a number"},
        Hostile{"local_equation_without_its_system", with(&Cards::more, "*CONSTRAINED_LINEAR_LOCAL\n7\n5,1,99,1.\n"),
                Wanted::refused, "local system 99"},
        Hostile{"joined_set_that_is_missing", with(&Cards::more, "*CONSTRAINED_NODE_SET\n99,7\n"), Wanted::refused,
                "99"},
        Hostile{"relative_damping_of_nothing", with(&Cards::more, "*DAMPING_RELATIVE\n0.1,1.,2\n"), Wanted::refused,
                "PSID"},
        Hostile{"relative_damping_not_a_number", with(&Cards::more, "*DAMPING_RELATIVE\nnan,1.,2,1\n"), Wanted::refused,
                "is not a number"},
        Hostile{"body_load_without_vector",
                with(&Cards::more, "*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*LOAD_BODY_VECTOR\n1,1.\n"), Wanted::refused,
                "vector"},
        Hostile{"damping_huge", with(&Cards::more, "*DAMPING_GLOBAL\n0,1e300\n"), Wanted::refused,
                "is larger than 1e30"}),
    [](const auto& one) { return std::string(one.param.name); });

// Without an end there is no run.
TEST(HostileEnd, ZeroNegativeOrNoNumber) {
  for (const char* end : {"0.", "-1.", "nan"}) {
    RunScene scene(with(&Cards::end, fmt::format("*CONTROL_TERMINATION\n{}\n", end)).deck());
    ASSERT_FALSE(scene.prepared()) << end;
    EXPECT_EQ(scene.status().error().kind, Failure::Kind::no_end) << end;
    EXPECT_NE(scene.message().find("ENDTIM"), std::string::npos);
  }
}

// A contact with SFS = SFM = 0 takes the solver's default of 1, a part against itself finds nothing to do.
TEST(HostileContact, ZeroScaleIsTheDefault) {
  std::array<double, 2> force{};
  for (std::size_t i = 0; i < 2; ++i) {
    RunScene scene(with(&Cards::contact, contact_with(i == 0 ? "0.,0." : "1.,1.")).deck());
    scene.go([&](const solver::Run& run) { force[i] = std::max(force[i], run.contacts()[0].state().force_a.norm()); });
  }
  EXPECT_GT(force[1], 0);
  EXPECT_EQ(force[0], force[1]);
}

TEST(HostileContact, OneElementWithItself) {
  for (const char* type : {"AUTOMATIC_SURFACE_TO_SURFACE\n2,2,3,3\n", "AUTOMATIC_SINGLE_SURFACE\n2,0,3\n"}) {
    RunScene scene(with(&Cards::contact, std::string("*CONTACT_") + type + "0.\n1.,1.\n").deck());
    scene.go([&](const solver::Run& run) { ASSERT_EQ(run.contacts()[0].state().touching, 0u) << type; });
  }
}

}  // namespace
}  // namespace gapcheck::solver::hostile_test
