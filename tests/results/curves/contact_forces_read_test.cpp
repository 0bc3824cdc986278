#include <gtest/gtest.h>

#include <cmath>

#include "results/curves/contact_forces.hpp"
#include "results/read.hpp"
#include "results/said.hpp"

namespace gapcheck::results::contact_forces_read_test {
namespace {

const std::string old_rcforc =
    R"( Bolted joint                                                            
                    ls-dyna smp d R13 R13.1.1_27_8731a0 date 07/28/2023

{BEGIN LEGEND}
 Entity #        Title
        2      Sheets                                                              
    10001      Everything                                                          
{END LEGEND}

 interface number,     10001,is single surface-resultants are undefined
 interface number,     10001,is single surface-resultants are undefined
  slave           2 time 0.00000E+00  x  0.00000E+00  y  0.00000E+00  z  0.00000E+00 mass  0.00000E+00
  master          2 time 0.00000E+00  x  0.00000E+00  y  0.00000E+00  z  0.00000E+00 mass  0.00000E+00
 interface number,     10001,is single surface-resultants are undefined
 interface number,     10001,is single surface-resultants are undefined
  slave           2 time 4.87301E-03  x -2.50000E+00  y  1.5000-345  z  0.00000E+00 mass  1.00000E+00  mx  0.00000E+00  my  7.00000E+00  mz  0.00000E+00
  master          2 time 4.87301E-03  x  2.50000E+00  y -1.5000-345  z         NaN mass  1.00000E+00  mx  0.00000E+00  my  0.00000E+00  mz  0.00000E+00
)";

TEST(ReadRcforc, OldWordsExponentsWithoutLetterAndSingleSurfaces) {
  Diagnostics diagnostics;
  const InterfaceHistory history = read_rcforc(old_rcforc, "rcforc", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(history.titles.size(), 2u);
  EXPECT_EQ(history.titles[1].id, 10001);
  EXPECT_EQ(history.titles[1].title, "Everything");
  EXPECT_EQ(history.single_surface, std::vector<std::int64_t>{10001});
  ASSERT_EQ(history.states.size(), 2u);
  EXPECT_EQ(history.states[1].time, 4.87301e-3);
  ASSERT_EQ(history.states[1].contacts.size(), 1u);
  const InterfaceState& contact = history.states[1].contacts[0];
  EXPECT_EQ(contact.contact, 2);
  EXPECT_EQ(contact.force[0], Vector(-2.5, 0, 0)) << "1.5E-345 is none but zero";
  EXPECT_EQ(contact.moment[0], Vector(0, 7, 0));
  EXPECT_EQ(contact.force[1].x(), 2.5);
  EXPECT_TRUE(std::isnan(contact.force[1].z()));
}

TEST(ReadRcforc, IsReadBack) {
  const FileHeader header{"title", "gapcheck 0.1.0"};
  InterfaceState single, pair, other;
  single.contact = 10001;
  single.single_surface = true;
  pair.contact = 80085;
  pair.force = {Vector(1, -2, 3.5e-120), Vector(-1, 2, -3.5e-120)};
  pair.moment[1] = Vector(0, 0, 9);
  other.contact = 7;
  other.force[1] = Vector(1e99, 1e100, 0);
  const std::vector<InterfaceState> states{single, pair, other};
  Diagnostics diagnostics;
  const InterfaceHistory read = read_rcforc(
      contact_header(header, {{7, "b"}, {80085, "a"}}) + rcforc_text(0.5, states) + rcforc_text(1.5, states), "rcforc",
      diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  EXPECT_EQ(read.single_surface, std::vector<std::int64_t>{10001});
  ASSERT_EQ(read.states.size(), 2u);
  EXPECT_EQ(read.states[1].time, 1.5);
  ASSERT_EQ(read.states[1].contacts.size(), 2u);
  EXPECT_EQ(read.states[1].contacts[0].force, pair.force);
  EXPECT_EQ(read.states[1].contacts[0].moment, pair.moment);
  EXPECT_EQ(read.states[1].contacts[1].force, other.force);
}

TEST(ReadRcforc, StatesOfOnePrintedTimeStayApart) {
  const std::string row = "  SURFA 1 time 1.0  x 1.0 y 0.0 z 0.0\n  SURFB 1 time 1.0  x 1.0 y 0.0 z 0.0\n";
  Diagnostics diagnostics;
  EXPECT_EQ(read_rcforc(row + row, "rcforc", diagnostics).states.size(), 2u);
  EXPECT_EQ(said(diagnostics), "");
}

TEST(ReadRcforc, FilesThatAreCutOff) {
  const std::string whole = old_rcforc.substr(0, old_rcforc.find("  master          2 time 4.87301E-03"));
  Diagnostics rows, line, number;
  EXPECT_EQ(read_rcforc(whole, "rcforc", rows).states.size(), 1u);
  EXPECT_EQ(said(rows), "warning 16: a state ends before it is complete and is left out\n");
  EXPECT_EQ(read_rcforc(old_rcforc.substr(0, old_rcforc.size() - 1), "rcforc", line).states.size(), 1u);
  EXPECT_EQ(said(line), "warning 17: a state ends before it is complete and is left out\n");
  std::string damaged = old_rcforc;
  damaged.replace(damaged.find("-2.50000E+00"), 12, "************");
  const InterfaceHistory history = read_rcforc(damaged, "rcforc", number);
  EXPECT_EQ(said(number), "error 16: a number cannot be read and is left out\n");
  ASSERT_EQ(history.states.size(), 2u);
  EXPECT_TRUE(std::isnan(history.states[1].contacts[0].force[0].x()));
}

const std::string old_sleout =
    R"(
 contact interface energy file, time= 0.0000000E+00
    #             slave       master       cycle=             1    frictional

     10001   0.0000E+00   0.0000E+00                               0.0000E+00
         2   0.0000E+00   0.0000E+00                               0.0000E+00

 summary   total slave side= 0.0000000E+00
           total mastr side= 0.0000000E+00
           total energy    = 0.0000000E+00
           friction energy = 0.0000000E+00

 contact interface energy file, time= 0.2499930E-02
    #             surfa       surfb        cycle=          9260    frictional

     10001   0.0000E+00   0.0000E+00                               0.0000E+00
         2  -0.1504E-02   0.2200E-02                               0.6964E-03

 summary   total surfa side=-0.1504032E-02
)";

TEST(ReadSleout, BothVocabularies) {
  Diagnostics diagnostics;
  const InterfaceHistory history = read_sleout(old_sleout, "sleout", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(history.states.size(), 2u);
  EXPECT_EQ(history.states[1].time, 2.49993e-3);
  EXPECT_EQ(history.states[1].cycle, 9260u);
  ASSERT_EQ(history.states[1].contacts.size(), 2u);
  EXPECT_EQ(history.states[1].contacts[1].contact, 2);
  EXPECT_EQ(history.states[1].contacts[1].energy, (std::array{-1.504e-3, 2.2e-3}));
  EXPECT_EQ(history.states[1].contacts[1].friction, 6.964e-4);
}

TEST(ReadSleout, IsReadBack) {
  InterfaceState a, b;
  a.contact = 1;
  b.contact = 22;
  b.energy = {-1.504e-3, 2.2e120};
  b.friction = 6.964e-4;
  Diagnostics diagnostics;
  const InterfaceHistory read = read_sleout(
      contact_header({"t", "p"}, {{1, "x"}}) + sleout_text(2.49993e-3, 9260, std::vector{a, b}), "sleout", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(read.states.size(), 1u);
  EXPECT_EQ(read.states[0].cycle, 9260u);
  ASSERT_EQ(read.states[0].contacts.size(), 2u);
  EXPECT_EQ(read.states[0].contacts[1].energy, b.energy);
  EXPECT_EQ(read.states[0].contacts[1].friction, b.friction);
}

TEST(ReadSleout, AStateWithoutItsSumsIsLeftOut) {
  Diagnostics diagnostics;
  EXPECT_EQ(read_sleout(old_sleout.substr(0, old_sleout.rfind("\n summary")), "sleout", diagnostics).states.size(), 1u);
  EXPECT_EQ(said(diagnostics), "warning 17: a state ends before it is complete and is left out\n");
}

TEST(ReadContactForces, NothingAtAll) {
  Diagnostics diagnostics;
  EXPECT_TRUE(read_rcforc("", "rcforc", diagnostics).states.empty());
  EXPECT_TRUE(read_sleout("", "sleout", diagnostics).states.empty());
  EXPECT_TRUE(read_rcforc("{BEGIN LEGEND}", "rcforc", diagnostics).titles.empty());
}

// The files of a published run beside the decks that the project is tried on.
TEST(ReadRcforc, RealRun) {
  const std::string path = std::string(GAPCHECK_ROOT) + "/../shared/decks/tied_plate_with_run/rcforc";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no decks beside the project";
  Diagnostics diagnostics;
  const InterfaceHistory history = read_rcforc(read_bytes(path), path, diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  EXPECT_EQ(history.titles.size(), 4u);
  ASSERT_EQ(history.states.size(), 1u);
  ASSERT_EQ(history.states[0].contacts.size(), 4u);
  EXPECT_EQ(history.states[0].contacts[0].contact, 80085);
  EXPECT_EQ(history.states[0].contacts[3].contact, 8009);
}

}  // namespace
}  // namespace gapcheck::results::contact_forces_read_test
