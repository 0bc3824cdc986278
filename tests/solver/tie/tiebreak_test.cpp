// Tiebreak contacts: when their ties fail, what is left of them, and the contact behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "results/log/solver_log.hpp"
#include "solver/output/run_files.hpp"
#include "solver/run_scene.hpp"
#include "solver/tie/tiebreak_scene.hpp"

namespace gapcheck::solver::tiebreak_test {
namespace {

using namespace tiebreak_scene;

struct Pull {
  double force = 0, time = 0;  ///< of the failure; 0: none
  std::vector<ContactEvent> events;
  std::optional<ContactNode::Kind> kind;
};

/// A force that grows slowly in the direction (x, z); the shell has an area of `area`.
Pull pull(const std::string& keyword, const std::string& card, double x, double z, double area = 1) {
  constexpr double end = 60, rate = 0.05;
  std::string drive = "*LOAD_NODE_POINT\n";
  if (x != 0) drive += fmt::format("5,1,1,{}\n", x);
  if (z != 0) drive += fmt::format("5,3,1,{}\n", z);
  std::string deck = node_on_shell(keyword, card, drive, fmt::format("0.,0.\n{},{}\n", end, rate * end), end);
  for (const std::string corner : {"\n2,1.", "\n3,1."})
    deck.replace(deck.find(corner), corner.size(), fmt::format("{}{}", corner.substr(0, 3), area));
  RunScene scene(deck);
  Pull pull;
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return pull;
  }
  scene.go([&](const solver::Run& run) {
    if (pull.kind) return;
    const std::vector<ContactView> views = run.contacts();
    for (const ContactView& view : views)
      for (const ContactNode& node : view.nodes())
        if (node.kind == ContactNode::Kind::broken) pull.kind = node.kind;
    if (pull.kind) {
      pull.time = run.stepper().state().time;
      pull.force = rate * pull.time;
      pull.events = run.events();
    }
  });
  return pull;
}

TEST(Tiebreak, FailsByTheCriterion) {
  // (tension / 2)^1 + (shear / 1)^2 at t: tension only, shear only, both.
  EXPECT_NEAR(pull(old_type, "2.,1.,1.,2.", 0, 1).force, 2, 0.03);
  EXPECT_NEAR(pull(old_type, "2.,1.,1.,2.", 1, 0).force, 1, 0.02);
  const double both = std::sqrt(1.0 / 16 + 1) - 0.25;  // f/2 + f² = 1
  EXPECT_NEAR(pull(old_type, "2.,1.,1.,2.", 1, 1).force, both, 0.02);
  // Stresses, on the area of the segment; powers are 2.
  EXPECT_NEAR(pull(automatic, "2,1.5,1.", 0, 1).force, 1.5, 0.03);
  EXPECT_NEAR(pull(automatic, "2,1.,1.", 1, 1).force, std::sqrt(0.5), 0.02);
  // On another area the stresses are others, the forces the same.
  EXPECT_NEAR(pull(automatic, "2,1.5,1.", 0, 1, 1.5).force, 1.5 * 1.5, 0.03);
  EXPECT_NEAR(pull(old_type, "2.,1.,1.,2.", 0, 1, 1.5).force, 2, 0.03);
  // Zero is not a limit, and compression never counts.
  EXPECT_EQ(pull(old_type, "0.,1.", 0, 1).force, 0);
  EXPECT_EQ(pull(old_type, "0.1,0.", 0, -1).force, 0);
}

/// The tie of another contact beside a tiebreak has no strength that it could lose.
TEST(Tiebreak, LeavesOtherTiesAsTheyAre) {
  RunScene scene(node_on_shell(old_type, "0.1,0.1", "*LOAD_NODE_POINT\n5,3,1,1.\n6,3,1,1.\n", "0.,0.\n10.,1.\n", 5) +
                 "*NODE\n6,0.3,0.3,0.05\n*ELEMENT_MASS\n6,6,1.\n*SET_NODE_LIST\n2\n6\n"
                 "*CONTACT_TIED_NODES_TO_SURFACE_OFFSET\n2,1,4,3\n0.\n1.,1.,-1.,-1.\n");
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const auto kinds = [&](ContactIndex contact) {
    std::vector<ContactNode::Kind> list;
    for (const ContactView& view : scene.run().contacts())
      for (const ContactNode& node : view.nodes())
        if (view.state().contact == contact) list.push_back(node.kind);
    return list;
  };
  EXPECT_EQ(kinds(ContactIndex{0}), std::vector{ContactNode::Kind::broken});
  EXPECT_EQ(kinds(ContactIndex{1}), std::vector{ContactNode::Kind::tied});
  EXPECT_GT(scene.state().x[4].z(), 0.5) << "flies off";
  EXPECT_LT(scene.state().x[5].z(), half_thickness + 0.1);
}

/// When a tie beside it has ended, the failure is still told, once and by its own contact.
TEST(Tiebreak, TellsOfItsFailureAfterAnotherTieHasEnded) {
  std::string deck =
      node_on_shell("TIED_NODES_TO_SURFACE_OFFSET", "", "*LOAD_NODE_POINT\n6,3,1,1.\n", "0.,0.\n10.,1.\n", 5);
  const std::string cards = "1,1,4,3\n0.\n1.,1.\n";
  deck.replace(deck.find(cards), cards.size(), "1,1,4,3\n0.,0.,0.,0.,0.,0,0.,0.5\n1.,1.,-1.,-1.\n");
  RunScene scene(deck +
                 "*NODE\n6,0.3,0.3,0.05\n*ELEMENT_MASS\n6,6,1.\n*SET_NODE_LIST\n2\n6\n"
                 "*CONTACT_TIEBREAK_NODES_TO_SURFACE\n2,1,4,3\n0.\n1.,1.\n0.1,0.1\n");
  ASSERT_TRUE(scene.prepared()) << scene.message();
  std::vector<ContactEvent> events;
  scene.go([&](const solver::Run& run) { events.insert(events.end(), run.events().begin(), run.events().end()); });
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].contact, ContactIndex{1});
  EXPECT_NE(events[0].text.find("1 nodes have failed: 6"), std::string::npos) << events[0].text;
}

