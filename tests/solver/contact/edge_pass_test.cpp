// Edges against edges: impacts with a closed form, no passage, balance of every force, and a slow twin.
#include "solver/contact/edge_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "base/parallel.hpp"
#include "solver/contact/edge_twin.hpp"
#include "solver/contact_scene.hpp"

namespace gapcheck::solver::edge_pass_test {
namespace {

const std::string elastic = "*MAT_ELASTIC\n1,1.,1000.,0.25\n";

std::string node(int id, const Vector& x) {
  return fmt::format("{},{:.17g},{:.17g},{:.17g}\n", id, x.x(), x.y(), x.z());
}

/// A beam along a direction, radius 0.1, as part and with the nodes 10 · part + 1 and + 2.
std::string beam(int part, const Vector& middle, const Vector& half) {
  return "*NODE\n" + node(10 * part + 1, middle - half) + node(10 * part + 2, middle + half) +
         fmt::format("*ELEMENT_BEAM\n{0},{0},{1},{2}\n*PART\nb\n{0},9,1\n", part, 10 * part + 1, 10 * part + 2);
}
const std::string beam_section = "*SECTION_BEAM\n9,3\n0.0314159265358979\n";

/// One shell as part with the nodes 10 · part + 1 to + 4.
std::string shell(int part, const std::array<Vector, 4>& x) {
  std::string text = "*NODE\n";
  for (int i = 0; i < 4; ++i) text += node(10 * part + 1 + i, x[static_cast<std::size_t>(i)]);
  const int n = 10 * part;
  return text +
         fmt::format("*ELEMENT_SHELL\n{0},{0},{1},{2},{3},{4}\n*PART\ns\n{0},8,1\n", part, n + 1, n + 2, n + 3, n + 4);
}
const std::string shell_section = "*SECTION_SHELL\n8,2\n0.2\n";

std::string contact_of(const std::string& type, const std::string& options = "0.\n1.,1.\n0\n0.,0,0,1\n") {
  return "*CONTACT_" + type + "\n0\n" + options;
}

/// Two beams, one unit long each, crossing at right angles; the upper one comes down.
std::string crossing_beams(double distance, const std::string& contact) {
  return beam(1, {0, 0, 0}, {0.5, 0, 0}) + beam(2, {0.05, 0.1, distance}, {0, 0.5, 0}) + beam_section + elastic +
         contact;
}

/// A standing plate below, and one above it across, edge over edge.
std::string crossing_plates(double distance, const std::string& contact) {
  return shell(1, {Vector(-1, 0, -2), Vector(1, 0, -2), Vector(1, 0, 0), Vector(-1, 0, 0)}) +
         shell(2, {Vector(0.1, -1, distance), Vector(0.1, 1, distance), Vector(0.1, 1, 2 + distance),
                   Vector(0.1, -1, 2 + distance)}) +
         shell_section + elastic + contact;
}

struct Watched {
  double greatest = 0;  ///< force
  double deepest = 0;   ///< penetration
  double impulse = 0;
  double speed_up = 0, speed_down = 0;  ///< of both bodies at the end
};

/// Throws the nodes from id 20 on down and steps; every force must be balanced.
Watched throw_down(ContactScene& scene, double speed, double end) {
  Watched watched;
  const auto upper = [&](std::size_t i) { return scene.read.model.mesh.nodes.id[i] >= 20; };
  while (scene.state().time < end) {
    if (const SolverStatus status = scene.stepper->begin_step(); !status.ok()) {
      ADD_FAILURE() << status.error().message;
      break;
    }
    const Forces& f = scene.stepper->external();
    Vector sum = Vector::Zero(), moment = Vector::Zero(), on_upper = Vector::Zero();
    double size = 0;
    for (std::size_t i = 0; i < f.force.size(); ++i) {
      sum += f.force[i];
      moment += scene.state().x[i].cross(f.force[i]);
      size += f.force[i].norm() * (1 + scene.state().x[i].norm());
      if (upper(i)) on_upper += f.force[i];
    }
    EXPECT_LE(sum.norm(), 1e-12 * size);
    EXPECT_LE(moment.norm(), 1e-12 * size);
    watched.greatest = std::max(watched.greatest, on_upper.norm());
    watched.impulse += on_upper.z() * scene.stepper->next_step();
    for (const ContactNode& n : scene.contacts->nodes(0)) watched.deepest = std::max(watched.deepest, n.penetration);
    scene.stepper->end_step();
  }
  double up = 0, down = 0, mass_up = 0, mass_down = 0;
  for (std::size_t i = 0; i < scene.state().x.size(); ++i) {
    (upper(i) ? up : down) += scene.state().mass[i] * scene.state().v[i].z();
    (upper(i) ? mass_up : mass_down) += scene.state().mass[i];
  }
  EXPECT_NEAR(up + down, -speed * mass_up, 1e-11 * speed * mass_up);
  watched.speed_up = up / mass_up;
  watched.speed_down = down / mass_down;
  return watched;
}

ContactScene::Prepare down(double speed, std::size_t first) {
  return [=](Structure& s) {
    for (std::size_t i = first; i < s.state.v.size(); ++i) s.state.v[i] = {0, 0, -speed};
  };
}

StepSettings steps(double greatest) {
  StepSettings settings;
  settings.greatest_step = greatest;
  settings.energy_tolerance = 0;
  return settings;
}

TEST(EdgePass, CrossingBeamsExchangeTheirVelocities) {
  ContactScene scene(crossing_beams(0.25, contact_of("AUTOMATIC_GENERAL")), down(0.5, 2), steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  const Watched w = throw_down(scene, 0.5, 0.5);
  EXPECT_GT(w.greatest, 0);
  EXPECT_LT(w.deepest, 0.1);
  EXPECT_EQ(scene.result().touching, 0u) << "apart again";
  // The hit is off the middle of both, so they turn; energy is what comes back.
  const Energies& e = scene.stepper->energies();
  EXPECT_NEAR(e.kinetic / e.initial, 1, 0.02);
  EXPECT_NEAR(e.ratio(), 1, 1e-3);
  EXPECT_GT(w.speed_up, -0.25);
  EXPECT_LT(w.speed_down, -0.25);
}

TEST(EdgePass, MiddleOnMiddleIsAnElasticImpactOfTwoMasses) {
  ContactScene scene(beam(1, {0, 0, 0}, {0.5, 0, 0}) + beam(2, {0, 0, 0.25}, {0, 0.5, 0}) + beam_section + elastic +
                         contact_of("AUTOMATIC_GENERAL"),
                     down(0.5, 2), steps(1e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  const Watched w = throw_down(scene, 0.5, 0.5);
  EXPECT_NEAR(w.speed_up, 0, 0.01);
  EXPECT_NEAR(w.speed_down, -0.5, 0.01);
  // Depth of a spring k = 0.1 K d between two equal masses.
  const double k = 0.1 * (1000 / 1.5) * 0.2, mass = 0.0314159265358979;
  EXPECT_NEAR(w.deepest, 0.5 * std::sqrt(mass / 2 / k), 0.02 * w.deepest);
}

TEST(EdgePass, PlatesEdgeOnEdgeRebound) {
  ContactScene scene(crossing_plates(0.25, contact_of("AUTOMATIC_GENERAL")), down(0.5, 4), steps(2e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  const Watched w = throw_down(scene, 0.5, 1.5);
  EXPECT_GT(w.greatest, 0);
  EXPECT_LT(w.deepest, 0.2) << "no passage";
  EXPECT_EQ(scene.result().touching, 0u);
  EXPECT_GT(w.speed_up, w.speed_down + 0.1) << "they part";
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.01);
}

TEST(EdgePass, UnderType13TheSameEdgesPassThroughEachOther) {
  ContactScene plates(crossing_plates(0.25, contact_of("AUTOMATIC_SINGLE_SURFACE")), down(0.5, 4), steps(0));
  ASSERT_TRUE(plates.stepper) << plates.why_not;
  const Watched w = throw_down(plates, 0.5, 1.5);
  EXPECT_EQ(w.greatest, 0);
  EXPECT_EQ(w.speed_up, -0.5);
  ContactScene beams(crossing_beams(0.25, contact_of("AUTOMATIC_SINGLE_SURFACE")), down(0.5, 2), steps(1e-2));
  ASSERT_TRUE(beams.stepper) << beams.why_not;
  EXPECT_EQ(throw_down(beams, 0.5, 1).greatest, 0);
}

TEST(EdgePass, BeamOnShellEdge) {
  const auto scene_of = [](const std::string& type) {
    return ContactScene(shell(1, {Vector(-1, 0, -2), Vector(1, 0, -2), Vector(1, 0, 0), Vector(-1, 0, 0)}) +
                            beam(2, {0.1, 0, 0.25}, {0, 0.5, 0}) + shell_section + beam_section + elastic +
                            contact_of(type),
                        down(0.5, 4), steps(1e-3));
  };
  ContactScene held = scene_of("AUTOMATIC_GENERAL"), free = scene_of("AUTOMATIC_SINGLE_SURFACE");
  ASSERT_TRUE(held.stepper && free.stepper);
  const Watched w = throw_down(held, 0.5, 0.6);
  EXPECT_GT(w.speed_up, 0.3) << "a light beam comes back from a heavy plate";
  EXPECT_LT(w.deepest, 0.2);
  EXPECT_NEAR(held.stepper->energies().ratio(), 1, 1e-3);
  EXPECT_EQ(throw_down(free, 0.5, 0.6).greatest, 0);
}

/// A roof of two shells whose ridge runs along a direction; `up`: 1 with the ridge on top.
std::string roof(int part, const Vector& ridge, const Vector& across, const Vector& middle, double up) {
  const Vector fall(0, 0, -3 * up);
  const std::array<Vector, 6> x{middle - ridge,
                                middle + ridge,
                                middle - ridge + across + fall,
                                middle + ridge + across + fall,
                                middle - ridge - across + fall,
                                middle + ridge - across + fall};
  std::string text = "*NODE\n";
  for (int i = 0; i < 6; ++i) text += node(10 * part + 1 + i, x[static_cast<std::size_t>(i)]);
  const int n = 10 * part;
  return text + fmt::format("*ELEMENT_SHELL\n{0}1,{0},{1},{2},{4},{3}\n{0}2,{0},{1},{2},{6},{5}\n*PART\nr\n{0},8,1\n",
                            part, n + 1, n + 2, n + 3, n + 4, n + 5, n + 6);
}

TEST(EdgePass, EdgesBetweenShellsCountOnlyWithInterior) {
  const auto force = [](const std::string& type) {
    ContactScene scene(roof(1, {2, 0, 0}, {0, 1, 0}, {0, 0, 0}, 1) +
                           roof(2, {0, 2, 0}, {1, 0, 0}, {0.1, 0.1, 0.15}, -1) + shell_section + elastic +
                           contact_of(type),
                       {}, steps(0));
    EXPECT_TRUE(scene.stepper) << scene.why_not;
    return throw_down(scene, 0, 1e-9).greatest;
  };
  EXPECT_EQ(force("AUTOMATIC_GENERAL"), 0);
  EXPECT_GT(force("AUTOMATIC_GENERAL_INTERIOR"), 0);
}

// So fast that they are past each other's mid-lines within a step: the side from which they came is remembered.
TEST(EdgePass, ComesBackFromBeyondTheMidLine) {
  ContactScene scene(beam(1, {0, 0, 0}, {0.5, 0, 0}) + beam(2, {0, 0, 0.25}, {0, 0.5, 0}) + beam_section + elastic +
                         contact_of("AUTOMATIC_GENERAL"),
                     down(50, 2), steps(5e-3));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  const Watched w = throw_down(scene, 50, 1);
  EXPECT_GT(w.deepest, 0.4) << "beyond the mid-line by more than the contact distance";
  EXPECT_NEAR(w.speed_up, 0, 1.5);
  EXPECT_NEAR(w.speed_down, -50, 1.5);
  EXPECT_GT(w.impulse, 0);
}

TEST(EdgePass, InitialDepthIsForgivenOrForcedAtOnce) {
  ContactScene kept(crossing_beams(0.15, contact_of("AUTOMATIC_GENERAL", "0.\n1.,1.\n0\n0.\n1,1\n")), {}, steps(1e-3));
  ASSERT_TRUE(kept.stepper) << kept.why_not;
  kept.step(20);
  EXPECT_EQ(kept.state().x[0], kept.initial.x[0]);
  ASSERT_EQ(kept.contacts->nodes(0).size(), 1u);
  EXPECT_EQ(kept.contacts->nodes(0)[0].kind, ContactNode::Kind::kept);
  EXPECT_NEAR(kept.contacts->nodes(0)[0].forgiven, 0.05, 1e-7);
  // They cross at x = 0.05, which is nearer to the second end of the first beam, and at y = 0.
  const auto id = [&](NodeIndex n) { return kept.read.model.mesh.nodes.id[n.value]; };
  EXPECT_EQ(id(kept.contacts->nodes(0)[0].node), 12);
  EXPECT_EQ(id(kept.contacts->nodes(0)[0].segment[0]), 21);
  EXPECT_EQ(id(kept.contacts->nodes(0)[0].segment[1]), 22);
  std::vector<ContactLink> links;
  kept.contacts->links(0, links);
  ASSERT_EQ(links.size(), 1u);
  EXPECT_NEAR((links[0].tracked.of(kept.state().x) - Vector(0.05, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((links[0].reference.of(kept.state().x) - Vector(0.05, 0, 0.15)).norm(), 0, 1e-12);
  ContactScene forced(crossing_beams(0.15, contact_of("AUTOMATIC_GENERAL", "0.\n")), {}, steps(1e-3));
  forced.step(1);
  ASSERT_EQ(forced.contacts->nodes(0).size(), 1u);
  EXPECT_EQ(forced.contacts->nodes(0)[0].kind, ContactNode::Kind::touching);
  // What the audit measures is what the solver has.
  contact::InitialCounters counters;
  contact::InitialOptions options;
  options.edges = true;
  const auto audit = contact::initialise_contacts(kept.read.model, kept.surfaces, options, counters);
  ASSERT_EQ(audit.penetrations.size(), 1u);
  EXPECT_EQ(audit.penetrations[0].depth, kept.contacts->nodes(0)[0].forgiven);
}

TEST(EdgePass, FrictionStopsTheSlidingAndDampingTakesEnergy) {
  for (const bool rubs : {true, false}) {
    const std::string law = rubs ? "0.5,0.5\n" : "0.,0.,0.,0.,40.\n";
    ContactScene scene(
        beam(1, {0, 0, 0}, {0.5, 0, 0}) + beam(2, {0, 0, 0.21}, {0, 0.5, 0}) + beam_section + elastic +
            contact_of("AUTOMATIC_GENERAL", law + "1.,1.\n0\n0.,0,0,1\n"),
        [](Structure& s) {
          for (std::size_t i = 2; i < 4; ++i) s.state.v[i] = {2, 0, -0.5};
        },
        steps(5e-4));
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    while (scene.state().time < 0.2) scene.step();
    EXPECT_GT(rubs ? scene.result().friction : scene.result().damping, 0);
    EXPECT_EQ(rubs ? scene.result().damping : scene.result().friction, 0);
    EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 1e-9);
    if (rubs) {
      EXPECT_LT((scene.state().v[2] + scene.state().v[3] - scene.state().v[0] - scene.state().v[1]).x() / 2, 1.8);
    }
  }
}

TEST(EdgePass, Type13ReleasesWhatType26KeepsPushing) {
  // A node of a plate far behind the contact surface of another.
  const auto plates = [](const std::string& type) {
    return shell(1, {Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)}) +
           shell(2,
                 {Vector(-0.1, -0.1, 0.03), Vector(0.1, -0.1, 0.03), Vector(0.1, 0.1, 0.03), Vector(-0.1, 0.1, 0.03)}) +
           shell_section + elastic + "*CONTROL_CONTACT\n0.1\n0,0,0,0,4,1\n" + contact_of(type);
  };
  ContactScene lost(plates("AUTOMATIC_SINGLE_SURFACE"), {}, steps(0)), kept(plates("AUTOMATIC_GENERAL"), {}, steps(0));
  ASSERT_TRUE(lost.stepper && kept.stepper);
  lost.step();
  kept.step();
  EXPECT_EQ(lost.result().released, 4u);
  EXPECT_EQ(lost.result().touching, 0u);
  EXPECT_EQ(kept.result().released, 0u);
  EXPECT_EQ(kept.result().touching, 4u);
}

// Two sheets in one plane whose rims meet: nothing but type 22 sees them.
TEST(EdgePass, SingleEdgeKeepsRimsApartInTheirPlane) {
  const auto sheets = [](const std::string& contact) {
    return shell(1, {Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)}) +
           shell(2, {Vector(1.25, 0.2, 0), Vector(2.25, 0.2, 0), Vector(2.25, 0.8, 0), Vector(1.25, 0.8, 0)}) +
           shell_section + elastic + "*SET_PART_LIST\n5\n1,2\n" + contact;
  };
  ContactScene scene(
      sheets("*CONTACT_SINGLE_EDGE\n5,0,2\n0.\n1.,1.\n0\n0.,0,0,1\n"),
      [](Structure& s) {
        for (std::size_t i = 4; i < 8; ++i) s.state.v[i] = {-0.5, 0, 0};
      },
      steps(0));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  double gap = 1, greatest = 0;
  while (scene.state().time < 3) {
    scene.step();
    gap = std::min(gap, scene.state().x[4].x() - scene.state().x[1].x());
    for (const ContactNode& n : scene.contacts->nodes(0)) greatest = std::max(greatest, n.force.norm());
  }
  EXPECT_GT(greatest, 0);
  EXPECT_GT(gap, 0.02);
  EXPECT_LT(scene.state().v[1].x(), -0.05);
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.01);
  EXPECT_TRUE(scene.result().single_surface);
}

struct Hay {
  std::string deck;
  std::vector<EdgeTwin::Line> lines;
};

/// Beams anywhere in a box, no two with a common node.
Hay hay(unsigned seed, int count, double box) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(0, box), reach(-0.5, 0.5);
  Hay hay;
  hay.deck = "*PART\nb\n1,9,1\n" + beam_section + elastic;
  std::string nodes = "*NODE\n", beams = "*ELEMENT_BEAM\n";
  for (int i = 0; i < count; ++i) {
    const Vector x(at(random), at(random), at(random)), half(reach(random), reach(random), reach(random));
    nodes += node(2 * i + 1, x - half) + node(2 * i + 2, x + half);
    beams += fmt::format("{0},1,{1},{2}\n", i + 1, 2 * i + 1, 2 * i + 2);
    hay.lines.push_back({static_cast<std::size_t>(2 * i), static_cast<std::size_t>(2 * i + 1), 0.1});
  }
  hay.deck += nodes + beams + contact_of("AUTOMATIC_GENERAL");
  return hay;
}

/// The pass alone, on coordinates that the test moves.
struct Alone {
  explicit Alone(const std::string& deck)
      : read(model::read_text(deck)),
        surfaces(read.model),
        masses(read.model),
        search(contact::make_bucket_grid()),
        ties(read.model),
        movable(read.model.mesh.nodes.size(), true),
        setting{read.model, masses, *search, ties, movable, shared} {
    EXPECT_EQ(read.errors(), 0u) << read.text();
    state.x = read.model.mesh.nodes.x;
    state.v.assign(state.x.size(), Vector::Zero());
    pass = std::make_unique<EdgePass>(setting, ContactIndex{0}, surfaces.at(ContactIndex{0}), state.x);
    pass->set_timestep(1e-3);
    result.single_surface = true;
  }
  std::vector<Vector> forces(double used) {
    Forces all;
    all.resize(state.x.size());
    pass->advance_state(state, used, counters);
    pass->add_forces(state, all, result);
    return all.force;
  }
  model::Read read;
  contact::SurfaceStore surfaces;
  ContactMasses masses;
  std::unique_ptr<contact::CandidateSearch> search;
  contact::TiedPairs ties;
  std::vector<bool> movable;
  SharedTables shared;
  ContactSetting setting;
  State state;
  ContactState result;
  ContactCounters counters;
  std::unique_ptr<EdgePass> pass;
};

// A pair that touches is no candidate any more when it is farther past the mid-line than candidates lie apart: it
// stays.
TEST(EdgePass, PairsInContactStayHoweverDeep) {
  Alone run(crossing_beams(0.15, contact_of("AUTOMATIC_GENERAL")));
  constexpr double margin = 0.01, h = 0.2, stiffness = 0.1 * (1000 / 1.5) * h;
  double distance = 0.15;
  for (int i = 0; i < 40; ++i) {
    run.pass->find_candidates(margin, run.counters);
    const std::vector<Vector> forces = run.forces(0);
    ASSERT_NEAR((forces[2] + forces[3]).z(), stiffness * (h - distance), 1e-6 * stiffness) << distance;
    distance -= 0.01;
    for (const std::size_t node : {2u, 3u}) run.state.x[node].z() -= 0.01;
  }
}

// IGNORE = 1 forgives what jumps into the contact distance from out of sight, and nothing of an approach that was
// followed: sight ends at twice the distance.
TEST(EdgePass, OnlyJumpsAreForgiven) {
  for (const bool jumps : {true, false}) {
    const double start = jumps ? 0.45 : 0.35;
    ContactScene scene(crossing_beams(start, contact_of("AUTOMATIC_GENERAL", "0.\n1.,1.\n0\n0.\n1,1\n")),
                       down((start - 0.15) / 1e-2, 2), steps(1e-2));
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    scene.step(2);
    const std::vector<ContactNode> nodes = scene.contacts->nodes(0);
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_NEAR(nodes[0].penetration, 0.05, 1e-6);
    EXPECT_NEAR(nodes[0].forgiven, jumps ? 0.05 : 0, 1e-6);
    EXPECT_EQ(nodes[0].kind, jumps ? ContactNode::Kind::kept : ContactNode::Kind::touching);
  }
}

TEST(EdgePass, AgreesWithTheSlowTwin) {
  std::size_t touched = 0, deep = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Hay scene = hay(seed, 120, 2.5);
    Alone run(scene.deck);
    const double radius = run.read.model.sections[0].beam_radius;
    for (EdgeTwin::Line& line : scene.lines) line.radius = radius;
    EdgeTwin twin(scene.lines, 0.1 * (1000 / 1.5) * 2 * radius);
    std::mt19937 random(seed);
    std::normal_distribution<double> kick(0, 0.004);
    std::vector<Vector> way(run.state.x.size());
    double used = 0;
    constexpr double margin = 0.1;
    run.pass->find_candidates(margin, run.counters);
    for (int cycle = 0; cycle < 60; ++cycle) {
      if (cycle % 10 == 0)
        for (Vector& w : way) w = {kick(random), kick(random), kick(random)};
      double longest = 0;
      for (std::size_t i = 0; cycle > 0 && i < way.size(); ++i) {
        run.state.x[i] += way[i];
        longest = std::max(longest, way[i].norm());
      }
      used += 2 * longest;
      if (used > margin) {
        run.pass->find_candidates(margin, run.counters);
        used = 0;
      }
      if (cycle == 25) {  // as when elements have failed
        const contact::ContactSurfaces& surfaces = run.surfaces.at(ContactIndex{0});
        auto next = std::make_unique<EdgePass>(run.setting, ContactIndex{0}, surfaces, run.state.x);
        next->set_timestep(1e-3);
        next->continue_from(*run.pass, run.state, run.result);
        run.pass = std::move(next);
        run.pass->find_candidates(margin, run.counters);
        used = 0;
      }
      const std::vector<Vector> forces = run.forces(used), expected = twin.cycle(run.state.x);
      double largest = 1e-3;
      for (const Vector& f : expected) largest = std::max(largest, f.norm());
      for (std::size_t i = 0; i < forces.size(); ++i)
        ASSERT_LE((forces[i] - expected[i]).norm(), 1e-10 * largest)
            << "node " << i + 1 << " cycle " << cycle << " seed " << seed;
      touched += twin.touching();
      deep += twin.passed();
    }
    EXPECT_LT(run.counters.pairs, 60u * 120 * 119 / 2) << "pairs that are far apart cost nothing";
  }
  EXPECT_GT(touched, 5000u);
  EXPECT_GT(deep, 50u) << "pairs that are past each other's mid-lines";
}

TEST(EdgePass, SameBitsForAnyNumberOfThreads) {
  const Hay scene = hay(7, 2000, 6);
  const auto run = [&](std::size_t jobs) {
    const JobLimit limit(jobs);
    Alone alone(scene.deck);
    alone.pass->find_candidates(0.1, alone.counters);
    return std::pair(alone.forces(0), alone.result.energy_a);
  };
  const auto one = run(1), four = run(4);
  EXPECT_EQ(one.first, four.first);
  EXPECT_EQ(one.second, four.second);
}

}  // namespace
}  // namespace gapcheck::solver::edge_pass_test
