// The text files of a run, column for column as the solver writes them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "results/text/fortran_number.hpp"

namespace gapcheck::results::result_files_test {
namespace {

const FileHeader header{"Bolted Connection Type b", "gapcheck 0.1.0"};

/// The file from its first line on.
void expect_begin(const std::string& text, const std::string& wanted) {
  EXPECT_EQ(text.substr(0, wanted.size()), wanted);
}

TEST(FortranNumber, AsFortranPrints) {
  EXPECT_EQ(scientific(2.1187e-4, 14, 5), "   2.11870E-04");
  EXPECT_EQ(scientific(-3.1541e-8, 12, 5), "-3.15410E-08");
  EXPECT_EQ(scientific(0, 12, 5), " 0.00000E+00");
  EXPECT_EQ(scientific(-1.5e-300, 11, 4), "-1.5000-300");
  EXPECT_EQ(scientific(9.99996e9, 11, 4), " 1.0000E+10");
  EXPECT_EQ(scientific(-1.5e-300, 10, 4), "**********");
  EXPECT_EQ(scientific(std::nan(""), 8, 2), "     NaN");
  EXPECT_EQ(scientific(std::numeric_limits<double>::infinity(), 10, 2), "  Infinity");
  EXPECT_EQ(normalised(4.87301e-3, 14, 7), " 0.4873010E-02");
  EXPECT_EQ(normalised(-1.504e-3, 13, 4), "  -0.1504E-02");
  EXPECT_EQ(normalised(0, 13, 4), "   0.0000E+00");
  EXPECT_EQ(normalised(1, 13, 4), "   0.1000E+01");
  EXPECT_EQ(normalised(0.99999, 13, 4), "   0.1000E+01");
}

GlobalState global_state() {
  GlobalState state;
  state.cycle = 24;
  state.controlled_by = "solid";
  state.element = 100449;
  state.part = 10;
  state.time = 4.87301e-3;
  state.time_step = 2.1187e-4;
  state.kinetic = 9.93442e-6;
  state.internal = 1.36945e-5;
  state.springs = 1e-20;
  state.total = 2.36289e-5;
  state.velocity = {4.24142e-24, 1.11186e-18, 8.48284e-24};
  return state;
}

TEST(Glstat, ColumnForColumn) {
  EXPECT_EQ(glstat_header(header) + glstat_text(global_state()),
            " Bolted Connection Type b                                                \n"
            "                    gapcheck 0.1.0\n"
            "\n"
            "\n"
            " dt of cycle      24 is controlled by solid         100449 of part        10\n"
            "\n"
            " time...........................   4.87301E-03\n"
            " time step......................   2.11870E-04\n"
            " kinetic energy.................   9.93442E-06\n"
            " internal energy................   1.36945E-05\n"
            " spring and damper energy.......   1.00000E-20\n"
            " hourglass energy ..............   0.00000E+00\n"
            " system damping energy..........   0.00000E+00\n"
            " sliding interface energy.......   0.00000E+00\n"
            " external work..................   0.00000E+00\n"
            " eroded kinetic energy..........   0.00000E+00\n"
            " eroded internal energy.........   0.00000E+00\n"
            " eroded hourglass energy........   0.00000E+00\n"
            " total energy...................   2.36289E-05\n"
            " total energy / initial energy..   1.00000E+00\n"
            " energy ratio w/o eroded energy.   1.00000E+00\n"
            " global x velocity..............   4.24142E-24\n"
            " global y velocity..............   1.11186E-18\n"
            " global z velocity..............   8.48284E-24\n"
            " time per zone cycle.(nanosec)..             0\n");
  GlobalState state = global_state();
  state.controlled_by = "load curve";
  state.element = 0;
  expect_begin(glstat_text(state), "\n\n dt of cycle      24 is controlled by load curve\n\n time....");
}

TEST(Glstat, IsReadBack) {
  GlobalState second = global_state();
  second.time = 1;
  second.sliding = -0.25;
  second.ratio = 0.5;
  second.walls = {{1, 2.5}, {12, -3}};
  const std::string text = glstat_header(header) + glstat_text(global_state()) + glstat_text(second);
  EXPECT_NE(text.find(" stonewall energy...............   2.50000E+00 wall#    1\n"
                      " stonewall energy...............  -3.00000E+00 wall#   12\n"
                      " spring and damper energy......."),
            std::string::npos)
      << "walls follow the internal energy";
  const auto states = read_glstat(text);
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].kinetic, 9.93442e-6);
  EXPECT_EQ(states[0].cycle, 24u);
  EXPECT_EQ(states[0].velocity, global_state().velocity);
  EXPECT_EQ(states[0].walls.size(), 0u);
  EXPECT_EQ(states[1].time, 1);
  EXPECT_EQ(states[1].sliding, -0.25);
  EXPECT_EQ(states[1].ratio, 0.5);
  ASSERT_EQ(states[1].walls.size(), 2u);
  EXPECT_EQ(states[1].walls[1].number, 12);
  EXPECT_EQ(states[1].walls[1].energy, -3);
  EXPECT_TRUE(read_glstat("").empty());
  EXPECT_TRUE(read_glstat(" time..\n stonewall energy......\n").empty());
}