TEST(Tiebreak, TellsOfItsFailure) {
  const Pull found = pull(old_type, "1.,1.", 0, 1);
  ASSERT_TRUE(found.kind.has_value());
  ASSERT_EQ(found.events.size(), 1u);
  EXPECT_EQ(found.events[0].contact, ContactIndex{0});
  EXPECT_EQ(found.events[0].time, found.time);
  EXPECT_NE(found.events[0].text.find("1 nodes have failed: 5"), std::string::npos) << found.events[0].text;
}

/// Linear damage: the work is half of strength times critical opening, in tension and in shear, and the force falls on
/// a line.
TEST(Tiebreak, LinearDamageTakesTheFractureEnergy) {
  constexpr double strength = 2, critical = 0.4, speed = 0.005;
  for (const int direction : {1, 3}) {
    const std::string drive = fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,{},0,1\n", direction);
    RunScene scene(node_on_shell(automatic, fmt::format("6,{0},{0},{1}", strength, critical), drive,
                                 fmt::format("0.,{0}\n1000.,{0}\n", speed), 100));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double largest = 0, half_way = 0, at_half_way = 0;
    scene.go([&](const solver::Run& run) {
      const double force = run.contacts().back().state().force_a.norm();
      largest = std::max(largest, force);
      const double way = speed * run.stepper().state().time;
      if (half_way == 0 && way > 0.3) half_way = force, at_half_way = way;
    });
    const double stiffness = 0.1 * 1000 / 1.5 * 1 / std::sqrt(2.0), onset = strength / stiffness;
    EXPECT_NEAR(largest, strength, 0.02);
    EXPECT_NEAR(half_way, strength * (critical - at_half_way) / (critical - onset), 0.02);
    EXPECT_NEAR(scene.energies().absorbed.sliding(), strength * critical / 2, 0.005) << direction;
    EXPECT_NEAR(scene.energies().ratio(), 1, 1e-6);
  }
}

/// Compression before or after the onset of damage changes neither the strength nor the line.
TEST(Tiebreak, CompressionIsNoDamage) {
  constexpr double strength = 2, critical = 0.4, stiffness = 0.1 * 1000 / 1.5 * 1 / std::numbers::sqrt2;
  constexpr double onset = strength / stiffness;
  for (const char* curve :
       {"0.,0.\n100.,0.2\n", "0.,0.\n20.,-0.1\n100.,0.2\n", "0.,0.\n20.,0.1\n50.,-0.3\n100.,0.2\n"}) {
    RunScene scene(node_on_shell(automatic, fmt::format("6,{0},{0},{1}", strength, critical),
                                 "*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,3,2,1\n", curve, 100));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double largest = 0, last = 0;
    scene.go([&](const solver::Run& run) {
      last = 0;
      for (const ContactView& view : run.contacts()) last = std::max(last, -view.state().force_a.z());
      largest = std::max(largest, last);
    });
    EXPECT_NEAR(largest, strength, 0.03) << curve;
    EXPECT_NEAR(last, strength * (critical - 0.2) / (critical - onset), 0.02) << curve;
  }
}

