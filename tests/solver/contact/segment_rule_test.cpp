// Segment-based contact, SOFT = 2: impacts, what nodes in segments miss, the baseline, and the stiffness.
#include "solver/contact/segment_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "contact/initial.hpp"
#include "keyword/deck.hpp"
#include "solver/contact/contact_pass.hpp"
#include "solver/contact_scene.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::segment_rule_test {
namespace {

const std::string elastic = "*SECTION_SHELL\n1,2\n0.04\n*MAT_ELASTIC\n1,1.,1000.,0.3\n*SET_PART_LIST\n1\n1,2\n";

/// n x m shells of a part in a plane of constant z, the nodes from part · 1000 on.
std::string sheet(int part, int n, const Vector& corner, double size) {
  std::string text = "*NODE\n";
  const int first = part * 1000;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      text += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", first + i + j * (n + 1), corner.x() + size * i / n,
                          corner.y() + size * j / n, corner.z());
  text += "*ELEMENT_SHELL\n";
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = first + i + j * (n + 1);
      text += fmt::format("{},{},{},{},{},{}\n", a, part, a, a + 1, a + n + 2, a + n + 1);
    }
  return text + fmt::format("*PART\nsheet\n{},1,1\n", part);
}

/// `a_card`: SOFT, SOFSCL, LCIDAB, MAXPAR, SBOPT, DEPTH. `more`: cards B to D.
std::string contact_of(const std::string& type, const std::string& a_card = "2", const std::string& more = "") {
  const bool single = type.find("SINGLE") != std::string::npos;
  return "*CONTACT_" + type + (single ? "\n1,0,2\n" : "\n2,1,3,3\n") + "0.\n1.,1.\n" + a_card + "\n" + more;
}

StepSettings steps(double greatest) {
  StepSettings settings;
  settings.greatest_step = greatest;
  settings.energy_tolerance = 0;
  return settings;
}

ContactScene::Prepare down(double speed) {
  return [=](Structure& s) {
    for (std::size_t i = 0; i < s.state.v.size(); ++i)
      if (s.state.x[i].z() > 0.001) s.state.v[i] = {0, 0, -speed};
  };
}

/// Steps on; forces are opposite, without moment, and energy stays.
double run_balanced(ContactScene& scene, double end) {
  double greatest = 0;
  while (scene.state().time < end) {
    if (const SolverStatus status = scene.stepper->begin_step(); !status.ok()) {
      ADD_FAILURE() << status.error().message;
      return greatest;
    }
    const Forces& f = scene.stepper->external();
    Vector sum = Vector::Zero(), moment = Vector::Zero();
    double size = 0;
    for (std::size_t i = 0; i < f.force.size(); ++i) {
      sum += f.force[i];
      moment += scene.state().x[i].cross(f.force[i]);
      size += f.force[i].norm();
    }
    EXPECT_LE(sum.norm(), 1e-12 * size);
    EXPECT_LE(moment.norm(), 1e-11 * size);
    greatest = std::max(greatest, size / 2);
    scene.stepper->end_step();
  }
  return greatest;
}

class SegmentTypes : public testing::TestWithParam<const char*> {};

TEST_P(SegmentTypes, ThrowTheUpperPlateBack) {
  constexpr double speed = 0.5;
  ContactScene scene(sheet(1, 3, {0, 0, 0}, 1) + sheet(2, 2, {0.1, 0.15, 0.05}, 0.8) + elastic +
                         contact_of(GetParam(), "2", "0.,1,1\n"),
                     down(speed), steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  const Vector before = scene.momentum();
  bool of_upper = false, of_lower = false;
  double closest = 1;
  while (scene.state().time < 0.4) {
    EXPECT_GE(run_balanced(scene, scene.state().time + 1e-6), 0);
    for (const ContactNode& n : scene.contacts->nodes(0)) {
      const bool upper = scene.read.model.mesh.nodes.id[n.node.value] >= 2000;
      (upper ? of_upper : of_lower) = true;
      closest = std::min(closest, 0.04 - n.penetration);
    }
  }
  EXPECT_TRUE(of_upper && of_lower) << "corners of both sides, in one-way types too";
  EXPECT_GT(closest, 0) << "mid-surfaces stay apart";
  EXPECT_EQ(scene.result().released, 0u);
  EXPECT_LE((scene.momentum() - before).norm(), 1e-12 * before.norm());
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.01);
  double upper = 0, mass = 0;
  for (std::size_t i = 16; i < scene.state().x.size(); ++i) {
    upper += scene.state().mass[i] * scene.state().v[i].z();
    mass += scene.state().mass[i];
  }
  EXPECT_GT(upper / mass, -0.25 * speed);
  EXPECT_EQ(scene.initial.penetrations.size(), 0u);
}