TEST(Matsum, ColumnForColumn) {
  PartState part;
  part.part = 1;
  const std::string first =
      " time =   0.0000E+00\n"
      " mat.#=    1             inten=   0.0000E+00     kinen=   0.0000E+00     eroded_ie=   0.0000E+00     "
      "eroded_ke=   0.0000E+00\n"
      " x-mom=   0.0000E+00     y-mom=   0.0000E+00     z-mom=   0.0000E+00\n"
      " x-rbv=   0.0000E+00     y-rbv=   0.0000E+00     z-rbv=   0.0000E+00\n"
      "                         hgeng=   0.0000E+00     +mass=   0.0000E+00     eroded_he=   0.0000E+00\n"
      "\n"
      "\n";
  EXPECT_EQ(matsum_header({"LS-DYNA SIMULERING AF VARME DER BUKKER PLADE - J. G", "gapcheck 0.1.0"},
                          {{2, "left"}, {1, "middle"}}) +
                matsum_text(0, std::vector{part}),
            " LS-DYNA SIMULERING AF VARME DER BUKKER PLADE - J. G                     \n"
            "                    gapcheck 0.1.0\n"
            "\n"
            "{BEGIN LEGEND}\n"
            " Entity #        Title\n"
            "        1     middle                                                                  \n"
            "        2     left                                                                    \n"
            "{END LEGEND}\n"
            "\n\n\n" +
                first);
  part.internal = 1.25;
  part.momentum = {0, -2e-3, 0};
  const std::string text = matsum_text(9.9981e-4, std::vector{part});
  EXPECT_NE(text.find("\n time =   9.9981E-04\n mat.#=    1             inten=   1.2500E+00     kinen="),
            std::string::npos);
  EXPECT_NE(text.find("     y-mom=  -2.0000E-03     z-mom="), std::string::npos);
}

TEST(Nodout, ColumnForColumn) {
  NodeState node;
  node.node = 1100002;
  node.displacement = {-4.08233e-11, 5.95949e-5, 4.61685e-14};
  node.velocity = {-3.1541e-8, 3.25501e-2, 6.88246e-11};
  node.acceleration = {-6.47259e-6, 6.67967, 1.41236e-8};
  node.position = {2.74317e-5, -7.89994, 7.7402e-7};
  const std::string begin =
      "\n"
      "{BEGIN LEGEND}\n"
      " Entity #        Title\n"
      "  1100002                                                                                     \n"
      "{END LEGEND}\n"
      "\n\n\n\n"
      " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p      24                              ( at time "
      "4.8730101E-03 )\n"
      "\n"
      " nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl      "
      "z-accl      x-coor      y-coor      z-coor\n"
      "  1100002 -4.08233E-11 5.95949E-05 4.61685E-14-3.15410E-08 3.25501E-02 6.88246E-11-6.47259E-06 6.67967E+00 "
      "1.41236E-08 2.74317E-05-7.89994E+00 7.74020E-07\n"
      "\n\n\n"
      " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p      24                              ( at time "
      "4.8730101E-03 )\n"
      "\n"
      " nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel   x-rot acc   y-rot acc   "
      "z-rot acc\n"
      "  1100002  0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 "
      "0.00000E+00\n";
  const std::string text = nodout_header(header, {{1100002, ""}}) + nodout_text(24, 4.8730101e-3, std::vector{node});
  EXPECT_EQ(text.substr(text.find('\n', text.find('\n') + 1) + 1), begin);
}

TEST(ContactFiles, Rcforc) {
  InterfaceState single, pair;
  single.contact = 10001;
  single.single_surface = true;
  pair.contact = 80085;
  pair.force = {Vector(1, -2, 0), Vector(-1, 2, 0)};
  EXPECT_EQ(
      contact_header(header, {{80085, "Left_on_left_action"}, {8009, "Mortar silent backup for contact       8008"}}) +
          rcforc_text(4.87301e-3, std::vector{single, pair}),
      " Bolted Connection Type b                                                \n"
      "                    gapcheck 0.1.0\n"
      "\n"
      "{BEGIN LEGEND}\n"
      " Entity #        Title\n"
      "     8009     Mortar silent backup for contact       8008                          \n"
      "    80085     Left_on_left_action                                                  \n"
      "{END LEGEND}\n"
      "\n"
      " interface number,     10001,is single surface-resultants are undefined\n"
      " interface number,     10001,is single surface-resultants are undefined\n"
      "  SURFA       80085 time 4.87301E-03  x  1.00000E+00  y -2.00000E+00  z  0.00000E+00 mass  0.00000E+00  "
      "mx  0.00000E+00  my  0.00000E+00  mz  0.00000E+00\n"
      "  SURFB       80085 time 4.87301E-03  x -1.00000E+00  y  2.00000E+00  z  0.00000E+00 mass  0.00000E+00  "
      "mx  0.00000E+00  my  0.00000E+00  mz  0.00000E+00\n");
}