/// After the failure the surfaces meet like any others, at the contact distance; _ONLY leaves nothing.
TEST(Tiebreak, BecomesAContact) {
  for (const std::string& keyword : {automatic, std::string("TIEBREAK_NODES_ONLY")}) {
    const bool only = keyword != automatic;
    // Away by 0.1, and back to where it would be 0.02 below the surface.
    const std::string drive = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,3,2,1\n";
    RunScene scene(node_on_shell(keyword, only ? "0.5,0.5" : "2,0.5,0.5\n\n0.,0,0,1", drive,
                                 "0.,0.\n10.,0.1\n20.,-0.02\n100.,-0.02\n", 25));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double away = -1;
    scene.go([&](const solver::Run& run) {
      double force = 0;
      for (const ContactView& view : run.contacts()) force += view.state().force_a.z();
      if (run.stepper().state().time < 14) away = force;
    });
    EXPECT_EQ(away, 0) << keyword;
    double force = 0;
    for (const ContactView& view : scene.run().contacts()) force += view.state().force_a.z();
    const double stiffness = 0.1 * 1000 / 1.5 * 1 / std::sqrt(2.0);
    EXPECT_NEAR(force, only ? 0 : stiffness * 0.02, 1e-9) << keyword;
  }
}

/// Damping beyond all bounds leaves a spring that holds.
TEST(TieEnd, HugeDampingStillTies) {
  std::string text =
      node_on_shell("TIED_NODES_TO_SURFACE_OFFSET", "", "*LOAD_NODE_POINT\n5,3,1,1.\n", "0.,0.1\n100.,0.1\n", 5);
  const std::string cards = "1,1,4,3\n0.\n1.,1.\n";
  text.replace(text.find(cards), cards.size(), "1,1,4,3\n0.,0.,0.,0.,1e10\n1.,1.,-1.,-1.\n");
  RunScene scene(text);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  // Free it would fly by ½ F t² = 1.25.
  EXPECT_GT(scene.state().x[4].z(), half_thickness);
  EXPECT_LT(scene.state().x[4].z() - half_thickness, 0.1 * 1.25);
}

/// Ties that are over leave their nodes to other contacts.
TEST(TieEnd, OtherContactsFollow) {
  for (const char* keyword : {"TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", "TIED_NODES_TO_SURFACE_OFFSET"}) {
    RunScene scene(node_on_shell("AUTOMATIC_NODES_TO_SURFACE", "",
                                 fmt::format("*LOAD_NODE_POINT\n5,3,1,1.\n*CONTACT_{}\n1,1,4,3\n"
                                             "0.,0.,0.,0.,0.,0,0.,10.\n1.,1.,-1.,-1.\n",
                                             keyword),
                                 "0.,-0.1\n100.,-0.1\n", 20));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double before = 0, after = 0;
    scene.go([&](const solver::Run& run) {
      double& largest = run.stepper().state().time < 10 ? before : after;
      largest = std::max(largest, run.contacts().front().state().force_a.norm());
    });
    EXPECT_EQ(before, 0) << keyword;
    EXPECT_GE(after, 0.1) << keyword << " carries the load";
  }
}

