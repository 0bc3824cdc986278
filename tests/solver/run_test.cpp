#include "solver/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>

#include "base/parallel.hpp"
#include "folder_test.hpp"
#include "results/curves/glstat.hpp"
#include "results/d3plot/d3plot_states.hpp"
#include "results/log/solver_log.hpp"
#include "solver/output/plot.hpp"
#include "solver/output/run_files.hpp"
#include "solver/run_scene.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::run_test {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A strip of four shells along x, whose last nodes are pulled until 0.25; it ends at 0.5.
std::string strip(const std::string& more) {
  return "*TITLE\na strip\n*CONTROL_TERMINATION\n0.5\n" + plate(4, 1, {0.5, 0.5, 0}) +
         elastic_deck(shell_section, 1000, 0.3, 1) +
         "*LOAD_NODE_POINT\n5,1,1,1.\n10,1,1,1.\n*DEFINE_CURVE\n1\n0.,1.\n0.25,1.\n0.2501,0.\n1.,0.\n" + more;
}

class RunTest : public FolderTest {
 protected:
  struct Ended {
    RunEnd end = RunEnd::failed;
    std::uint64_t cycles = 0;
    double time = 0;
    std::string failure;
    std::vector<std::string> names;
    Energies energies;
  };
  Ended calculate(const std::string& deck, RunSettings settings = {}, RunFilesSettings files = {}) {
    model_ = model::read_text(deck).model;
    contact::SurfaceStore surfaces(model_);
    Diagnostics diagnostics;
    auto prepared = solver::Run::prepare(model_, surfaces, settings, diagnostics);
    Ended ended;
    if (!prepared) {
      ended.failure = prepared.error().message;
      return ended;
    }
    solver::Run& run = prepared.value();
    if (files.directory.empty()) files.directory = (folder_ / "out").string();
    files.program = "gapcheck 0.0.0";
    auto created = RunFiles::create(run, surfaces, files);
    if (!created) {
      ended.failure = created.error().message;
      return ended;
    }
    RunFiles& all = created.value();
    ended.end = run.go(all);
    ended.cycles = run.stepper().state().cycle;
    ended.time = run.stepper().state().time;
    ended.names = all.names();
    ended.energies = run.stepper().energies();
    if (!run.status().ok()) ended.failure = run.status().error().message;
    return ended;
  }
  [[nodiscard]] std::string file(const std::string& name) const { return contents(folder_ / "out" / name); }

  model::Model model_;
};

TEST_F(RunTest, FilesOfASmallDeck) {
  const Ended ended = calculate(
      strip("*DATABASE_GLSTAT\n0.1\n*DATABASE_MATSUM\n0.1\n*DATABASE_NODOUT\n0.25\n*DATABASE_HISTORY_NODE\n5\n"
            "*DATABASE_BINARY_D3PLOT\n0.1\n"));
  ASSERT_EQ(ended.failure, "");
  EXPECT_EQ(ended.end, RunEnd::time);
  EXPECT_GE(ended.time, 0.5);
  EXPECT_EQ(ended.names, (std::vector<std::string>{"messag", "d3hsp", "glstat", "matsum", "nodout", "d3plot"}));
  const auto states = results::read_glstat(file("glstat"));
  ASSERT_EQ(states.size(), 6u);
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double wanted = 0.1 * static_cast<double>(i);
    EXPECT_GE(states[i].time, wanted - 1e-12);
    EXPECT_LT(states[i].time, wanted + 1.01 * states[i].time_step);
    EXPECT_NEAR(states[i].ratio, 1, 0.03);  // the first force acts for half a step only
    EXPECT_GT(states[i].external, 0);
    EXPECT_NEAR(states[i].total, states[i].kinetic + states[i].internal + states[i].hourglass, 1e-4 * states[i].total);
  }
  // All of the force went into the momentum: 2 forces of 1 over 0.25, mass 2 x 0.5 x 0.1.
  EXPECT_NEAR(states.back().velocity.x(), 2 * 0.25 / 0.1, 0.06 * 5);
  EXPECT_NEAR(states.back().kinetic, ended.energies.printed_kinetic, 1e-5 * ended.energies.printed_kinetic);
  const std::string matsum = file("matsum"), nodout = file("nodout");
  EXPECT_NE(matsum.find("        1     p "), std::string::npos);
  EXPECT_NE(nodout.find("\n        5 "), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "out" / "rcforc"));
}