INSTANTIATE_TEST_SUITE_P(All, SegmentTypes,
                         testing::Values("SURFACE_TO_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE", "SINGLE_SURFACE",
                                         "AUTOMATIC_SINGLE_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE",
                                         "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"),
                         [](const auto& one) { return std::string(one.param); });

// A small sheet of the reference side in the middle of one large tracked segment.
TEST(SegmentRule, SeesTheCornersOfTheOtherSide) {
  const auto force = [](const std::string& a_card) {
    ContactScene scene(sheet(1, 1, {0.4, 0.4, 0}, 0.1) + sheet(2, 1, {0, 0, 0.05}, 1) + elastic +
                           contact_of("AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", a_card, "0.,0,0,1\n"),
                       down(0.5), steps(1e-3));
    EXPECT_TRUE(scene.stepper) << scene.why_not;
    return run_balanced(scene, 0.05);
  };
  EXPECT_EQ(force("0"), 0);
  EXPECT_GT(force("2"), 0);
}

// Two standing plates, edge over edge: DEPTH = 5 sees them.
TEST(SegmentRule, EdgesOnlyWithDepth5) {
  for (const bool single : {true, false}) {
    const auto speed = [&](const std::string& a_card) {
      ContactScene scene(
          "*NODE\n1001,-1.,0.,-2.\n1002,1.,0.,-2.\n1003,1.,0.,0.\n1004,-1.,0.,0.\n"
          "2001,0.1,-1.,0.05\n2002,0.1,1.,0.05\n2003,0.1,1.,2.\n2004,0.1,-1.,2.\n"
          "*ELEMENT_SHELL\n1,1,1001,1002,1003,1004\n2,2,2001,2002,2003,2004\n*PART\np\n1,1,1\n"
          "*PART\np\n2,1,1\n" +
              elastic + contact_of(single ? "AUTOMATIC_SINGLE_SURFACE" : "AUTOMATIC_SURFACE_TO_SURFACE", a_card),
          down(0.1), steps(2e-3));
      EXPECT_TRUE(scene.stepper) << scene.why_not;
      run_balanced(scene, 1.5);
      EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.01);
      double momentum = 0;
      for (std::size_t i = 4; i < 8; ++i) momentum += scene.state().v[i].z();
      return momentum / 4;
    };
    EXPECT_NEAR(speed("2"), -0.1, 1e-12) << "they pass through each other";
    EXPECT_GT(speed("2,,,,2,5"), -0.08);
  }
}

TEST(SegmentRule, BaselineGivesNoForce) {
  ContactScene scene(sheet(1, 3, {0, 0, 0}, 1) + sheet(2, 2, {0.1, 0.15, 0.03}, 0.8) + elastic +
                         contact_of("AUTOMATIC_SURFACE_TO_SURFACE"),
                     {}, steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  EXPECT_EQ(run_balanced(scene, 0.1), 0);
  for (std::size_t i = 0; i < scene.state().x.size(); ++i) EXPECT_EQ(scene.state().x[i], scene.initial.x[i]);
  EXPECT_EQ(scene.stepper->energies().absorbed.sum(), 0);
  const std::vector<ContactNode> nodes = scene.contacts->nodes(0);
  ASSERT_GE(nodes.size(), 9u);
  for (const ContactNode& n : nodes) {
    EXPECT_EQ(n.kind, ContactNode::Kind::kept);
    EXPECT_NEAR(n.forgiven, 0.01, 1e-12);
  }
}

// What comes closer than the baseline is forced by the way that it came.
TEST(SegmentRule, BeyondTheBaselineItPushes) {
  ContactScene scene(sheet(1, 3, {0, 0, 0}, 1) + sheet(2, 2, {0.1, 0.15, 0.03}, 0.8) + elastic +
                         contact_of("AUTOMATIC_SURFACE_TO_SURFACE"),
                     down(0.1), steps(1e-3));
  EXPECT_GT(run_balanced(scene, 1), 0);
  double upper = 0;
  for (std::size_t i = 16; i < scene.state().x.size(); ++i) upper += scene.state().v[i].z();
  EXPECT_GT(upper / 9, -0.05);
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.01);
}