/// The message file names the failure, and nothing in it is taken for a node that stayed untied.
TEST(Tiebreak, MessageFileNamesTheFailure) {
  std::string folder = testing::TempDir() + "gapcheck_XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string drive = "*LOAD_NODE_POINT\n5,3,1,1.\n";
  const model::Read read = model::read_text(node_on_shell(old_type, "0.1,0.1", drive, "0.,0.\n10.,1.\n", 5));
  contact::SurfaceStore surfaces(read.model);
  Diagnostics diagnostics;
  auto prepared = solver::Run::prepare(read.model, surfaces, {}, diagnostics);
  ASSERT_TRUE(prepared.ok());
  solver::Run& run = prepared.value();
  RunFilesSettings settings;
  settings.directory = folder;
  auto files = RunFiles::create(run, surfaces, settings);
  ASSERT_TRUE(files.ok());
  EXPECT_EQ(run.go(files.value()), RunEnd::time);
  std::ifstream stream(folder + "/messag", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(text.find("     The ties of 1 nodes have failed: 5\n"), text.npos) << text;
  const Report report = results::read_solver_log_text(text, "messag", {}, diagnostics);
  EXPECT_TRUE(report.tie_failures.empty());
  EXPECT_TRUE(report.penetrations.empty());
  std::filesystem::remove_all(folder);
}

TEST(Tiebreak, WhatIsNotCalculatedIsRefused) {
  const auto method = [](const std::string& keyword, const std::string& card) {
    const model::Read read = model::read_text("*CONTACT_" + keyword + "\n1,2,3,3\n\n\n" + card + "\n");
    return choose_method(read.model.contacts.at(0));
  };
  const std::string surfaces = "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK";
  EXPECT_EQ(method(surfaces, "2,1.,1.").method, ContactMethod::tiebreak);
  EXPECT_EQ(method(surfaces, "6,1.,1.,0.1").method, ContactMethod::tiebreak);
  EXPECT_EQ(method("TIEBREAK_SURFACE_TO_SURFACE", "1.,1.").method, ContactMethod::tiebreak);
  EXPECT_EQ(method("AUTOMATIC_SINGLE_SURFACE_TIEBREAK", "1").method, ContactMethod::tiebreak);
  EXPECT_EQ(method("AUTOMATIC_SINGLE_SURFACE_TIEBREAK", "2,1.,1.").method, ContactMethod::tiebreak);
  EXPECT_EQ(method("AUTOMATIC_SINGLE_SURFACE_TIEBREAK", "3,1.,1.").method, ContactMethod::none);
  EXPECT_EQ(method("AUTOMATIC_SINGLE_SURFACE_TIEBREAK", "-3,1.,1.").method, ContactMethod::none);
  EXPECT_EQ(method("AUTOMATIC_SINGLE_SURFACE_TIEBREAK", "13,1.,1.").method, ContactMethod::none);
  EXPECT_EQ(method("AUTOMATIC_GENERAL_TIEBREAK", "1").method, ContactMethod::none);
  for (const char* card : {"0", "12", "5,0.,1.", "7,1.,1.", "9,1.,1.,0.,1.,1.", "9,1.,-7.,1.,1.,1.",
                           "9,1.,1.,1.,1.,1.,-1.", "6,1.,1.", "8,1.,1.", "13,1.,1."}) {
    EXPECT_EQ(method(surfaces, card).method, ContactMethod::none) << card;
    EXPECT_FALSE(method(surfaces, card).why_not.empty()) << card;
  }
  for (const char* card : {"1", "-1", "3,1.,1.", "-3,1.,1.", "-2,1.,1.", "4,1.", "5,1.", "7,1.,1.,0.,1.,1.",
                           "8,1.,1.,0.1", "9,1.,1.,-1.,1.,1.", "11,1.,1.,1.,1.,1."})
    EXPECT_EQ(method(surfaces, card).method, ContactMethod::tiebreak) << card;
  for (const int soft : {0, 1})
    EXPECT_EQ(method(surfaces, fmt::format("2,1.,1.\n{}", soft)).method, ContactMethod::tiebreak);
  EXPECT_EQ(method(surfaces, "2,1.,1.\n2").method, ContactMethod::none);
  EXPECT_NE(method(surfaces, "2,1.,1.\n2").why_not.find("SOFT"), std::string_view::npos);
  EXPECT_EQ(method("TIED_SURFACE_TO_SURFACE_FAILURE", "").method, ContactMethod::tie);
}

TEST(Tiebreak, CardsThatCannotBeAreNamed) {
  const auto message = [](const std::string& keyword, const std::string& card) {
    RunScene scene(node_on_shell(keyword, card, "*LOAD_NODE_POINT\n5,3,1,1.\n", "0.,0.\n10.,1.\n", 1));
    return scene.message();
  };
  EXPECT_NE(message("TIEBREAK_SURFACE_TO_SURFACE", "1.,1.,77").find("no curve 77"), std::string::npos);
  EXPECT_NE(message(automatic, "5,1.,1.,78").find("no curve 78"), std::string::npos);
  EXPECT_NE(message(automatic, "2,-1.,1.").find("0 or more"), std::string::npos);
  EXPECT_NE(message(old_type, "1.,1.,-1.,1.").find("NEN"), std::string::npos);
  EXPECT_EQ(message(automatic, "5,1.,1."), "");
}

}  // namespace
}  // namespace gapcheck::solver::tiebreak_test
