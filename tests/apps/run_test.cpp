// gapcheck run as users and scripts see it.
#include "program.hpp"
#include "results/curves/glstat.hpp"
#include "results/d3plot/d3plot_states.hpp"

namespace gapcheck::run_test {
namespace {

namespace fs = std::filesystem;

class RunCommand : public Program {
 protected:
  static std::string data(const std::string& name) { return "'" + (project / "data" / name).string() + "'"; }
};

TEST_F(RunCommand, AnExampleEndsNormally) {
  const Ended run = gapcheck("run " + data("two_plates.k") + " -o out --stats");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out.find("Normal end at time 0.001"), 0u) << run.out;
  EXPECT_NE(run.out.find("touching"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("shells 18"), std::string::npos);
  for (const char* name : {"messag", "d3hsp", "glstat", "rcforc", "sleout", "d3plot", "d3plot01"})
    EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
  const auto states = results::read_glstat(content(folder_ / "out" / "glstat"));
  EXPECT_EQ(states.size(), 101u) << "an interval of 1e-5 up to 1e-3";
  const auto plot = results::D3plotStates::open((folder_ / "out" / "d3plot").string());
  ASSERT_TRUE(plot.ok());
  EXPECT_EQ(plot.value().size(), 21u);
}

// The messages of the run are what the audit predicts.
TEST_F(RunCommand, ItsMessagesAreTheAudits) {
  for (const char* name : {"two_plates.k", "contact_chain.k", "ignore_2.k", "triangle.k"}) {
    const Ended run = gapcheck("run " + data(name) + " -o out --cycles 2 --quiet --ignore-unsupported");
    ASSERT_EQ(run.code, 0) << name << run.err;
    EXPECT_EQ(run.out, "");
    const Ended compared = gapcheck("compare " + data(name) + " out");
    EXPECT_EQ(compared.code, 0) << name << compared.out;
    EXPECT_NE(compared.out.find("no differences"), std::string::npos) << compared.out;
    const Ended read = gapcheck("messag out/messag --fail-on never");
    EXPECT_EQ(read.code, 0);
    EXPECT_NE(read.out.find("gapcheck"), std::string::npos) << read.out;
    EXPECT_NE(read.out.find("normal termination"), std::string::npos) << read.out;
  }
}

// A run begins where *PART_MOVE and *NODE_TRANSFORM have put the nodes, as the audit does: it is the run of the deck
// with these coordinates.
TEST_F(RunCommand, BeginsWithMovedNodes) {
  std::string deck = content(project / "data/two_plates.k");
  const auto with_height = [&](const std::string& height, const std::string& more) {
    std::string changed = deck;
    for (std::size_t at = 0; (at = changed.find("             0.7\n", at)) != std::string::npos;)
      changed.replace(at, 16, std::string(16 - height.size(), ' ') + height);
    changed.insert(changed.rfind("*END"), more);
    return changed;
  };
  file("there.k", with_height("0.75", ""));
  file("part_move.k", with_height("4.75", "*PART_MOVE\n2,0.,0.,-4.\n"));
  file("transform.k", with_height("2.75",
                                  "*NODE_TRANSFORM\n7,7\n*SET_NODE_GENERAL\n7\nPART,2\n"
                                  "*DEFINE_TRANSFORMATION\n7\nTRANSL,0.,0.,-2.\n"));
  ASSERT_EQ(gapcheck("run there.k -o there --cycles 40 --quiet").code, 0);
  const std::string states = content(folder_ / "there" / "glstat"), audit = gapcheck("audit there.k --quiet").out;
  for (const std::string name : {"part_move", "transform"}) {
    const Ended run = gapcheck("run " + name + ".k -o " + name + " --cycles 40 --quiet");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(content(folder_ / name / "glstat"), states) << name;
    for (const char* plot : {"d3plot", "d3plot01"})
      EXPECT_EQ(content(folder_ / name / plot), content(folder_ / "there" / plot)) << name << ' ' << plot;
    EXPECT_EQ(gapcheck("audit " + name + ".k --quiet").out.substr(name.size()), audit.substr(5)) << name;
    EXPECT_NE(gapcheck("compare " + name + ".k " + name).out.find("no differences"), std::string::npos) << name;
  }
  // A move that the model has not made keeps the run from starting.
  file("local.k", with_height("4.75", "*PART_MOVE\n2,0.,0.,-4.,3\n"));
  const Ended refused = gapcheck("run local.k -o local");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("*PART_MOVE is not supported: its move is given in the coordinate system 3: no "
                             "*DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR defines it"),
            std::string::npos)
      << refused.err;
}

// Keywords that only modify contacts are no contacts in d3hsp, and it can be read again.
TEST_F(RunCommand, ModifiersAreNotInTheContactSummary) {
  std::string deck = content(project / "data/two_plates.k");
  for (const char* modifier : {"INTERIOR", "AUTO_MOVE", "ADD_WEAR"}) {
    const std::string more = "*CONTACT_" + std::string(modifier) + "\n         1\n*END";
    std::string with = deck;
    with.replace(with.rfind("*END"), 4, more);
    file("deck.k", with);
    const Ended run = gapcheck("run deck.k -o out --cycles 2 --quiet --ignore-unsupported");
    ASSERT_EQ(run.code, 0) << modifier << run.err;
    const Ended read = gapcheck("messag out/d3hsp --fail-on never");
    EXPECT_EQ(read.code, 0) << modifier << read.err;
    EXPECT_EQ(read.err.find("error"), std::string::npos) << modifier << read.err;
    EXPECT_NE(read.out.find("in 1 contact"), std::string::npos) << modifier << read.out;
    std::filesystem::remove_all(folder_ / "out");
  }
}

TEST_F(RunCommand, GridsForVtk) {
  const Ended run = gapcheck("run " + data("two_plates.k") + " -o out --cycles 3 --vtu");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string series = content(folder_ / "out" / "run.pvd"), grid = content(folder_ / "out" / "state_0001.vtu");
  EXPECT_NE(series.find("file=\"state_0002.vtu\""), std::string::npos) << series;
  EXPECT_NE(grid.find("NumberOfPoints=\"32\" NumberOfCells=\"18\""), std::string::npos) << grid.substr(0, 300);
  for (const char* name : {"displacement", "contact_state", "contact_force", "stress", "plastic_strain"})
    EXPECT_NE(grid.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
}

TEST_F(RunCommand, GridsOfEarlierRunsGo) {
  const std::string words = "run " + data("two_plates.k") + " -o out --vtu --quiet --cycles ";
  ASSERT_EQ(gapcheck(words + "3").code, 0);
  for (const char* name : {"out/state_0003.vtu", "out/state_0041.vtu"})
    fs::copy(folder_ / "out/state_0001.vtu", folder_ / name);
  ASSERT_EQ(gapcheck(words + "1").code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/state_0002.vtu"));
  EXPECT_FALSE(fs::exists(folder_ / "out/state_0003.vtu")) << "of a longer run";
  EXPECT_FALSE(fs::exists(folder_ / "out/state_0041.vtu"));
  file("out/state_0002.vtu",
       "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
       "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n");
  file("out/state_0003.txt", "notes");
  const Ended refused = gapcheck(words + "1");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("-o: out/state_0002.vtu would be replaced, and gapcheck did not write it"),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(gapcheck("run " + data("two_plates.k") + " -o out --quiet --cycles 1").code, 0) << "no grids are written";
  EXPECT_EQ(gapcheck(words + "1 --force").code, 0);
  EXPECT_EQ(content(folder_ / "out/state_0003.txt"), "notes");
}

TEST_F(RunCommand, WhatGoesWrongNamesItsPlaceInTheDeck) {
  const std::string plates = content(project / "data" / "two_plates.k");
  const auto expect = [&](const std::string& old, const std::string& other, const std::string& message) {
    std::string text = plates;
    ASSERT_NE(text.find(old), std::string::npos) << old;
    file("deck.k", text.replace(text.find(old), old.size(), other));
    const Ended run = gapcheck("run deck.k -o out --cycles 1 --ignore-unsupported");
    EXPECT_EQ(run.code, 2) << other;
    EXPECT_NE(run.err.find("gapcheck: error: deck.k:" + message), std::string::npos) << run.err;
  };
  // Elements, materials, sections, conditions, and what has no line.
  expect("*MAT_ELASTIC\n         1", "*MAT_ELASTIC\n         7",
         "68: shell 1001 has no part, section or material; define them or leave it out\n");
  expect("  7.85e-09   210000.", "  7.85e-09       -1.",
         "32: material 1 (*MAT_ELASTIC) has a density, stiffness or yield stress out of range\n");
  expect("*END", "*LOAD_NODE_POINT\n1001,1,99\n*END", "92: *LOAD_NODE_POINT: curve 99 ");
  expect("*END", "*CONTROL_TIMESTEP\n0.,-1.\n*END", " TSSFAC of *CONTROL_TIMESTEP is -1; ");
  file("deck.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.\n*END\n");
  fs::remove_all(folder_ / "out");
  const Ended empty = gapcheck("run deck.k -o out");
  EXPECT_EQ(empty.code, 2);
  EXPECT_NE(empty.err.find("error: deck.k: the deck has no nodes, so there is nothing to calculate\n"),
            std::string::npos)
      << empty.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(RunCommand, WhatGoesWrongIsExitCode2) {
  EXPECT_EQ(gapcheck("run " + data("two_plates.k")).code, 2) << "no directory";
  EXPECT_EQ(gapcheck("run none.k -o out").code, 2);
  EXPECT_EQ(gapcheck("run " + data("two_plates.k") + " -o out --until nan").code, 2);
  file("taken", "");
  const Ended taken = gapcheck("run " + data("two_plates.k") + " -o taken");
  EXPECT_EQ(taken.code, 2);
  EXPECT_EQ(taken.err.find("gapcheck: error: taken: cannot be created: "), 0u) << taken.err;
  file("open.k", "*KEYWORD\n*NODE\n1,0.,0.,0.\n*END\n");
  const Ended open = gapcheck("run open.k -o out");
  EXPECT_EQ(open.code, 2);
  EXPECT_NE(open.err.find("ENDTIM"), std::string::npos) << open.err;
}

TEST_F(RunCommand, NeverWritesOverItsInput) {
  const std::string plates = content(project / "data" / "two_plates.k");
  fs::create_directories(folder_ / "out");
  const auto refuses = [&](const std::string& arguments, const std::string& why, const std::string& input) {
    const std::string before = content(folder_ / input);
    const Ended run = gapcheck("run " + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_NE(run.err.find(why), std::string::npos) << arguments << ": " << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(content(folder_ / input), before) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "out/glstat")) << arguments;
  };
  for (const char* name : {"messag", "d3plot", "d3plot01", "ncforc"}) {
    const std::string path = std::string("out/") + name;
    file(path, plates);
    refuses(path + " -o out", "-o " + path + " is the deck itself; give another directory", path);
    file("main.k", "*KEYWORD\n*INCLUDE\n" + path + "\n*END\n");
    refuses("main.k -o ./out", "is a file that the deck includes", path);
    fs::remove(folder_ / path);
  }
  file("deck.k", plates);
  for (const char* name : {"messag", "d3hsp", "d3plot03", "sleout"}) {
    const std::string path = std::string("out/") + name;
    fs::create_hard_link(folder_ / "deck.k", folder_ / path);
    refuses("deck.k -o out --force", "-o " + path + " is the deck itself, deck.k; give another directory", "deck.k");
    fs::remove(folder_ / path);
    fs::create_symlink("../deck.k", folder_ / path);
    refuses("deck.k -o out --force", "-o " + path + " is the deck itself, deck.k", "deck.k");
    fs::remove(folder_ / path);
  }
  file("out/state_0001.vtu", plates);
  refuses("out/state_0001.vtu -o out --vtu", "is the deck itself", "out/state_0001.vtu");
  EXPECT_EQ(gapcheck("run out/state_0001.vtu -o out --cycles 1 --quiet").code, 0) << "no grids are written";
  EXPECT_EQ(gapcheck("run out/state_0001.vtu -o out --cycles 1 --quiet").code, 0) << "its own old files are replaced";
}

TEST_F(RunCommand, ResultsOfOthersAreReplacedOnlyByForce) {
  const std::string words = "run " + data("two_plates.k") + " -o out --cycles 1 --quiet";
  fs::create_directories(folder_ / "out");
  const std::string solver = " a title\n                         ls-dyna mpp.123456 d          date 01/01/2024\n";
  for (const char* name : {"messag", "d3hsp", "glstat", "matsum", "nodout", "rcforc", "sleout", "ncforc", "d3plot"}) {
    file(std::string("out/") + name, solver);
    const Ended run = gapcheck(words);
    EXPECT_EQ(run.code, 2) << name;
    EXPECT_EQ(run.err, std::string("gapcheck: error: -o: out/") + name +
                           " would be replaced, and gapcheck did not write it; give another directory, or --force\n");
    EXPECT_EQ(content(folder_ / "out" / name), solver);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), fs::directory_iterator()), 1) << name;
    EXPECT_EQ(gapcheck(words + " --force").code, 0) << name;
    EXPECT_EQ(gapcheck(words).code, 0) << name << ": now they are gapcheck's own";
    fs::remove_all(folder_ / "out");
    fs::create_directories(folder_ / "out");
  }
  file("out/d3plot01", "states of another run");
  file("out/glstat", solver);
  EXPECT_NE(gapcheck(words).err.find("out/d3plot01 would be replaced, as would 1 more results"), std::string::npos);
}

// Otherwise readers would take them for states of the new run.
TEST_F(RunCommand, StatesOfALongerRunAreRemoved) {
  ASSERT_EQ(gapcheck("run " + data("two_plates.k") + " -o out --cycles 1 --quiet").code, 0);
  const std::string states = content(folder_ / "out/d3plot01");
  for (const char* name : {"out/d3plot02", "out/d3plot03", "out/d3plot05"}) file(name, states);
  const auto count = [&] {
    const auto plot = results::D3plotStates::open((folder_ / "out/d3plot").string());
    return plot.ok() ? plot.value().size() : 0;
  };
  const std::size_t before = count();
  EXPECT_EQ(gapcheck("run " + data("two_plates.k") + " -o out --cycles 1 --quiet").code, 0);
  EXPECT_EQ(count() * 3, before);
  for (const char* name : {"out/d3plot02", "out/d3plot03", "out/d3plot05"}) EXPECT_FALSE(fs::exists(folder_ / name));
}

}  // namespace
}  // namespace gapcheck::run_test