TEST_F(RunTest, PlotHoldsTheState) {
  RunFilesSettings files;
  files.double_words = true;
  results::D3plotState last;
  files.on_plot = [&](const results::D3plotState& state, const solver::Run& run, std::size_t number) {
    EXPECT_EQ(state.time, run.stepper().state().time);
    EXPECT_GE(number, 1u);
    last = state;
    return SolverStatus();
  };
  const Ended ended = calculate(strip("*DATABASE_BINARY_D3PLOT\n0.1\n"), {}, files);
  ASSERT_EQ(ended.failure, "");
  const auto plot = results::D3plotStates::open((folder_ / "out" / "d3plot").string());
  ASSERT_TRUE(plot.ok()) << plot.error().message;
  EXPECT_EQ(plot.value().mesh().title, "a strip");
  EXPECT_EQ(plot.value().mesh().node_ids, model_.mesh.nodes.id);
  EXPECT_EQ(plot.value().mesh().shells.ids, model_.mesh.shells.id);
  ASSERT_EQ(plot.value().size(), 6u);
  const results::D3plotState state = plot.value().read(5);
  EXPECT_EQ(state.time, ended.time);
  EXPECT_EQ(state.coordinates, last.coordinates);
  EXPECT_EQ(state.velocities, last.velocities);
  EXPECT_EQ(state.kinetic, ended.energies.printed_kinetic);
  EXPECT_EQ(state.shells[0].thickness, 0.1);
  // Plane stress along x: the resultant is the stress times the thickness.
  const results::D3plotState pulled = plot.value().read(2);
  const double stress = pulled.shell_points[0].stress[0];
  EXPECT_GT(std::abs(stress), 1);
  EXPECT_NEAR(pulled.shells[0].resultants[5], 0.1 * stress, 1e-4 * std::abs(stress)) << "the side turns a little";
  EXPECT_NEAR(pulled.shell_points[1].stress[0], stress, 1e-9 * std::abs(stress)) << "no bending";
  EXPECT_NEAR(pulled.shell_points[0].stress[2], 0, 1e-9 * std::abs(stress));
  double energy = 0;
  for (const results::PartValues& part : pulled.parts) energy += part.internal;
  EXPECT_NEAR(energy, pulled.internal, 1e-9 * pulled.internal);
}

// Stresses are in global axes: the same strip along y has σyy for σxx.
TEST(Plot, StressesAreGlobal) {
  const Matrix axes = quad_axes({Vector(0, 0, 0), Vector(0, 2, 0), Vector(-1, 2, 0), Vector(-1, 0, 0)});
  EXPECT_EQ(Vector(axes.col(0)), Vector(0, 1, 0));
  EXPECT_EQ(Vector(axes.col(1)), Vector(-1, 0, 0));
  EXPECT_EQ(Vector(axes.col(2)), Vector(0, 0, 1));
}

TEST_F(RunTest, IntervalsWhereTheDeckGivesNone) {
  const Ended ended = calculate(strip(""));
  ASSERT_EQ(ended.failure, "");
  EXPECT_EQ(results::D3plotStates::open((folder_ / "out" / "d3plot").string()).value().size(),
            std::min<std::size_t>(21, ended.cycles + 1));
  const model::Output output = output_intervals(model_, 0.5);
  EXPECT_EQ(output.glstat, 0.0005);
  EXPECT_EQ(output.d3plot, 0.025);
  EXPECT_EQ(output.sleout, 0) << "no contacts";
  EXPECT_EQ(output.matsum, 0);
  EXPECT_EQ(output.nodout, 0) << "no history nodes";
  EXPECT_EQ(ended.names, (std::vector<std::string>{"messag", "d3hsp", "glstat", "d3plot"}));
}