TEST(SegmentRule, DprfacTakesTheBaselineAway) {
  for (const bool curve : {false, true}) {
    ContactScene scene(
        sheet(1, 3, {0, 0, 0}, 1) + sheet(2, 2, {0.1, 0.15, 0.03}, 0.8) + elastic +
            "*DEFINE_CURVE\n7\n0.,0.01\n1.,0.01\n" +
            contact_of("AUTOMATIC_SURFACE_TO_SURFACE", "2", fmt::format("0.\n1,0,{}\n", curve ? "-7." : "0.01")),
        {}, steps(1e-3));
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    scene.step(1);
    EXPECT_NEAR(scene.contacts->nodes(0)[0].forgiven, 0.01, 1e-9);
    scene.step(1);
    const std::vector<ContactNode> nodes = scene.contacts->nodes(0);
    for (const ContactNode& n : nodes) EXPECT_NEAR(n.forgiven, 0.0099, 1e-9);
    EXPECT_GT(run_balanced(scene, 1), 0);
    double least = 1;
    for (std::size_t i = 16; i < scene.state().x.size(); ++i) least = std::min(least, scene.state().x[i].z());
    EXPECT_GT(least, 0.035) << "pushed out of each other";
    for (const ContactNode& n : scene.contacts->nodes(0)) EXPECT_LT(n.forgiven, 1e-5);
  }
}

// The depths of GC107 are the baseline of the first cycle, bit for bit.
TEST(SegmentRule, BaselineIsWhatTheAuditFinds) {
  const std::string plates = sheet(1, 3, {0, 0, 0}, 1) + sheet(2, 2, {0.1, 0.15, 0.03}, 0.8) + elastic;
  for (const char* type : {"AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE"}) {
    ContactScene scene(plates + contact_of(type), {}, steps(1e-3));
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    scene.step();
    contact::InitialCounters counters;
    contact::InitialOptions options;
    options.segments = true;
    const auto audit = contact::initialise_contacts(scene.read.model, scene.surfaces, options, counters);
    std::map<std::int64_t, double> found, expected;
    for (const Penetration& p : audit.penetrations) expected[p.node] = p.depth;
    for (const ContactNode& n : scene.contacts->nodes(0))
      found[scene.read.model.mesh.nodes.id[n.node.value]] = n.forgiven;
    EXPECT_GE(expected.size(), 9u);
    EXPECT_EQ(found, expected);
  }
}

/// One corner over the middle of a segment: k = 0.5 SLSFAC SF m1 m2 / (m1 + m2) / Δt², a quarter of it for a corner; SF
/// is that of the corner's side.
TEST(SegmentRule, StiffnessOfACorner) {
  for (const double fixed : {0.0, 5e-3}) {
    std::string contact = contact_of("AUTOMATIC_SURFACE_TO_SURFACE", "2", fmt::format("0.\n1,0,0.,{}\n", fixed));
    contact.replace(contact.find("1.,1."), 5, "2.,3.");
    ContactScene scene(sheet(1, 1, {0, 0, 0}, 1) + sheet(2, 1, {0.4, 0.4, 0.05}, 4) + elastic + contact, down(0.5),
                       steps(1e-3));
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    bool of_a = false, of_b = false;
    const double dt = fixed > 0 ? fixed : 1e-3, m1 = 0.04, m2 = 16 * 0.04;
    while (scene.state().time < 0.03) {
      scene.step();
      for (const ContactNode& n : scene.contacts->nodes(0)) {
        const bool on_a = scene.read.model.mesh.nodes.id[n.node.value] >= 2000;
        const double k = 0.5 * 0.1 * (on_a ? 2 : 3) * m1 * m2 / (m1 + m2) / (dt * dt) / 4;
        EXPECT_NEAR(n.force.norm(), k * n.penetration, 1e-10 * k * n.penetration);
        (on_a ? of_a : of_b) = true;
      }
    }
    EXPECT_TRUE(of_a && of_b);
  }
}

