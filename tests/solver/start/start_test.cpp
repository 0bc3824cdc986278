// What a run starts with: closed forms on small scenes, and on every deck of data/ the first cycle of the run itself.
#include "solver/start/start.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "solver/run.hpp"
#include "solver/start/start_moves.hpp"

namespace gapcheck::solver::start_test {
namespace {

namespace fs = std::filesystem;

/// A deck as the program reads it, and its start.
struct Followed {
  explicit Followed(Result<keyword::Deck> read) {
    if (!read) {
      ADD_FAILURE() << read.error().message;
      return;
    }
    deck.emplace(std::move(read).value());
    auto built = model::read_model(*deck, diagnostics);
    if (!built) {
      ADD_FAILURE() << built.error().message;
      return;
    }
    model = std::move(built).value();
    surfaces.emplace(model);
    start = follow_start(*deck, model, *surfaces, diagnostics);
  }
  [[nodiscard]] const Vector& x(std::int64_t node) const { return start.x[*model.mesh.nodes.lookup.find(node)]; }
  [[nodiscard]] const StartReport& report() const { return start.report; }
  [[nodiscard]] std::string score_of(std::size_t contact) const { return score(start.report.contacts.at(contact)); }

  Diagnostics diagnostics;
  std::optional<keyword::Deck> deck;
  model::Model model;
  std::optional<contact::SurfaceStore> surfaces;
  Start start;
};

Followed follow_file(const std::string& path) {
  Diagnostics diagnostics;
  return Followed(keyword::read_deck((fs::path(GAPCHECK_ROOT) / "data" / path).string(), {}, diagnostics));
}

Followed follow_text(const std::string& text) {
  Diagnostics diagnostics;
  return Followed(keyword::read_deck_text("*KEYWORD\n" + text + "*END\n", "scene.k", {}, diagnostics));
}

/// Young's modulus 2.1, Poisson's ratio 0.3: bulk modulus 1.75.
constexpr double bulk = 1.75;

/// A shell part with its section of thickness `t` and all materials alike.
std::string part(int id, double t) {
  return fmt::format("*PART\np{0}\n{0},{0},1\n*SECTION_SHELL\n{0},2\n{1},{1},{1},{1}\n", id, t);
}

std::string material() { return "*MAT_ELASTIC\n1,1.,2.1,0.3\n*CONTROL_TERMINATION\n1.\n"; }

/// A shell in a plane of constant z, 4 nodes from `first` on.
std::string sheet(int part, int first, double x0, double x1, double y0, double y1, double z) {
  std::string text = "*NODE\n";
  const double x[] = {x0, x1, x1, x0}, y[] = {y0, y0, y1, y1};
  for (int i = 0; i < 4; ++i) text += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", first + i, x[i], y[i], z);
  return text + fmt::format("*ELEMENT_SHELL\n{0},{1},{0},{2},{3},{4}\n", first, part, first + 1, first + 2, first + 3);
}

/// Nodes of part `a` against part `b`; `sst`: contact thickness of both, 0: theirs.
std::string nodes_to_part(int id, int a, int b, int ignore = 0, int snlog = 0, double sst = 0) {
  return fmt::format(
      "*CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID\n{},scene\n{},{},3,3\n0.\n1.,1.,{},{}\n0\n0.,0,0,{}\n0,{}\n", id, a, b,
      sst, sst, snlog, ignore);
}

/// A plate of 5 x 5 at z = 0 with a small sheet of 1 x 1 above it at z = 0.7: h = 1, p = 0.3.
std::string two_plates(int ignore, int snlog) {
  return material() + part(1, 1) + part(2, 1) + sheet(1, 1, 0, 5, 0, 5, 0) + sheet(2, 11, 2, 3, 2, 3, 0.7) +
         nodes_to_part(1, 2, 1, ignore, snlog);
}

TEST(Start, ShootingNodesMoveBy1002OfTheirDepth) {
  const Followed run = follow_text(two_plates(0, 0));
  const StartReport& report = run.report();
  ASSERT_TRUE(report.first_cycle) << (report.refused.empty() ? "" : report.refused.front().why);
  EXPECT_EQ(report.moved, 4u);
  for (const int node : {11, 12, 13, 14}) EXPECT_NEAR(run.x(node).z(), 0.7 + 1.002 * 0.3, 1e-15);
  for (const int node : {1, 2, 3, 4}) EXPECT_EQ(run.x(node).z(), 0);
  EXPECT_EQ(run.score_of(0), "starts moved by at most 0.3006");
  ASSERT_EQ(report.pairs.size(), 1u);
  const StartPair& pair = report.pairs.front();
  EXPECT_EQ(pair.part, 2);
  EXPECT_EQ(pair.other_part, 1);
  EXPECT_EQ(pair.moved, 4u);
  EXPECT_NEAR(pair.total_move, 4 * 0.3006, 1e-14);
  EXPECT_EQ(std::count(pair.histogram.begin(), pair.histogram.end(), 0u), 4) << "all in one bin";
  EXPECT_EQ(pair.energy, 0);
  EXPECT_EQ(pair.shapes.touched, 1u);
  EXPECT_EQ(pair.shapes.changed, 0u) << "the sheet moves as a whole";
  EXPECT_FALSE(starts_clean(report));
  ASSERT_EQ(report.moves.size(), 4u);
  for (const StartMove& move : report.moves) EXPECT_EQ(move.cause, StartCause::shot);
}

// k of the plate: 0.1 K A / longest diagonal = 0.1 * 1.75 * 25 / (5 sqrt 2); of the sheet's nodes: the same with A = 1.
// The spring has the smaller one, and each of four nodes is 0.3 deep.
TEST(Start, EnergyFromNothingIsHalfOfStiffnessTimesSquaredDepth) {
  const Followed run = follow_text(two_plates(0, 1));
  const StartReport& report = run.report();
  const double by_node = 0.1 * bulk * 1 / std::sqrt(2.0), by_plate = 0.1 * bulk * 25 / (5 * std::sqrt(2.0));
  const double energy = 4 * std::min(by_node, by_plate) * 0.3 * 0.3 / 2;
  EXPECT_NEAR(report.energy, energy, 1e-12 * energy);
  EXPECT_NEAR(report.contacts[0].energy, energy, 1e-12 * energy);
  ASSERT_EQ(report.pairs.size(), 1u);
  EXPECT_NEAR(report.pairs[0].energy, energy, 1e-12 * energy);
  EXPECT_EQ(report.pairs[0].forced, 4u);
  EXPECT_NEAR(report.pairs[0].deepest_forced, 0.3, 1e-15);
  // PENMAX 0.4 of both thicknesses: 0.8 deep a node is lost.
  ASSERT_TRUE(report.pairs[0].to_release);
  EXPECT_NEAR(*report.pairs[0].to_release, 0.5, 1e-15);
  EXPECT_EQ(report.moved, 0u);
  EXPECT_EQ(run.score_of(0), fmt::format("starts with an energy of {:.6g} from nothing", energy));
  EXPECT_EQ(report.kinetic, 0);
}

TEST(Start, ForgivenDepthLeavesAShareOfTheThickness) {
  const Followed run = follow_text(two_plates(1, 0));
  const StartPair& pair = run.report().pairs.at(0);
  EXPECT_EQ(pair.kept, 4u);
  EXPECT_NEAR(pair.deepest_kept, 0.3, 1e-15);
  EXPECT_NEAR(pair.least_share.value(), 0.7, 1e-15);
  EXPECT_EQ(pair.energy, 0);
  EXPECT_EQ(run.score_of(0), "starts with 70 % of its thickness");
}

TEST(Start, DeepNodesAreLost) {
  const Followed run = follow_text(material() + part(1, 1) + part(2, 1) + sheet(1, 1, 0, 5, 0, 5, 0) +
                                   sheet(2, 11, 2, 3, 2, 3, 0.1) + nodes_to_part(1, 2, 1));
  const StartPair& pair = run.report().pairs.at(0);
  EXPECT_EQ(pair.released, 4u);
  EXPECT_NEAR(pair.way_out, 0.9, 1e-15);
  EXPECT_EQ(run.report().moved, 0u);
  EXPECT_EQ(run.score_of(0), "loses 4 nodes");
}

TEST(Start, TouchingPlatesStartClean) {
  const Followed run = follow_text(material() + part(1, 1) + part(2, 1) + sheet(1, 1, 0, 5, 0, 5, 0) +
                                   sheet(2, 11, 2, 3, 2, 3, 1.0) + nodes_to_part(1, 2, 1));
  EXPECT_EQ(run.score_of(0), "starts clean");
  EXPECT_TRUE(starts_clean(run.report()));
  EXPECT_TRUE(run.report().pairs.empty());
  EXPECT_EQ(run.start.x, run.model.mesh.nodes.x);
}

TEST(Start, TiedNodesMoveOntoTheSegment) {
  const Followed run =
      follow_text(material() + part(1, 1) + part(2, 1) + sheet(1, 1, 0, 5, 0, 5, 0) + sheet(2, 11, 2, 3, 2, 3, 0.25) +
                  "*SET_NODE_LIST\n7\n11,12,13,14\n*CONTACT_TIED_NODES_TO_SURFACE_ID\n4,tie\n"
                  "7,1,4,3\n0.\n1.,1.\n");
  const StartReport& report = run.report();
  ASSERT_EQ(report.moves.size(), 4u);
  for (const StartMove& move : report.moves) {
    EXPECT_EQ(move.cause, StartCause::tied);
    EXPECT_NEAR((move.to - move.from).norm(), 0.25, 1e-15);
    EXPECT_EQ(move.other_part, 1);
  }
  EXPECT_NEAR(run.x(11).z(), 0, 1e-15);
  EXPECT_EQ(run.score_of(0), "starts moved by at most 0.25");
}

// The middle sheet is 0.2 deep in the lower plate and goes up by 0.2004; then it is 0.4004 deep in the upper one and
// goes down by 0.4012008. In the first cycle it is 0.4008008 deep in the lower plate again, which has met it before:
// force from nothing.
TEST(Start, PingPongEndsWithEnergyInTheFirstContact) {
  const Followed run = follow_text(material() + part(1, 1) + part(2, 1) + part(3, 1) + sheet(1, 1, 0, 5, 0, 5, 0) +
                                   sheet(2, 11, 2, 3, 2, 3, 0.8) + sheet(3, 21, 0, 5, 0, 5, 1.6) +
                                   nodes_to_part(1, 2, 1) + nodes_to_part(2, 2, 3));
  const StartReport& report = run.report();
  const double up = 1.002 * 0.2, down = 1.002 * (1 - (1.6 - 0.8 - up)), z = 0.8 + up - down;
  for (const int node : {11, 12, 13, 14}) EXPECT_NEAR(run.x(node).z(), z, 1e-14);
  ASSERT_EQ(report.repeats.size(), 4u);
  for (const StartRepeat& repeat : report.repeats) {
    EXPECT_EQ(repeat.contacts, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(repeat.back);
    EXPECT_NEAR(repeat.path, up + down, 1e-14);
    EXPECT_NEAR(repeat.net, down - up, 1e-14);
  }
  const double k = 0.1 * bulk / std::sqrt(2.0), depth = 1 - z;
  EXPECT_EQ(report.contacts[0].forced, 4u);
  EXPECT_NEAR(report.contacts[0].energy, 4 * k * depth * depth / 2, 1e-12);
  EXPECT_EQ(report.contacts[1].forced, 0u);
  EXPECT_NEAR(report.contacts[0].largest_move, up, 1e-14);
  EXPECT_NEAR(report.contacts[1].largest_move, down, 1e-14);
}

// Contact 1 comes first and finds nothing; contact 2 then moves the nodes up through the sheet of part 3, and with them
// the shell between nodes that move and nodes that stay.
TEST(Start, AMoveThroughASheetCreatesACrossing) {
  const Followed run = follow_text(material() + part(1, 1) + part(2, 1) + part(3, 1) + sheet(1, 1, 0, 4, 0, 4, 0) +
                                   sheet(2, 11, 1, 10, 1, 3, 0.6) + sheet(3, 21, -2, 20, -2, 6, 0.9) +
                                   nodes_to_part(1, 2, 3, 0, 0, 0.02) + nodes_to_part(2, 2, 1));
  const StartReport& report = run.report();
  EXPECT_NEAR(run.x(11).z(), 0.6 + 1.002 * 0.4, 1e-14);
  EXPECT_EQ(run.x(12).z(), 0.6);
  ASSERT_EQ(report.crossings.size(), 1u);
  const StartCrossing& crossing = report.crossings.front();
  EXPECT_EQ(std::min(crossing.a.id, crossing.b.id), 11);
  EXPECT_EQ(std::max(crossing.a.id, crossing.b.id), 21);
  EXPECT_EQ(crossing.contact, 1);
  EXPECT_EQ(crossing.moved_by, 2);
  EXPECT_NEAR(crossing.depth, 1.0008 - 0.9, 1e-12) << "the end above the sheet; the other end is 0.3 below";
  EXPECT_EQ(run.score_of(0), "starts clean");
  EXPECT_FALSE(starts_clean(report));
}

// A sheet that stands on the plate: its lower nodes, 0.7 deep, go up by 0.7014, past its upper ones at z = 1.
TEST(Start, AShellIsTurnedInsideOut) {
  const std::string standing =
      "*NODE\n11,2.,2.,0.3\n12,3.,2.,0.3\n13,3.,2.,1.\n14,2.,2.,1.\n*ELEMENT_SHELL\n11,2,11,12,13,14\n";
  const Followed run = follow_text(material() + part(1, 1) + part(2, 1) + sheet(1, 1, 0, 5, 0, 5, 0) + standing +
                                   nodes_to_part(1, 2, 1));
  const StartReport& report = run.report();
  ASSERT_EQ(report.elements.size(), 1u);
  const StartElement& shell = report.elements.front();
  EXPECT_EQ(shell.id, 11);
  EXPECT_EQ(shell.contact, 1);
  EXPECT_TRUE(shell.inverted);
  EXPECT_NEAR(shell.before.size, 0.7, 1e-14);
  EXPECT_NEAR(shell.after.size, -0.0014, 1e-14);
  EXPECT_NEAR(shell.before.edge_ratio, 1 / 0.7, 1e-14);
  EXPECT_NEAR(shell.after.edge_ratio, 1 / 0.0014, 1e-9);
  // A / longest side over the speed of sound, sqrt(E / (rho (1 - nu^2))).
  const double speed = std::sqrt(2.1 / (1 - 0.09));
  EXPECT_NEAR(shell.before.step, 0.7 / speed, 1e-14);
  EXPECT_NEAR(shell.after.step, 0.0014 / speed, 1e-14);
  EXPECT_EQ(report.shapes.collapsed, 1u);
  EXPECT_NEAR(report.step_after, 0.0014 / speed, 1e-14);
}

TEST(Start, ARefusedDeckIsFollowedThroughItsInitialisation) {
  const Followed run =
      follow_text("*PART\np1\n1,1,1\n*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n*MAT_WOOD\n1,1.\n" + part(2, 1) +
                  sheet(1, 1, 0, 5, 0, 5, 0) + sheet(2, 11, 2, 3, 2, 3, 0.7) + nodes_to_part(1, 2, 1));
  const StartReport& report = run.report();
  EXPECT_FALSE(report.first_cycle);
  ASSERT_FALSE(report.refused.empty());
  EXPECT_TRUE(std::any_of(report.refused.begin(), report.refused.end(),
                          [](const StartRefusal& r) { return r.keyword == "MAT_WOOD" && r.line > 0; }));
  EXPECT_NEAR(run.x(11).z(), 0.7 + 1.002 * 0.3, 1e-15);
  EXPECT_EQ(run.score_of(0), "starts moved by at most 0.3006");
  EXPECT_FALSE(report.kinetic);
}

/// The first cycle of a run, calculated apart.
class FirstState : public Run::Observer {
 public:
  SolverStatus observe(const Run& run, std::optional<RunEnd> /*end*/) override {
    if (run.stepper().state().cycle > 0) return {};
    x = run.stepper().state().x;
    const model::Model& model = run.model();
    at_rest = model.initial_velocities.empty() && model.node_velocities.empty() && model.prescribed_motions.empty();
    for (const ContactView& view : run.contacts()) {
      const std::uint32_t contact = view.state().contact.value;
      if (!view.stored()) continue;
      given[contact] -= view.state().lost;
      for (const ContactNode& node : view.nodes())
        if (node.kind == ContactNode::Kind::touching)
          by_force[contact] += node.force.norm() * (node.penetration - node.forgiven) / 2;
    }
    return {};
  }
  std::vector<Vector> x;
  std::map<std::uint32_t, double> given;     ///< by contact: what its springs had at the start, which nobody paid for
  std::map<std::uint32_t, double> by_force;  ///< the same as half of force times depth, where nothing rubs
  bool at_rest = false;                      ///< nothing moves at the start, so nothing rubs
};

/// The moves one after the other lead from the deck to the start, and each begins where the one before has ended.
void expect_moves_lead_there(const Followed& run) {
  std::vector<Vector> x = run.model.mesh.nodes.x;
  for (const StartMove& move : run.report().moves) {
    Vector& node = x[*run.model.mesh.nodes.lookup.find(move.node)];
    EXPECT_EQ(node, move.from) << move.node;
    node = move.to;
  }
  EXPECT_EQ(x, run.start.x);
}

std::vector<std::string> all_decks() {
  std::vector<std::string> names;
  const fs::path data = fs::path(GAPCHECK_ROOT) / "data";
  for (const auto& entry : fs::recursive_directory_iterator(data))
    if (entry.path().extension() == ".k" && entry.path().parent_path().filename() != "include")
      names.push_back(entry.path().lexically_relative(data).generic_string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Start, IsTheFirstCycleOfTheRunOnEveryDeck) {
  std::size_t compared = 0, moved = 0, forced = 0, alone = 0;
  double worst = 0;
  for (const std::string& name : all_decks()) {
    SCOPED_TRACE(name);
    const Followed run = follow_file(name);
    expect_moves_lead_there(run);
    Diagnostics diagnostics;
    contact::SurfaceStore surfaces(run.model);
    RunSettings settings;
    settings.cycles = 2;
    auto prepared = Run::prepare(run.model, surfaces, settings, diagnostics);
    if (!prepared) {
      ++alone;
      EXPECT_FALSE(run.report().first_cycle);
      EXPECT_FALSE(run.report().refused.empty());
      continue;
    }
    FirstState first;
    prepared.value().go(first);
    ASSERT_TRUE(run.report().first_cycle);
    ++compared;
    moved += run.report().moved;
    EXPECT_EQ(run.start.x, first.x);
    for (const auto& [contact, energy] : first.given) {
      const double said = run.report().contacts[contact].energy;
      EXPECT_NEAR(said, energy, 1e-9 * std::abs(energy));
      if (first.at_rest && !run.model.contacts[contact].options.mortar) {
        EXPECT_NEAR(said, first.by_force[contact], 1e-9 * std::abs(energy)) << "contact " << contact;
      }
      if (energy > 0) worst = std::max(worst, std::abs(said / energy - 1)), ++forced;
    }
    for (const StartContact& contact : run.report().contacts)
      if (contact.no_energy.empty()) {
        double sum = 0;
        for (const StartPair& pair : run.report().pairs)
          if (run.report().contacts[pair.contact].id == contact.id) sum += pair.energy;
        EXPECT_NEAR(sum, contact.energy, 1e-9 * contact.energy) << "contact " << contact.id;
      }
  }
  fmt::print(
      "{} decks compared, {} by their initialisation alone; {} nodes moved; {} contacts with energy, largest "
      "relative difference {:.3g}\n",
      compared, alone, moved, forced, worst);
  EXPECT_GT(compared, 60u);
  EXPECT_GT(moved, 50u);
  EXPECT_GT(forced, 0u);
}

}  // namespace
}  // namespace gapcheck::solver::start_test