/// Something of each cycle, by its number.
std::vector<double> history(const std::string& deck, const std::function<double(const solver::Run&)>& of) {
  std::vector<double> list;
  RunScene(deck).go([&](const solver::Run& run) { list.push_back(of(run)); });
  return list;
}

// In percent: the run ends in the first cycle in which the ratio is off by more than that.
TEST(RunEnds, EnergyRatio) {
  const std::vector<double> off =
      history(strip(""), [](const solver::Run& run) { return std::abs(run.stepper().energies().ratio() - 1); });
  const double most = *std::max_element(off.begin(), off.end());
  std::size_t first = 0;
  while (off[first] < most / 2) ++first;
  const double percent = 100.5 * off[first];  // a little more than what that cycle has
  const auto ends = std::find_if(off.begin(), off.end(), [&](double o) { return o > percent / 100; });
  ASSERT_NE(ends, off.end());
  std::string deck = strip("");
  deck.replace(deck.find("\n0.5\n") + 4, 0, fmt::format(",0,0.,{:.17g}", percent));
  RunScene scene(deck);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  EXPECT_EQ(scene.try_to_go(), RunEnd::energy);
  EXPECT_EQ(scene.state().cycle, static_cast<std::uint64_t>(ends - off.begin()));
  EXPECT_GT(scene.state().cycle, first);
}

// DTMIN: a share of the first step.
TEST(RunEnds, StepThatHasFallen) {
  const std::vector<double> steps =
      history(strip(""), [](const solver::Run& run) { return run.stepper().next_step(); });
  const double least = *std::min_element(steps.begin(), steps.end()), limit = (steps[0] + least) / 2;
  ASSERT_LT(least, 0.999 * steps[0]);
  const auto ends = std::find_if(steps.begin(), steps.end(), [&](double s) { return s < limit; });
  std::string deck = strip("");
  deck.replace(deck.find("\n0.5\n") + 4, 0, fmt::format(",0,{:.17g}", limit / steps[0]));
  RunScene scene(deck);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  EXPECT_EQ(scene.try_to_go(), RunEnd::step);
  EXPECT_EQ(scene.state().cycle, static_cast<std::uint64_t>(ends - steps.begin()));
}

/// Two cubes, one pressed flat. `controls`: fields of *CONTROL_TIMESTEP.
std::string pressed_cube(const std::string& controls) {
  std::string deck = "*NODE\n";
  for (int cube = 0; cube < 2; ++cube)
    for (int k = 0; k < 8; ++k)
      deck += fmt::format("{},{},{},{}\n", 10 * cube + k + 1, 3 * cube + (k % 4 == 1 || k % 4 == 2), k % 4 / 2, k / 4);
  return deck +
         "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,1,11,12,13,14,15,16,17,18\n*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n" +
         "*MAT_ELASTIC\n1,1.,100.,0.\n*BOUNDARY_SPC_SET\n1,0,1,1,1\n*SET_NODE_LIST\n1\n1,2,3,4\n" +
         "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,3,2,1,-1.\n*SET_NODE_LIST\n2\n5,6,7,8\n*DEFINE_CURVE\n1\n0.,0.\n1.,0.6\n" +
         "*CONTROL_TERMINATION\n1.,0,0.6\n*CONTROL_TIMESTEP\n" + controls + "\n";
}

