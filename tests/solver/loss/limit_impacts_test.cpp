// Ten impacts at the limit of their contact: where the predicted margin is 1.1 the run holds every node, where it is
// 0.9 it loses some. And bodies that deform, whose run lies between the bounds.
#include <functional>
#include <vector>

#include "solver/loss/impact_scene.hpp"

namespace gapcheck::solver::limit_impacts_test {
namespace {

constexpr double gap = 1.3;

/// A deck by the speed of its part 2.
struct LimitImpact {
  std::string name;
  std::function<std::string(double speed)> deck;
  double speed;  ///< one at which it can be judged
};

/// A rigid sheet on a rigid plate, both 1 thick. `more`: further keywords.
std::function<std::string(double)> sheet_on_plate(const ImpactContact& contact, int held = 7, double step = 1e-4,
                                                  const std::string& more = "") {
  return [=](double speed) {
    return shell_sheet(1, 3, 5, 0) + shell_sheet(2, 2, 4, 1 + gap) + shell_part(1, 1, rigid_steel(1, held)) +
           shell_part(2, 1, rigid_steel(2, 0, 7.85e-5)) + contact.text() + more + thrown(2, speed) +
           ends_at(gap / speed + 0.3, step);
  };
}

ImpactContact contact_of(const std::string& type) {
  ImpactContact contact;
  contact.type = type;
  return contact;
}

/// Mass points above a plate that is held; they reach their margins one by one.
std::string points_on_plate(double speed) {
  std::string text = shell_sheet(1, 2, 10, 0) + shell_part(1, 1, elastic_steel(1)) + "*NODE\n";
  const double masses[] = {1e-3, 2e-3, 4e-3};
  for (int i = 0; i < 3; ++i) text += fmt::format("{},{},{},{}\n", 2001 + i, -4.0 + 4 * i, 3.0, 0.5 + gap + 0.1 * i);
  text += "*ELEMENT_MASS\n";
  for (int i = 0; i < 3; ++i) text += fmt::format("{},{},{}\n", 2001 + i, 2001 + i, masses[i]);
  text += "*SET_NODE_LIST\n2\n2001,2002,2003\n*SET_PART_LIST\n1\n1\n*SET_NODE_LIST\n1\n";
  for (int i = 0; i < 9; ++i) text += fmt::format("{},", 1001 + i) + (i == 7 ? "\n" : "");
  return text + "\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n" +
         fmt::format("*INITIAL_VELOCITY\n2\n0.,0.,{:.17g}\n", -speed) +
         "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,1,4,2\n0.\n1.,1.\n" + ends_at(gap / speed + 0.3, 0, 0.1);
}

/// The plate comes with a constant speed that is prescribed, and the sheet is free.
std::string driven_plate(double speed) {
  return shell_sheet(1, 3, 5, 0) + shell_sheet(2, 2, 4, 1 + gap) + shell_part(1, 1, rigid_steel(1, 4)) +
         shell_part(2, 1, rigid_steel(2, 0, 7.85e-5)) + ImpactContact{}.text() +
         fmt::format("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,3,0,1,{:.17g}\n*DEFINE_CURVE\n1\n0.,1.\n100.,1.\n", speed) +
         ends_at(gap / speed + 0.3, 1e-4);
}

std::vector<LimitImpact> limit_impacts() {
  ImpactContact soft, thick = contact_of("AUTOMATIC_SINGLE_SURFACE"), stiff, old = contact_of("SURFACE_TO_SURFACE");
  soft.soft = 1;
  thick.sst = 1.4;
  stiff.sfs = 3;
  std::vector<LimitImpact> list;
  list.push_back({"nodes of a rigid sheet on a plate", sheet_on_plate({}), 100});
  list.push_back({"both sides", sheet_on_plate(contact_of("AUTOMATIC_SURFACE_TO_SURFACE")), 100});
  list.push_back({"single surface with SST", sheet_on_plate(thick), 100});
  list.push_back({"SOFT = 1", sheet_on_plate(soft), 500});
  list.push_back({"two free sheets", sheet_on_plate({}, 0), 100});
  list.push_back({"scaled stiffness", sheet_on_plate(stiff), 100});
  list.push_back(
      {"two contacts for one pair", sheet_on_plate({}, 7, 1e-4, contact_of("AUTOMATIC_NODES_TO_SURFACE").text()), 100});
  list.push_back({"an old type, released at XPENE thicknesses",
                  sheet_on_plate(old, 7, 1e-4, "*CONTROL_CONTACT\n0.1,0.,0,1,0,1,0,0\n0,0,0,0,2.\n"), 300});
  list.push_back({"a rigid block on a block",
                  [](double speed) {
                    return brick_block(1, 3, 1, 10, -10) + brick_block(2, 1, 1, 8, gap) +
                           solid_part(1, rigid_steel(1, 7)) + solid_part(2, rigid_steel(2, 0, 7.85e-5)) +
                           contact_of("AUTOMATIC_SURFACE_TO_SURFACE").text() + thrown(2, speed) +
                           ends_at(gap / speed + 0.3, 2e-5);
                  },
                  100});
  list.push_back({"mass points on a held plate", points_on_plate, 20});
  list.push_back({"an elastic shell with all of its mass at its corners",
                  [](double speed) {
                    return shell_sheet(1, 3, 5, 0) + shell_sheet(2, 1, 4, 1 + gap) +
                           shell_part(1, 1, rigid_steel(1, 7)) + shell_part(2, 1, elastic_steel(2, 7.85e-4)) +
                           ImpactContact{}.text() + thrown(2, speed) + ends_at(gap / speed + 0.3, 0, 0.1);
                  },
                  10});
  list.push_back({"a driven plate", driven_plate, 100});
  return list;
}

TEST(LimitImpacts, TheRunLosesContactWhereItIsPredicted) {
  std::size_t judged = 0;
  for (const LimitImpact& impact : limit_impacts()) {
    SCOPED_TRACE(impact.name);
    const Expectation any(impact.deck(impact.speed));
    ASSERT_TRUE(any.report.expected) << any.refused;
    ASSERT_FALSE(any.all().contacts.empty());
    ASSERT_TRUE(any.worst().margin) << any.worst().reason;
    EXPECT_TRUE(any.worst().reason.empty()) << any.worst().reason;
    const double limit = impact.speed * *any.worst().margin;
    for (const double margin : {1.1, 0.9}) {
      const std::string deck = impact.deck(limit / margin);
      const ExpectedContact said = Expectation(deck).worst();
      ASSERT_TRUE(said.margin) << said.reason;
      EXPECT_NEAR(*said.margin, margin, 1e-9 * margin) << "margins go with 1 / v";
      ASSERT_TRUE(said.low && said.high);
      EXPECT_LE(*said.low, *said.margin);
      EXPECT_GE(*said.high, *said.margin);
      EXPECT_LT(*said.high / *said.low, 1.1);
      const RunImpact run = run_impact(deck);
      fmt::print("{}: speed {:.5g}, margin {:.4g} ({:.4g} to {:.4g}), run: deepest {:.4g} of its release depth, {}\n",
                 impact.name, limit / margin, *said.margin, *said.low, *said.high, run.share,
                 run.released > 0 ? "lost" : "held");
      EXPECT_EQ(run.released > 0, margin < 1);
      EXPECT_EQ(said.held(), margin > 1);
      EXPECT_EQ(said.lost(), margin < 1);
      // The depth itself where it is held.
      if (margin > 1) {
        EXPECT_LE(run.share, 1 / *said.low * (1 + 2e-3));
        EXPECT_GE(run.share, 1 / *said.high * (1 - 2e-3));
      }
      // The first force comes in the step in which they have met.
      EXPECT_GE(run.touched, said.time * (1 - 1e-12));
      EXPECT_LE(run.touched, said.time + Expectation(deck).all().step * (1 + 1e-6));
    }
    ++judged;
  }
  EXPECT_GE(judged, 10u);
}

// PENMAX and SHLTHK are 0: nodes are never released, but an old segment sees no farther behind itself than half its
// shorter diagonal. What gets there passes through.
TEST(LimitImpacts, NodesPassAnOldSegmentThatDoesNotSeeThem) {
  const auto deck = sheet_on_plate(contact_of("NODES_TO_SURFACE"));
  const double limit = 300 * Expectation(deck(300)).worst().margin.value();
  const ExpectedContact held = Expectation(deck(limit / 1.1)).worst(), lost = Expectation(deck(limit / 0.9)).worst();
  EXPECT_TRUE(held.held());
  EXPECT_TRUE(lost.lost());
  EXPECT_GT(run_impact(deck(limit / 1.1)).way_back, 0);
  EXPECT_LT(run_impact(deck(limit / 0.9)).way_back, 0);
  // 5 / sqrt 2.
  EXPECT_NEAR(run_impact(deck(limit / 1.1)).depth * 1.1, 5 / std::sqrt(2), 0.01);
}

TEST(LimitImpacts, TheRunOfDeformingPartsLiesBetweenTheBounds) {
  const auto sheet = [](double speed) {
    return shell_sheet(1, 3, 5, 0) + shell_sheet(2, 3, 4, 1 + gap) + shell_part(1, 1, rigid_steel(1, 7)) +
           shell_part(2, 1, elastic_steel(2)) + ImpactContact{}.text() + thrown(2, speed) +
           ends_at(gap / speed + 0.1, 0, 0.4);
  };
  const auto sheets = [](double speed) {
    return shell_sheet(1, 4, 5, 0) + shell_sheet(2, 3, 4, 1 + gap) + shell_part(1, 1, elastic_steel(1)) +
           shell_part(2, 1, elastic_steel(2)) + contact_of("AUTOMATIC_SINGLE_SURFACE").text() + thrown(2, speed) +
           ends_at(gap / speed + 0.1, 0, 0.4);
  };
  const auto bar = [](double speed) {
    return brick_block(1, 1, 1, 10, -10) + brick_block(2, 2, 6, 2, gap) + solid_part(1, rigid_steel(1, 7)) +
           solid_part(2, elastic_steel(2)) + contact_of("AUTOMATIC_SURFACE_TO_SURFACE").text() + thrown(2, speed) +
           ends_at(gap / speed + 0.02);
  };
  const auto bars = [](double speed) {
    return brick_block(1, 2, 6, 2, -12) + brick_block(2, 2, 6, 2, gap) + solid_part(1, elastic_steel(1)) +
           solid_part(2, elastic_steel(2)) + contact_of("AUTOMATIC_SURFACE_TO_SURFACE").text() + thrown(2, speed) +
           ends_at(gap / speed + 0.02);
  };
  struct Deforming {
    std::string name;
    std::function<std::string(double)> deck;
    std::vector<double> speeds;
  };
  const std::vector<Deforming> list{{"sheet on plate", sheet, {50, 100, 200, 400, 550, 800, 1100, 1300, 1500}},
                                    {"sheet on sheet", sheets, {50, 90, 200, 400, 700, 1000}},
                                    {"bar on block", bar, {20, 100, 300, 700, 1000}},
                                    {"bar on bar", bars, {20, 60, 120, 250, 500}}};
  int held = 0, lost = 0;
  for (const Deforming& one : list)
    for (const double speed : one.speeds) {
      SCOPED_TRACE(fmt::format("{} at {}", one.name, speed));
      const std::string deck = one.deck(speed);
      const Expectation said(deck);
      ASSERT_FALSE(said.all().contacts.empty());
      const RunImpact run = run_impact(deck);
      for (const ExpectedContact& e : said.all().contacts) {
        fmt::print("{} at {}: {} to {} (nodes alone {:.3g}), run {:.3g}, {}\n", one.name, speed,
                   e.low ? fmt::format("{:.3g}", *e.low) : "-", e.high ? fmt::format("{:.3g}", *e.high) : "-",
                   e.alone.value_or(0), 1 / run.share, run.released > 0 ? "lost" : "held");
        EXPECT_FALSE(e.margin) << "no margin of the run is promised";
        EXPECT_EQ(e.reason, "parts deform");
        ASSERT_TRUE(e.low);
        if (run.released > 0) {
          EXPECT_FALSE(e.held());
          EXPECT_LE(*e.low, 1);
        } else {
          EXPECT_FALSE(e.lost());
          EXPECT_GE(1 / run.share, *e.low);
          if (e.high) {
            EXPECT_LE(1 / run.share, *e.high);
          }
        }
        held += e.held();
        lost += e.lost();
      }
    }
  EXPECT_GT(held, 2) << "the bounds decide something";
  EXPECT_GT(lost, 0);
}

TEST(LimitImpacts, RemediesGiveAMarginOfTwoInTheRun) {
  ImpactContact plain, soft;
  soft.soft = 1;
  const auto with_step = [](const ImpactContact& contact, double step) { return sheet_on_plate(contact, 7, step); };
  // What a deck with margin 2 does at the speeds that make it 1.1 and 0.9.
  const auto expect_two = [](const std::function<std::string(double)>& deck, double speed, double tolerance) {
    const ExpectedContact said = Expectation(deck(speed)).worst();
    ASSERT_TRUE(said.margin) << said.reason;
    EXPECT_NEAR(*said.margin, 2, tolerance);
    EXPECT_EQ(run_impact(deck(speed)).released, 0u);
    EXPECT_EQ(run_impact(deck(speed * 2 / 1.1)).released, 0u);
    EXPECT_GT(run_impact(deck(speed * 2 / 0.9)).released, 0u);
  };
  const double limit = 100 * *Expectation(sheet_on_plate(plain)(100)).worst().margin;
  const ExpectedContact bad = Expectation(sheet_on_plate(plain)(limit / 0.9)).worst();
  ASSERT_TRUE(bad.thickness);
  EXPECT_EQ(bad.thickness_card, "SST");
  // 0.4 (SST + 1) = 2 / 0.9 * 0.4 (1 + 1).
  EXPECT_NEAR(*bad.thickness, 4 / 0.9 - 1, 1e-9);
  ASSERT_FALSE(bad.step) << "the stiffness of SOFT = 0 does not follow the step";
  // The gap leaves room for half of it.
  ImpactContact thicker = plain;
  thicker.sst = *bad.thickness;
  {
    SCOPED_TRACE("SST");
    if (thicker.sst / 2 + 0.5 < 1 + gap) expect_two(sheet_on_plate(thicker), limit / 0.9, 1e-9);
  }
  ASSERT_TRUE(bad.sofscl);
  ImpactContact softer = plain;
  softer.soft = 1;
  softer.sofscl = *bad.sofscl;
  {
    SCOPED_TRACE("SOFSCL");
    expect_two(sheet_on_plate(softer), limit / 0.9, 1e-6);
  }
  const double soft_limit = 500 * *Expectation(with_step(soft, 4e-4)(500)).worst().margin;
  const ExpectedContact too_coarse = Expectation(with_step(soft, 4e-4)(soft_limit / 0.9)).worst();
  ASSERT_TRUE(too_coarse.step);
  EXPECT_LT(*too_coarse.step, 4e-4 * 0.9 / 2 * 1.01);
  {
    SCOPED_TRACE("step");
    expect_two(with_step(soft, *too_coarse.step), soft_limit / 0.9, 1e-6);
  }
}

}  // namespace
}  // namespace gapcheck::solver::limit_impacts_test