TEST(ContactFiles, Sleout) {
  InterfaceState a, b;
  a.contact = 1;
  b.contact = 2;
  b.energy = {-1.504e-3, 2.2e-3};
  b.friction = 6.964e-4;
  EXPECT_EQ(sleout_text(2.49993e-3, 9260, std::vector{a, b}),
            "\n\n\n"
            " contact interface energy file, time= 0.2499930E-02\n"
            "    #             surfa       surfb        cycle=          9260    frictional\n"
            "\n"
            "         1   0.0000E+00   0.0000E+00                               0.0000E+00\n"
            "         2  -0.1504E-02   0.2200E-02                               0.6964E-03\n"
            "\n"
            " summary   total surfa side=-0.1504000E-02\n"
            "           total surfb side= 0.2200000E-02\n"
            "           total energy    = 0.6960000E-03\n"
            "           friction energy = 0.6964000E-03\n"
            "\n\n\n");
}

// The rows of thousands of contacts come in pieces, which are the text of all of them; a failed write is the last.
TEST(ContactFiles, SleoutInPieces) {
  constexpr std::size_t many = 5000;
  std::vector<InterfaceState> contacts(many);
  for (std::size_t i = 0; i < many; ++i) {
    contacts[i].contact = static_cast<std::int64_t>(i + 1);
    contacts[i].energy = {1, 2};
    contacts[i].friction = 0.5;
  }
  std::vector<std::string> pieces;
  EXPECT_TRUE(write_sleout(1, 2, contacts, [&](std::string_view piece) {
    pieces.emplace_back(piece);
    return true;
  }));
  ASSERT_GT(pieces.size(), 2u);
  std::string all;
  for (const std::string& piece : pieces) {
    EXPECT_LT(piece.size(), std::size_t{1} << 18);
    all += piece;
  }
  // Each contact once, in its order: read back, and counted.
  Diagnostics diagnostics;
  const InterfaceHistory read = read_sleout(contact_header({"t", "p"}, {{1, "x"}}) + all, "sleout", diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty());
  ASSERT_EQ(read.states.size(), 1u);
  ASSERT_EQ(read.states[0].contacts.size(), many);
  for (std::size_t i = 0; i < many; ++i) EXPECT_EQ(read.states[0].contacts[i].contact, contacts[i].contact);
  EXPECT_NE(all.find("total energy    = 0.1500000E+05"), std::string::npos);
  EXPECT_NE(all.find("friction energy = 0.2500000E+04"), std::string::npos);
  int calls = 0;
  EXPECT_FALSE(write_sleout(1, 2, contacts, [&](std::string_view) { return ++calls < 2; }));
  EXPECT_EQ(calls, 2);
}

TEST(ContactFiles, Ncforc) {
  NodeForce node;
  node.node = 14;
  node.force = {0, 0, -2.5};
  node.position = {1, 2, 3};
  node.pressure = 0.5;
  NodeForce other = node;
  other.node = 2;
  other.side = 1;
  EXPECT_EQ(ncforc_text(0.1, 3, std::vector{other, node}),
            "\n\n\n forces (t=1.00000E-01) for interface         3 slave  side\n\n"
            "     node           x-force/      y-force/      z-force/     pressure/\n"
            "                   coordinate    coordinate    coordinate\n"
            "        14         0.00000E+00   0.00000E+00  -2.50000E+00   5.00000E-01\n"
            "                   1.00000E+00   2.00000E+00   3.00000E+00\n"
            "\n\n\n forces (t=1.00000E-01) for interface         3 master side\n\n"
            "     node           x-force/      y-force/      z-force/     pressure/\n"
            "                   coordinate    coordinate    coordinate\n"
            "         2         0.00000E+00   0.00000E+00  -2.50000E+00   5.00000E-01\n"
            "                   1.00000E+00   2.00000E+00   3.00000E+00\n");
  EXPECT_EQ(ncforc_text(0.1, 3, {}), "");
}

TEST(FileHeaders, TitlesCannotBreakLines) {
  EXPECT_EQ(header_text({"a\nb\x1b", "p"}).substr(0, 6), " a?b? ");
  EXPECT_EQ(column_text("longer than that", 6), "longer");
}

}  // namespace
}  // namespace gapcheck::results::result_files_test