// A fine sheet flat in a coarse one: its own springs make a uniform pressure, all springs together one on each patch.
TEST(SegmentRule, FineOnCoarseIsUniform) {
  constexpr double distance = 0.05, way = 0.02;
  ContactScene scene(
      sheet(1, 4, {0, 0, 0}, 1) + sheet(2, 16, {0, 0, distance}, 1) + elastic +
          contact_of("AUTOMATIC_SURFACE_TO_SURFACE"),
      [](Structure& s) {
        for (std::size_t i = 25; i < s.state.v.size(); ++i) s.state.v[i] = {0, 0, -way / 1e-3};
      },
      steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  scene.step();
  ASSERT_TRUE(scene.stepper->begin_step().ok());
  std::vector<ContactLink> links;
  scene.contacts->links(0, links);
  ASSERT_EQ(links.size(), 25u + 17u * 17u);
  const double m1 = 0.04 / 16, m2 = 0.04 / 256, depth = 0.04 - (distance - way);
  const double k = 0.05 * m1 * m2 / (m1 + m2) / 1e-6;
  std::array<double, 2> sum{};
  for (const ContactLink& link : links) {
    const bool fine = link.tracked.nodes[0].value >= 25;
    const Vector& x = scene.state().x[link.tracked.nodes[0].value];
    const auto rim = [](double c) { return c < 1e-9 || c > 1 - 1e-9 ? 0.5 : 1.0; };
    EXPECT_NEAR(link.force.norm(), rim(x.x()) * rim(x.y()) * k * depth, 1e-9 * k * depth);
    sum[fine ? 1 : 0] += link.force.norm();
  }
  EXPECT_NEAR(sum[1], 256 * k * depth, 1e-7 * sum[1]);
  EXPECT_NEAR(sum[0], 16 * k * depth, 1e-7 * sum[0]);
}

// A node that has passed the mid-surface of a shell is pushed back to the side from which it came.
TEST(SegmentRule, ComesBackFromBehindAShell) {
  ContactScene scene(sheet(1, 1, {0, 0, 0}, 1) + sheet(2, 1, {0.4, 0.4, 0.05}, 0.2) + elastic +
                         contact_of("AUTOMATIC_SURFACE_TO_SURFACE", "2", "0.\n1,0,0.,0.02\n"),
                     down(0.55), steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  double deepest = 0;
  while (scene.state().time < 1) {
    scene.step();
    for (const ContactNode& n : scene.contacts->nodes(0)) deepest = std::max(deepest, n.penetration);
  }
  EXPECT_GT(deepest, 0.04) << "beyond the mid-surface";
  EXPECT_GT(scene.state().v[4].z() + scene.state().v[6].z(), 0);
  EXPECT_GT(scene.state().x[4].z(), 0.04);
}

// A node whose nearest segment changes to one of another surface has not passed the first one.
TEST(SegmentRule, StaysBetweenTwoSheets) {
  ContactScene scene(
      sheet(1, 2, {0, 0, 0}, 1) + sheet(2, 2, {0, 0, 0.076}, 1) + sheet(3, 2, {0.2, 0.2, 0.0379}, 0.6) +
          "*SECTION_SHELL\n1,2\n0.04\n*MAT_ELASTIC\n1,1.,1000.,0.3\n*SET_PART_LIST\n1\n1,2,3\n" +
          contact_of("AUTOMATIC_SINGLE_SURFACE"),
      [](Structure& s) {
        for (std::size_t i = 0; i < s.state.v.size(); ++i) {
          if (s.state.x[i].z() > 0.03 && s.state.x[i].z() < 0.05)
            s.state.v[i] = {0, 0, 0.05};
          else
            s.constraints.hold(NodeIndex{static_cast<std::uint32_t>(i)}, 63);
        }
      },
      steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  while (scene.state().time < 2) {
    scene.step();
    for (std::size_t i = 18; i < 27; ++i) {
      ASSERT_GT(scene.state().x[i].z(), 0.0) << scene.state().time;
      ASSERT_LT(scene.state().x[i].z(), 0.076) << scene.state().time;
    }
  }
}

/// A cube of one brick, nodes from 10 · part on.
std::string brick(int part, double z, double size) {
  std::string text = "*NODE\n";
  for (int i = 0; i < 8; ++i)
    text += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", 10 * part + i, i % 4 == 1 || i % 4 == 2 ? size : 0.01 * part,
                        i % 4 >= 2 ? size : 0.01 * part, z + (i >= 4 ? size : 0));
  text += fmt::format("*ELEMENT_SOLID\n{},{}", part, part);
  for (int i = 0; i < 8; ++i) text += fmt::format(",{}", 10 * part + i);
  return text + fmt::format("\n*PART\nb\n{0},2,1\n", part);
}

TEST(SegmentRule, BricksBounceOffEachOther) {
  ContactScene scene(brick(1, -1, 1) + brick(2, 0.01, 0.8) + "*SECTION_SOLID\n2,1\n" + elastic +
                         contact_of("AUTOMATIC_SURFACE_TO_SURFACE"),
                     down(0.5), steps(2e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  const Vector before = scene.momentum();
  EXPECT_GT(run_balanced(scene, 0.6), 0);
  double lower = 0;
  for (std::size_t i = 0; i < 8; ++i) lower += scene.state().v[i].z() / 8;
  EXPECT_LT(lower, -0.1);
  EXPECT_EQ(scene.result().touching, 0u);
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.02);
  EXPECT_LE((scene.momentum() - before).norm(), 1e-12 * before.norm());
}

// When surfaces are built again the baseline stays, and what comes beyond it is forced as before.
TEST(SegmentRule, OtherSurfacesGoOnWithTheBaseline) {
  const model::Read read = model::read_text(sheet(1, 3, {0, 0, 0}, 1) + sheet(2, 2, {0.1, 0.15, 0.03}, 0.8) + elastic +
                                            contact_of("AUTOMATIC_SURFACE_TO_SURFACE"));
  ASSERT_EQ(read.errors(), 0u) << read.text();
  contact::SurfaceStore surfaces(read.model);
  const ContactMasses masses(read.model);
  const auto search = contact::make_bucket_grid();
  const contact::TiedPairs ties(read.model);
  State state;
  state.x = read.model.mesh.nodes.x;
  state.v.assign(state.x.size(), Vector::Zero());
  const std::vector<bool> movable(state.x.size(), true);
  SharedTables shared;
  const ContactSetting setting{read.model, masses, *search, ties, movable, shared};
  ContactCounters counters;
  ContactState result;
  const auto forces = [&](InterfacePass& pass) {
    Forces all;
    all.resize(state.x.size());
    pass.find_candidates(0.1, counters);
    pass.advance_state(state, 0, counters);
    pass.add_forces(state, all, result);
    return all.force;
  };
  const auto make = [&] {
    auto pass = std::make_unique<ContactPass>(setting, ContactIndex{0}, surfaces.at(ContactIndex{0}), false, state.x);
    pass->set_timestep(1e-3);
    return pass;
  };
  const auto first = make(), same = make(), fresh = make(), next = make();
  const std::vector<Vector> none(state.x.size(), Vector::Zero());
  EXPECT_EQ(forces(*first), none);
  EXPECT_EQ(forces(*same), none);
  for (std::size_t i = 16; i < state.x.size(); ++i) state.x[i].z() -= 0.005;
  next->continue_from(*first, state, result);
  const std::vector<Vector> expected = forces(*same);
  EXPECT_GT(expected[20].z(), 0);
  EXPECT_EQ(forces(*next), expected);
  EXPECT_EQ(forces(*fresh), none) << "a new contact takes what it finds";
}

TEST(SegmentRule, TellsOfIntersectingSegments) {
  ContactScene scene(
      "*NODE\n1001,-1.,0.,-2.\n1002,1.,0.,-2.\n1003,1.,0.,1.\n1004,-1.,0.,1.\n"
      "2001,-0.5,-1.,0.05\n2002,0.5,-1.,0.05\n2003,0.5,1.,0.05\n2004,-0.5,1.,0.05\n"
      "*ELEMENT_SHELL\n11,1,1001,1002,1003,1004\n12,2,2001,2002,2003,2004\n*PART\np\n1,1,1\n"
      "*PART\np\n2,1,1\n" +
          elastic + contact_of("AUTOMATIC_SURFACE_TO_SURFACE", "2", "0.\n1\n0,0.01\n"),
      {}, steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  scene.step();
  const std::vector<ContactEvent> events = scene.contacts->take_events();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NE(events[0].text.find("segments that intersect = 1"), std::string::npos) << events[0].text;
  EXPECT_NE(events[0].text.find("shell 11 and segment of shell 12"), std::string::npos) << events[0].text;
  scene.step(30);
  EXPECT_TRUE(scene.contacts->take_events().empty()) << "told once while nothing changes";
}

// Without elements that set a step its springs would have no stiffness, and bodies would pass through each other.
TEST(SegmentRule, RigidBodiesAloneNeedAStep) {
  const std::string rigid = "*SECTION_SHELL\n1,2\n0.04\n*MAT_RIGID\n1,1.,1000.,0.3\n\n\n*SET_PART_LIST\n1\n1,2\n";
  const std::string deck = sheet(1, 1, {0, 0, 0}, 1) + sheet(2, 1, {0, 0, 0.5}, 1) + rigid +
                           "*CONTROL_TERMINATION\n1.\n" + contact_of("AUTOMATIC_SURFACE_TO_SURFACE");
  RunSettings settings;
  settings.cycles = 1;
  const RunScene without(deck, settings), with(deck + "*CONTROL_TIMESTEP\n1e-3\n", settings);
  EXPECT_FALSE(without.prepared());
  EXPECT_NE(without.message().find("SOFT = 2"), std::string::npos) << without.message();
  EXPECT_TRUE(with.prepared()) << with.message();
}

TEST(SegmentRule, NamesWhatIsNotCalculated) {
  const auto warnings = [](const std::string& a_card, const std::string& more, const std::string& type) {
    RunSettings settings;
    settings.cycles = 1;
    RunScene scene(sheet(1, 1, {0, 0, 0}, 1) + sheet(2, 1, {0, 0, 0.5}, 1) + elastic + contact_of(type, a_card, more),
                   settings);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    std::string text;
    for (const Diagnostic& d : scene.diagnostics().sorted()) text += d.message + "\n";
    return text;
  };
  const std::string type = "AUTOMATIC_SURFACE_TO_SURFACE";
  EXPECT_EQ(warnings("2", "", type), "");
  EXPECT_NE(warnings("2,,,,4", "", type).find("SBOPT = 4"), std::string::npos);
  EXPECT_EQ(warnings("2,,,,3,5", "", type), "");
  EXPECT_NE(warnings("2,,,,2,3", "", type).find("DEPTH = 3"), std::string::npos);
  EXPECT_NE(warnings("2,,,,2,35", "", type).find("last digit"), std::string::npos);
  EXPECT_NE(warnings("2", "", "SURFACE_TO_SURFACE").find("SHLTHK = 1"), std::string::npos);
  EXPECT_EQ(warnings("2", "0.,1,1\n", "SURFACE_TO_SURFACE"), "");
  EXPECT_NE(warnings("2", "0.3\n", type).find("PENMAX"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::segment_rule_test