// ERODE: the solid that is too flat goes in the cycle in which the run would end, and the other one stays.
TEST(RunEnds, SmallStepsErode) {
  RunScene ends(pressed_cube("0.,0.9"));
  ASSERT_TRUE(ends.prepared()) << ends.message();
  EXPECT_EQ(ends.try_to_go(), RunEnd::step);
  EXPECT_TRUE(ends.run().stepper().failures().empty());
  RunScene erodes(pressed_cube("0.,0.9,0,0.,0.,0,1"));
  ASSERT_TRUE(erodes.prepared()) << erodes.message();
  EXPECT_EQ(erodes.try_to_go(), RunEnd::time);
  ASSERT_EQ(erodes.run().stepper().failures().size(), 1u);
  EXPECT_EQ(erodes.run().stepper().failures()[0].element, 0u);
  EXPECT_EQ(erodes.run().stepper().failures()[0].time, ends.state().time);
}

// With hundreds of thousands of contacts that is a tenth of the memory of a run.
TEST(RunMemory, SummariesOfContactsAreFreed) {
  const model::Read read = model::read_text(
      strip("") + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n0.\n1.\n*CONTACT_AUTOMATIC_GENERAL\n0,0,5\n0.\n1.\n");
  contact::SurfaceStore surfaces(read.model);
  Diagnostics diagnostics;
  auto run = Run::prepare(read.model, surfaces, {}, diagnostics);
  ASSERT_TRUE(run);
  EXPECT_EQ(run.value().initial().contacts.size(), 2u);
  run.value().drop_contact_summaries();
  EXPECT_EQ(run.value().initial().contacts.capacity(), 0u);
}

TEST(RunEnds, CyclesOfTheDeck) {
  std::string deck = strip("");
  deck.replace(deck.find("\n0.5\n") + 4, 0, ",7");
  RunScene scene(deck);
  EXPECT_EQ(scene.try_to_go(), RunEnd::cycles);
  EXPECT_EQ(scene.state().cycle, 7u);
}

TEST_F(RunTest, Ends) {
  EXPECT_NE(calculate("*NODE\n1,0.,0.,0.\n").failure.find("ENDTIM"), std::string::npos);
  RunSettings settings;
  settings.cycles = 3;
  Ended ended = calculate(strip(""), settings);
  EXPECT_EQ(ended.end, RunEnd::cycles);
  EXPECT_EQ(ended.cycles, 3u);
  settings = {};
  settings.until = 0.05;
  EXPECT_LT(calculate(strip(""), settings).time, 0.1);
  settings = {};
  int asked = 0;
  settings.stop = [&] { return ++asked == 5; };
  ended = calculate(strip(""), settings);
  EXPECT_EQ(ended.end, RunEnd::stopped);
  EXPECT_EQ(ended.cycles, 4u);
  EXPECT_NE(file("messag").find("termination on request"), std::string::npos);
  EXPECT_EQ(results::read_glstat(file("glstat")).back().cycle, 5u) << "counted from 1";
}

TEST_F(RunTest, DirectoriesThatCannotBeMadeAreTold) {
  std::ofstream(folder_ / "file") << "x";
  RunFilesSettings files;
  files.directory = (folder_ / "file" / "out").string();
  EXPECT_NE(calculate(strip(""), {}, files).failure.find("file"), std::string::npos);
}

TEST_F(RunTest, ResultsThatAreNotThereAtTheEndAreTold) {
  using Change = void (*)(const fs::path&);
  const std::map<std::string, Change> changes{
      {"removed", [](const fs::path& file) { fs::remove(file); }},
      {"moved", [](const fs::path& file) { fs::rename(file, file.string() + "_old"); }},
      {"replaced", [](const fs::path& file) {
         fs::remove(file);
         std::ofstream(file) << "of others";
       }}};
  for (const auto& [what, change] : changes)
    for (const char* name : {"messag", "glstat", "d3plot", "d3plot01"}) {
      RunFilesSettings files;
      files.on_plot = [&, change = change](const results::D3plotState&, const solver::Run&, std::size_t number) {
        if (number == 2) change(folder_ / "out" / name);
        return SolverStatus();
      };
      const Ended ended = calculate(strip("*DATABASE_BINARY_D3PLOT\n0.1\n"), {}, files);
      EXPECT_EQ(ended.end, RunEnd::failed) << name << ' ' << what;
      EXPECT_NE(ended.failure.find(std::string("out/") + name + ": was removed, moved or replaced"), std::string::npos)
          << name << ' ' << what << ": " << ended.failure;
    }
}

TEST_F(RunTest, OtherFilesAreLeftAlone) {
  fs::create_directories(folder_ / "out");
  for (const char* name : {"notes", "d3plot01", "d3plot02", "rcforc"}) std::ofstream(folder_ / "out" / name) << "old";
  ASSERT_EQ(calculate(strip("")).failure, "");
  EXPECT_EQ(file("notes"), "old");
  EXPECT_FALSE(fs::exists(folder_ / "out" / "d3plot02")) << "it would be taken for further states";
  EXPECT_FALSE(fs::exists(folder_ / "out" / "rcforc")) << "of another run";
}

// Two plates that meet: forces of the contact in rcforc and ncforc, its work in sleout and glstat.
TEST_F(RunTest, WhatTheContactsReport) {
  const Ended ended = calculate(
      "*CONTROL_TERMINATION\n0.02\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n"
      "5,0.2,0.2,0.11\n6,0.8,0.2,0.11\n7,0.8,0.8,0.11\n8,0.2,0.8,0.11\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n" +
      elastic_deck(shell_section, 1000, 0.3, 1) +
      "*PART\nq\n2,1,1\n*SET_NODE_LIST\n4\n5,6,7,8\n*INITIAL_VELOCITY\n4\n0.,0.,-2.\n"
      "*CONTACT_FORCE_TRANSDUCER_PENALTY_ID\n9,upper\n2,0,3,0\n"
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n7,a pair\n2,1,3,3,0,0,1,0\n\n\n"
      "*DATABASE_RCFORC\n0.001\n*DATABASE_SLEOUT\n0.001\n*DATABASE_NCFORC\n0.001\n*DATABASE_GLSTAT\n0.001\n");
  ASSERT_EQ(ended.failure, "");
  const std::string rcforc = file("rcforc"), ncforc = file("ncforc");
  EXPECT_NE(rcforc.find("        7     a pair "), std::string::npos);
  // The transducer comes first, as in the deck, and says what the contact says of its side A.
  const std::size_t pair = rcforc.find("  SURFA           7"), measured = rcforc.find("  SURFA           9");
  ASSERT_LT(measured, pair);
  for (std::size_t at = pair; at != std::string::npos; at = rcforc.find("  SURFA           7", at + 1)) {
    const std::size_t other = rcforc.rfind("  SURFA           9", at);
    EXPECT_EQ(rcforc.substr(at + 19, 80), rcforc.substr(other + 19, 80));
  }
  EXPECT_EQ(file("sleout").find("\n         9  "), std::string::npos) << "it has no energies";
  // Both sides: opposite forces. The upper plate is pushed up.
  double greatest = 0;
  for (std::size_t at = rcforc.find("  SURFA           7"); at != std::string::npos;
       at = rcforc.find("  SURFA           7", at + 1)) {
    const std::size_t b = rcforc.find("  SURFB", at), z = rcforc.find(" z ", at), other = rcforc.find(" z ", b);
    const double force = std::atof(rcforc.c_str() + z + 3);
    EXPECT_NEAR(force, -std::atof(rcforc.c_str() + other + 3), 1e-4 * std::abs(force));
    greatest = std::max(greatest, force);
  }
  EXPECT_GT(greatest, 0.1);
  EXPECT_NE(ncforc.find("\n         5 "), std::string::npos);
  EXPECT_EQ(ncforc.find("\n         1 "), std::string::npos) << "only side A is printed (SAPR)";
  EXPECT_NE(file("sleout").find("\n         7  "), std::string::npos);
  double sliding = 0;
  for (const results::GlobalState& state : results::read_glstat(file("glstat"))) {
    sliding = std::max(sliding, state.sliding);
    EXPECT_NEAR(state.ratio, 1, 0.2);  // where all that moves turns round within a step, it would be negative
  }
  EXPECT_GT(sliding, 1e-4);
}

// messag and d3hsp say what the initialisation found, and the run starts where it left the nodes.
TEST_F(RunTest, ContactsAreInitialised) {
  const std::string two =
      "*CONTROL_TERMINATION\n0.001\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n"
      "5,0.2,0.2,0.06\n6,0.8,0.2,0.06\n7,0.8,0.8,0.06\n8,0.2,0.8,0.06\n9,5.,5.,5.\n10,6.,5.,5.\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,5,6,7,8\n" +
      elastic_deck(shell_section, 1000, 0.3, 1) + "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n3,all\n0\n\n\n";
  const Ended ended = calculate(two);
  ASSERT_EQ(ended.failure, "");
  Diagnostics diagnostics;
  const Report report = results::read_solver_log_text(file("messag"), "messag", {}, diagnostics);
  ASSERT_EQ(report.penetrations.size(), 4u);
  EXPECT_EQ(report.penetrations[0].depth, 0.04);
  EXPECT_EQ(report.run->termination, SolverRun::Termination::normal);
  EXPECT_EQ(report.run->cycles, static_cast<std::int64_t>(ended.cycles) + 1) << "counted from 1";
  const Report hsp = results::read_solver_log_text(file("d3hsp"), "d3hsp", {}, diagnostics);
  EXPECT_EQ(hsp.contacts[0].title, "all");
  EXPECT_EQ(hsp.penetrations.size(), 4u);
  const auto plot = results::D3plotStates::open((folder_ / "out" / "d3plot").string());
  EXPECT_NEAR(plot.value().mesh().coordinates[4][2], 0.06 + 1.002 * 0.04, 1e-6);
}

// A shell that is pulled until it fails: messag names it, d3plot has it deleted from then on, glstat and matsum say
// what it has taken up.
TEST_F(RunTest, FailedElementsInTheFiles) {
  const std::string deck =
      "*CONTROL_TERMINATION\n0.4\n" + plate(1, 1, {1, 1, 0}) +
      "*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0.1\n*MAT_PLASTIC_KINEMATIC\n1,1.,1000.,0.,10.,0.,0.\n0.,0.,0.2\n"
      "*SET_NODE_LIST\n1\n1,3\n*SET_NODE_LIST\n2\n2,4\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n*DEFINE_CURVE\n1\n0.,1.\n1.,"
      "1.\n"
      "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,1\n*DATABASE_BINARY_D3PLOT\n0.1\n*DATABASE_GLSTAT\n0.1\n*DATABASE_"
      "MATSUM\n0.4\n";
  const Ended ended = calculate(deck);
  ASSERT_EQ(ended.failure, "");
  EXPECT_NE(file("messag").find(" shell element         1 failed at time "), std::string::npos) << file("messag");
  const auto plot = results::D3plotStates::open((folder_ / "out" / "d3plot").string());
  ASSERT_TRUE(plot.ok());
  ASSERT_GE(plot.value().size(), 5u);
  for (std::size_t i = 0; i < plot.value().size(); ++i) {
    const results::D3plotState state = plot.value().read(i);
    EXPECT_EQ(state.deleted_shells, std::vector<bool>{state.time > 0.25}) << state.time;
  }
  const auto states = results::read_glstat(file("glstat"));
  EXPECT_EQ(states.front().eroded_internal, 0);
  EXPECT_NEAR(states.back().eroded_internal, states.back().internal, 1e-5);
  EXPECT_GT(states.back().eroded_internal, 0.15);
  const auto last_number = [](const std::string& text, const std::string& label) {
    return std::stod(text.substr(text.rfind(label) + label.size()));
  };
  EXPECT_LT(last_number(file("glstat"), "energy ratio w/o eroded energy."), 0.5);
  EXPECT_EQ(last_number(file("matsum"), "inten="), 0);
  EXPECT_NEAR(last_number(file("matsum"), "eroded_ie="), states.back().eroded_internal, 1e-4);
}

// A spotweld that breaks at its time: messag names it, d3plot has it deleted.
TEST_F(RunTest, FailedSpotweldInTheFiles) {
  const Ended ended = calculate(
      "*CONTROL_TERMINATION\n0.4\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n*ELEMENT_BEAM\n7,1,1,2,3\n8,2,1,3,2\n"
      "*PART\np\n1,1,1\n*PART\nq\n2,1,2\n*SECTION_BEAM\n1,9,1.,2,1\n0.1,0.1\n"
      "*MAT_SPOTWELD\n1,1.,1000.,0.3,10.,0.,0.,0.2\n\n*MAT_ELASTIC\n2,1.,1000.,0.3\n"
      "*DATABASE_BINARY_D3PLOT\n0.1\n*DATABASE_GLSTAT\n0.1\n");
  ASSERT_EQ(ended.failure, "");
  EXPECT_NE(file("messag").find(" beam element         7 failed at time "), std::string::npos) << file("messag");
  const auto plot = results::D3plotStates::open((folder_ / "out" / "d3plot").string());
  ASSERT_TRUE(plot.ok());
  ASSERT_GE(plot.value().size(), 5u);
  for (std::size_t i = 0; i < plot.value().size(); ++i) {
    const results::D3plotState state = plot.value().read(i);
    EXPECT_EQ(state.deleted_beams, (std::vector<bool>{state.time > 0.2, false})) << state.time;
  }
}

// What SOFT = 2 has to say: where a type does not have it, and segments that pass through each other (DTPCHK).
TEST_F(RunTest, SegmentBasedContactInMessag) {
  const Ended ended = calculate(
      "*CONTROL_TERMINATION\n0.001\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n"
      "5,0.5,0.2,-1.\n6,0.5,0.8,-1.\n7,0.5,0.8,1.\n8,0.5,0.2,1.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,5,6,7,8\n" +
      elastic_deck(shell_section, 1000, 0.3, 1) +
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n3,all\n0\n\n\n2\n0.\n1\n0,0.0005\n"
      "*SET_NODE_LIST\n4\n1,2\n*CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID\n7,nodes\n4,1,4,3\n\n\n2\n");
  ASSERT_EQ(ended.failure, "");
  Diagnostics diagnostics;
  const Report report = results::read_solver_log_text(file("messag"), "messag", {}, diagnostics);
  std::map<std::string, std::uint64_t> kinds;
  for (const SolverMessage& message : report.run->messages) kinds[message.kind] += 1;
  EXPECT_EQ(kinds, (std::map<std::string, std::uint64_t>{{"soft2-intersection", 1}, {"soft2-switched-off", 1}}))
      << file("messag");
  EXPECT_EQ(report.penetrations.size(), 0u);
}

TEST_F(RunTest, TheSameBytesForAnyNumberOfThreads) {
  std::array<std::string, 2> bytes;
  for (const std::size_t jobs : {1, 4}) {
    const JobLimit limit(jobs);
    ASSERT_EQ(calculate(strip("*DATABASE_MATSUM\n0.1\n")).failure, "");
    std::string& all = bytes[jobs == 1 ? 0 : 1];
    for (const char* name : {"glstat", "matsum", "messag", "d3hsp", "d3plot", "d3plot01"}) all += file(name);
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

TEST(Interval, EachMultipleOnce) {
  Interval interval(0.1);
  int written = 0;
  for (int i = 0; i <= 100; ++i)
    if (interval.due(0.015 * i)) {
      interval.written(0.015 * i);
      ++written;
    }
  EXPECT_EQ(written, 16);
  Interval never;
  EXPECT_FALSE(never.due(0));
  Interval once(std::numeric_limits<double>::infinity());
  EXPECT_TRUE(once.due(0));
  once.written(0);
  EXPECT_FALSE(once.due(1e300));
}

}  // namespace
}  // namespace gapcheck::solver::run_test
