// secforc, spcforc, bndout, rwforc, rbdout, swforc, elout, deforc, jntforc, abstat: what is written is read back, and
// the layout is that of LS-DYNA's converter.
#include <gtest/gtest.h>

#include "results/history/airbag_states.hpp"
#include "results/history/body_motion.hpp"
#include "results/history/boundary_forces.hpp"
#include "results/history/element_stress.hpp"
#include "results/history/joint_forces.hpp"
#include "results/history/section_forces.hpp"
#include "results/history/spring_forces.hpp"
#include "results/history/support_forces.hpp"
#include "results/history/wall_forces.hpp"
#include "results/history/weld_forces.hpp"
#include "results/said.hpp"

namespace gapcheck::results::history_files_test {
namespace {

const FileHeader header{"a title", "gapcheck 0"};

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text << "\nlacks\n" << part;
}

template <class Row>
using Reader = History<Row> (*)(std::string_view, const std::string&, Diagnostics&);

/// Without a complaint, with this many states that have `rows` rows each.
template <class Row>
History<Row> read_whole(Reader<Row> read, const std::string& text, std::size_t states, std::size_t rows) {
  Diagnostics diagnostics;
  History<Row> history = read(text, "file", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  EXPECT_EQ(history.states.size(), states);
  history.states.resize(states);
  for (Timed<Row>& state : history.states) {
    EXPECT_EQ(state.rows.size(), rows);
    state.rows.resize(rows);
  }
  return history;
}

TEST(Secforc, LayoutAndRoundTrip) {
  const SectionState one{7, {3, 0, -4}, {0, 0, 2}, {1.5, 0.25, 0}, 0.125}, two{11, {0, 1, 0}, {}, {}, 2};
  const std::string text = secforc_header(header, {{7, "cut"}}) + secforc_text(0.5, std::vector{one, two}) +
                           secforc_text(1, std::vector{one, two});
  expect_part(text, " line#1  section#     time        x-force     y-force     z-force    magnitude\n");
  expect_part(text,
              "           7    5.00000E-01     3.0000E+00  0.0000E+00 -4.0000E+00  5.0000E+00\n"
              "global system                   0.0000E+00  0.0000E+00  2.0000E+00  2.0000E+00\n"
              "                                1.5000E+00  2.5000E-01  0.0000E+00  1.2500E-01\n\n");
  const auto history = read_whole(read_secforc, text, 2, 2);
  EXPECT_EQ(history.states[1].time, 1);
  const SectionState& read = history.states[0].rows[0];
  EXPECT_EQ(read.section, 7);
  EXPECT_EQ(read.force, one.force);
  EXPECT_EQ(read.moment, one.moment);
  EXPECT_EQ(read.centroid, one.centroid);
  EXPECT_EQ(read.area, 0.125);
  EXPECT_EQ(history.titles.size(), 1u);
}

TEST(Secforc, StatesThatEndEarlyAreLeftOut) {
  const std::vector<SectionState> both{{7, {1, 2, 3}, {}, {}, 1}, {8, {1, 2, 3}, {}, {}, 1}};
  const std::string text = secforc_header(header, {}) + secforc_text(0, both) + secforc_text(1, both);
  Diagnostics diagnostics;
  const auto history = read_secforc(text.substr(0, text.size() - 200), "secforc", diagnostics);
  EXPECT_EQ(history.states.size(), 1u);
  EXPECT_NE(said(diagnostics), "");
  for (std::size_t cut = 0; cut < text.size(); cut += 7) {
    Diagnostics ignored;
    EXPECT_LE(read_secforc(text.substr(cut), "secforc", ignored).states.size(), 2u);
  }
}

TEST(Spcforc, LayoutAndRoundTrip) {
  SupportStates states;
  states.supports = {{5, true, true, {1, 2, 3}, {4, 5, 6}}, {12345678, true, false, {-1, 0, 0}, {}}};
  states.resultant = {0, 2, 3};
  const std::string text = spcforc_header(header) + spcforc_text(0.25, states);
  expect_part(text,
              " single point constraint forces\n\n"
              " output at time =   2.50000E-01\n"
              " node=       5 local x,y,z forces =    1.0000E+00    2.0000E+00    3.0000E+00\n"
              " node=       5 local x,y,z moments=    4.0000E+00    5.0000E+00    6.0000E+00\n"
              " node=12345678 local x,y,z forces =   -1.0000E+00    0.0000E+00    0.0000E+00\n"
              "             force resultants   =    0.0000E+00    2.0000E+00    3.0000E+00\n");
  const auto history = read_whole(read_spcforc, text, 1, 3);
  EXPECT_EQ(history.states[0].rows[0].force, Vector(1, 2, 3));
  EXPECT_EQ(history.states[0].rows[0].moment, Vector(4, 5, 6));
  EXPECT_EQ(history.states[0].rows[2].node, 0);
  EXPECT_EQ(history.states[0].rows[2].force, Vector(0, 2, 3));
}

// Newer releases add the set behind the row.
TEST(Spcforc, SetsBehindTheRow) {
  Diagnostics diagnostics;
  const SupportHistory history = read_spcforc(
      " t\n p\n single point constraint forces\n\n output at time =   0.00000E+00\n node=       5 local x,y,z "
      "forces =    1.0000E+00    2.0000E+00    3.0000E+00 setid=       9\n",
      "spcforc", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  EXPECT_EQ(history.states.at(0).rows.at(0).force, Vector(1, 2, 3));
}

TEST(Bndout, LayoutAndRoundTrip) {
  const std::vector<BoundaryState> states{{BoundaryKind::velocity, false, 3, {1, 0, 0}, 0.5, {}},
                                          {BoundaryKind::velocity, true, 7, {2, 0, 0}, 0.25, {0, 0, 9}},
                                          {BoundaryKind::discrete, true, 8, {0, 4, 0}, 1, {}},
                                          {BoundaryKind::discrete, false, 2, {0, 1, 0}, 2, {}}};
  const std::string text = bndout_header(header) + bndout_text(0.25, states) + bndout_text(0.5, states);
  expect_part(text, " n o d a l   f o r c e/e n e r g y    o u t p u t   t=2.500E-01\n");
  expect_part(
      text,
      " discrete nodal point forces \n\n"
      " nd#       2  xforce=   0.0000E+00   yforce=   1.0000E+00  zforce=   0.0000E+00   energy=   2.0000E+00\n"
      " mt#       8  xforce=   0.0000E+00   yforce=   4.0000E+00  zforce=   0.0000E+00   energy=   1.0000E+00\n"
      "              xtotal=   0.0000E+00   ytotal=   5.0000E+00  ztotal=   0.0000E+00   etotal=   3.0000E+00\n");
  expect_part(text, "             xmoment=   0.0000E+00  ymoment=   0.0000E+00 zmoment=   9.0000E+00\n");
  const auto history = read_whole(read_bndout, text, 2, 4);
  const auto& rows = history.states[0].rows;
  EXPECT_EQ(rows[0].kind, BoundaryKind::discrete);
  EXPECT_EQ(rows[1].force, Vector(0, 4, 0));
  EXPECT_TRUE(rows[1].body);
  EXPECT_EQ(rows[2].kind, BoundaryKind::velocity);
  EXPECT_EQ(rows[2].energy, 0.5);
  EXPECT_EQ(rows[3].moment, Vector(0, 0, 9));
}

// Rows of the segments of a wall are left out.
TEST(Rwforc, LayoutAndRoundTrip) {
  const std::vector<WallForce> walls{{1, 5, {3, 4, 0}}, {12, 0, {}}};
  std::string text = rwforc_header(header, {{1, "front"}}) + rwforc_text(0.125, walls);
  expect_part(text,
              "    time       wall#   normal-force    x-force        y-force        z-force\n"
              " 1.25000E-01       1   5.000000E+00   3.000000E+00   4.000000E+00   0.000000E+00\n");
  text +=
      "                seg#    \n                   1                  1.000000E+00   2.000000E+00   3.000000E+00\n"
      "  total force                         1.000000E+00   2.000000E+00   3.000000E+00\n";
  const auto history = read_whole(read_rwforc, text, 1, 2);
  EXPECT_EQ(history.states[0].rows[0].normal, 5);
  EXPECT_EQ(history.states[0].rows[0].force, Vector(3, 4, 0));
  EXPECT_EQ(history.states[0].rows[1].wall, 12);
}

TEST(Rbdout, LayoutAndRoundTrip) {
  BodyMotion body;
  body.body = 7;
  body.position = {1, 2, 3};
  body.displacement = {4, 0, 0};
  body.velocity = {0, 5, 0};
  body.acceleration = {0, 0, 6};
  body.rotation = {0.5, 0, 0};
  body.spin = {0, 0.25, 0};
  body.spin_rate = {0, 0, 0.125};
  body.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  BodyMotion nodal = body;
  nodal.body = 9;
  nodal.nodal = true;
  const std::string text = rbdout_header(header) + rbdout_text(12, 0.5, std::vector{body, nodal});
  expect_part(text,
              "1\n\n  r i g i d   b o d y   m o t i o n   a t  cycle=      12    time=   5.000000E-01\n\n rigid body "
              "      7\n   global             x           y           z          x-rot       y-rot       z-rot\n"
              "   coordinates:    1.0000E+00  2.0000E+00  3.0000E+00\n"
              " displacements:    4.0000E+00  0.0000E+00  0.0000E+00  5.0000E-01  0.0000E+00  0.0000E+00\n");
  expect_part(text, "     row 1     0.0000E+00    -1.0000E+00     0.0000E+00\n");
  // Along a, which is the global y, it has moved by nothing, along b, the negative x, by −4.
  expect_part(text, " displacements:    0.0000E+00 -4.0000E+00  0.0000E+00  0.0000E+00 -5.0000E-01  0.0000E+00\n");
  const auto history = read_whole(read_rbdout, text, 1, 2);
  const BodyMotion& read = history.states[0].rows[0];
  EXPECT_EQ(read.position, body.position);
  EXPECT_EQ(read.displacement, body.displacement);
  EXPECT_EQ(read.velocity, body.velocity);
  EXPECT_EQ(read.acceleration, body.acceleration);
  EXPECT_EQ(read.rotation, body.rotation);
  EXPECT_EQ(read.spin, body.spin);
  EXPECT_EQ(read.spin_rate, body.spin_rate);
  EXPECT_EQ(read.axes, body.axes);
  EXPECT_TRUE(history.states[0].rows[1].nodal);
}

TEST(Swforc, LayoutAndRoundTrip) {
  const std::vector<WeldForce> welds{{WeldForce::Kind::link, 71, 3, 4, false, 0, 0, 0, 0},
                                     {WeldForce::Kind::beam, 5, 1, 2, false, 0, 0.5, 0, 0},
                                     {WeldForce::Kind::solid, 6, 0, 0, true, 0.25, 1, 0, 0}};
  const std::string text = swforc_header(header) + swforc_text(0.5, welds);
  expect_part(text,
              "\n constraint #      axial        shear         time                                                "
              "length\n"
              "          1  3.00000E+00  4.00000E+00  5.00000E-01             constraint/weld  ID       71\n"
              "          2  1.00000E+00  2.00000E+00  5.00000E-01             spotweld beam  ID          5  "
              "5.00000E-01\n"
              "          3  0.00000E+00  0.00000E+00  5.00000E-01  failure    spotweld solid ID          6  failure "
              "time=  2.5000E-01\n");
  const auto history = read_whole(read_swforc, text, 1, 3);
  const auto& rows = history.states[0].rows;
  EXPECT_EQ(rows[0].id, 71);
  EXPECT_EQ(rows[0].shear, 4);
  EXPECT_EQ(rows[1].kind, WeldForce::Kind::beam);
  EXPECT_EQ(rows[1].length, 0.5);
  EXPECT_TRUE(rows[2].failed);
  EXPECT_EQ(rows[2].failure_time, 0.25);
}

TEST(Elout, LayoutAndRoundTrip) {
  const StressRow point{{1, 2, 3, 4, 5, 6}, 0.5, 7, true}, other{{-1, 0, 0, 0, 0, 0}, 0, 1, false};
  const std::vector<ElementStress> elements{{StressKind::solid, 1, 2, {}, {point}, 1},
                                            {StressKind::beam, 3, 4, {1, 2, 3, 4, 5, 6}, {point, other}, 1},
                                            {StressKind::shell, 5, 6, {}, {point, other}, 2}};
  const std::string text =
      elout_header(header, {}) + elout_text(9, 0.5, false, elements) + elout_text(10, 1, false, elements);
  expect_part(
      text,
      " element  materl(global)\n"
      " ipt-shl  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx       plastic\n"
      "           state                                                                                 strain "
      "\n"
      "       5-      6\n"
      "   1-  1 plastic   1.0000E+00  2.0000E+00  3.0000E+00  4.0000E+00  5.0000E+00  6.0000E+00    5.0000E-01"
      "\n"
      "   2-  1 elastic  -1.0000E+00");
  expect_part(
      text,
      "       1 plastic   1.0000E+00  2.0000E+00  3.0000E+00  4.0000E+00  5.0000E+00  6.0000E+00    7.0000E+00   "
      " 5.0000E-01\n");
  expect_part(text,
              " beam/truss # =       3      material #  =    4\n\n\n resultants      axial    shear-s    shear-t    "
              "moment-s   moment-t   torsion\n             1.000E+00  2.000E+00  3.000E+00  4.000E+00  5.000E+00  "
              "6.000E+00\n");
  const auto history = read_whole(read_elout, text, 2, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const ElementStress& read = history.states[0].rows[i];
    EXPECT_EQ(read.kind, elements[i].kind);
    EXPECT_EQ(read.id, elements[i].id);
    EXPECT_EQ(read.part, elements[i].part);
    ASSERT_EQ(read.points.size(), elements[i].points.size()) << i;
    EXPECT_EQ(read.points[0].plastic_strain, 0.5);
  }
  EXPECT_EQ(history.states[0].rows[0].points[0].stress, point.stress);
  EXPECT_EQ(history.states[0].rows[0].points[0].effective, 7);
  EXPECT_EQ(history.states[0].rows[1].resultants, elements[1].resultants);
  EXPECT_EQ(history.states[0].rows[1].points[0].stress, (std::array<double, 6>{1, 0, 0, 4, 0, 6}));
  EXPECT_TRUE(history.states[0].rows[2].points[0].plastic);
  EXPECT_EQ(history.states[0].rows[2].layers, 2u);
}

TEST(Deforc, LayoutAndRoundTrip) {
  const std::vector<SpringForce> springs{{11, false, {3, 0, -4}, -5, 0.25}, {12, true, {0, 0, 2}, 2, 0.5}};
  const std::string text = deforc_header(header) + deforc_text(0.5, springs) + deforc_text(1, springs);
  expect_part(text,
              "\n time.........................   5.00000E-01\n"
              " spring/damper number.........        11\n"
              " x-force......................   3.00000E+00\n"
              " y-force......................   0.00000E+00\n"
              " z-force......................  -4.00000E+00\n"
              " resultant force..............  -5.00000E+00\n"
              " change in length.............   2.50000E-01\n"
              " spring/damper number.........        12\n"
              " x-moment.....................   0.00000E+00\n");
  expect_part(text,
              " resultant moment.............   2.00000E+00\n"
              " relative rotation............   5.00000E-01\n");
  const auto history = read_whole(read_deforc, text, 2, 2);
  EXPECT_EQ(history.states[1].time, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const SpringForce& read = history.states[0].rows[i];
    EXPECT_EQ(read.spring, springs[i].spring);
    EXPECT_EQ(read.torsional, springs[i].torsional);
    EXPECT_EQ(read.force, springs[i].force);
    EXPECT_EQ(read.resultant, springs[i].resultant);
    EXPECT_EQ(read.change, springs[i].change);
  }
}

TEST(Abstat, LayoutAndRoundTrip) {
  const std::vector<AirbagRow> bags{{7, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5}, {12, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
  const std::string text = abstat_header(header, {{7, "bag"}}) + abstat_text(0.5, bags) + abstat_text(1, bags);
  expect_part(
      text,
      "\n\n      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt "
      "out  total mass gas temp. surface area\n"
      " 5.00000E-01       7     1.5000E+00     2.5000E+00     3.5000E+00     4.5000E+00     5.5000E+00  "
      "6.500E+00  7.500E+00  8.500E+00  9.500E+00\n");
  const auto history = read_whole(read_abstat, text, 2, 2);
  EXPECT_EQ(history.states[1].time, 1);
  EXPECT_EQ(history.titles.size(), 1u);
  for (std::size_t i = 0; i < 2; ++i) {
    const AirbagRow& read = history.states[0].rows[i];
    EXPECT_EQ(read.airbag, bags[i].airbag);
    EXPECT_EQ(read.volume, bags[i].volume);
    EXPECT_EQ(read.pressure, bags[i].pressure);
    EXPECT_EQ(read.energy, bags[i].energy);
    EXPECT_EQ(read.rate_in, bags[i].rate_in);
    EXPECT_EQ(read.density, bags[i].density);
    EXPECT_EQ(read.rate_out, bags[i].rate_out);
    EXPECT_EQ(read.mass, bags[i].mass);
    EXPECT_EQ(read.temperature, bags[i].temperature);
    EXPECT_EQ(read.area, bags[i].area);
  }
  // A row may have the reaction force behind these.
  const std::string longer = text.substr(0, text.size() - 1) + "  1.000E+00\n";
  EXPECT_EQ(read_whole(read_abstat, longer, 2, 2).states[1].rows[1].area, 9);
}

// Rows of joint stiffnesses are left out.
TEST(Jntforc, LayoutAndRoundTrip) {
  const std::vector<JointForce> joints{{5, false, {3, 0, -4}, {0, 1, 0}}, {6, true, {1, 2, 2}, {0, 0, -1}}};
  const std::string text = jntforc_header(header) + jntforc_text(0.5, joints) +
                           " joint stiffness id number....         7\n phi moment-total.............   9.00000E+00\n" +
                           jntforc_text(1, joints);
  expect_part(text,
              "\n\n time.........................   5.00000E-01\n"
              " joint ID.....................         5\n"
              " x-force......................   3.00000E+00\n");
  expect_part(text,
              " y-moment.....................   1.00000E+00\n"
              " z-moment.....................   0.00000E+00\n"
              " resultant force..............   5.00000E+00\n"
              " resultant moment.............   1.00000E+00\n"
              " joint ID.....................         6\n"
              " x-force  (local) ............   1.00000E+00\n");
  expect_part(text, " z-moment (local) ............  -1.00000E+00\n");
  const auto history = read_whole(read_jntforc, text, 2, 2);
  EXPECT_EQ(history.states[1].time, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const JointForce& read = history.states[0].rows[i];
    EXPECT_EQ(read.joint, joints[i].joint);
    EXPECT_EQ(read.local, joints[i].local);
    EXPECT_EQ(read.force, joints[i].force);
    EXPECT_EQ(read.moment, joints[i].moment);
  }
}

// Cut anywhere, and of bytes that are none of theirs, the readers come back.
TEST(HistoryFiles, HostileText) {
  const std::string text = secforc_text(1, std::vector<SectionState>{{1, {}, {}, {}, 1}}) +
                           bndout_text(1, {{BoundaryKind::velocity, true, 7, {}, 0, {}}}) +
                           elout_text(1, 1, true, std::vector<ElementStress>{{StressKind::beam, 1, 1, {}, {{}}, 1}}) +
                           rbdout_text(1, 1, std::vector<BodyMotion>(1)) + swforc_text(1, std::vector<WeldForce>(1)) +
                           spcforc_text(1, {{{1, true, true, {}, {}}}, {}}) + rwforc_header(header, {}) +
                           rwforc_text(1, std::vector<WallForce>(1)) + deforc_text(1, std::vector<SpringForce>(1)) +
                           jntforc_text(1, std::vector<JointForce>(1)) + abstat_text(1, std::vector<AirbagRow>(1));
  for (std::size_t cut = 0; cut < text.size(); cut += 11) {
    std::string part = text.substr(cut);
    if (part.size() > 40) part[40] = '*';
    Diagnostics diagnostics;
    const auto states = [&](auto read) { return read(part, "f", diagnostics).states.size(); };
    for (const std::size_t number :
         {states(read_secforc), states(read_spcforc), states(read_bndout), states(read_rwforc), states(read_rbdout),
          states(read_swforc), states(read_elout), states(read_deforc), states(read_jntforc), states(read_abstat)})
      EXPECT_LE(number, 9u);
  }
}

}  // namespace
}  // namespace gapcheck::results::history_files_test
