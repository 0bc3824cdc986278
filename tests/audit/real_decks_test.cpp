// Decks by other authors, where they are at hand: everything in them is read, and all ways to search agree.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "audit/naive_count.hpp"
#include "audit/run.hpp"
#include "base/parallel.hpp"

namespace gapcheck::audit_test::real_decks_test {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(GAPCHECK_ROOT) / ".." / "shared" / "decks";
constexpr std::uint64_t small = 30000;  ///< nodes that the slow search can deal with

#define NEED_REAL_DECKS() \
  if (!fs::exists(folder)) GTEST_SKIP() << "no decks in " << folder << "; put them there to run this test"

const std::vector<std::string> whole_decks = {
    "ball_plate/ball_plate.k",
    "bird_on_panel/bird.k",
    "bird_strike_composite/input.k",
    "birdball_eroding/birdball.k",
    "car6/car6_crash.k",
    "car6_refined/lsopt_car6/main_v22.k",
    "car6_refined/lsopt_car6/main_v222.k",
    "roll_forming/model.k",
    "small_decks/tests/testfiles/run/case-keywords/projectile.k",
    "tied_plate_with_run/main.k",
    "two_body_impact/main.k",
};

class RealDeck : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static std::string path() { return (folder / GetParam()).lexically_normal().string(); }
};

TEST_P(RealDeck, IsReadWhole) {
  NEED_REAL_DECKS();
  const AuditRun run = run_file(path());
  ASSERT_TRUE(clean(run));
  const NaiveCount count = naive_count(path());
  EXPECT_EQ(run.report.model.nodes, count.nodes);
  EXPECT_EQ(run.report.model.shells, count.shells);
  EXPECT_EQ(run.report.model.solids, count.solids);
  EXPECT_EQ(run.report.model.beams, count.beams);
  EXPECT_EQ(run.report.model.particles, count.particles);
  EXPECT_EQ(run.report.model.parts, count.parts);
}

TEST_P(RealDeck, ReportsEveryContact) {
  NEED_REAL_DECKS();
  const AuditRun run = run_file(path());
  ASSERT_TRUE(clean(run));
  const NaiveCount count = naive_count(path());
  ASSERT_EQ(run.report.contacts.size(), count.contacts.size());
  for (std::size_t i = 0; i < count.contacts.size(); ++i) {
    const auto& contact = run.report.contacts[i];
    EXPECT_TRUE(count.contacts[i].starts_with(contact.keyword)) << count.contacts[i] << " as " << contact.keyword;
    EXPECT_EQ(contact.order, i + 1);
    EXPECT_FALSE(contact.file.empty());
    EXPECT_GT(contact.line, 0u);
  }
}

TEST_P(RealDeck, AllSearchesAgree) {
  NEED_REAL_DECKS();
  const AuditRun fast = run_file(path());
  ASSERT_TRUE(clean(fast));
  if (fast.report.model.nodes > small) GTEST_SKIP() << "too large for the slow search";
  audit::AuditOptions slow, exact;
  slow.brute_force = true;
  exact.exact = true;
  EXPECT_EQ(dump(fast.report), dump(run_file(path(), slow).report));
  EXPECT_EQ(dump(fast.report), dump(run_file(path(), exact).report));
  const JobLimit one(1);
  EXPECT_EQ(dump(fast.report), dump(run_file(path()).report));
}

std::string test_name(const testing::TestParamInfo<std::string>& instance) {
  std::string name = instance.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Decks, RealDeck, testing::ValuesIn(whole_decks), test_name);

struct Incomplete {
  std::string deck, first_missing;
};

class IncompleteDeck : public testing::TestWithParam<Incomplete> {};

TEST_P(IncompleteDeck, NamesTheMissingFileAndWorksWithoutIt) {
  NEED_REAL_DECKS();
  const std::string path = (folder / GetParam().deck).lexically_normal().string();
  const AuditRun strict = run_file(path);
  EXPECT_GT(strict.errors(), 0u);
  const auto& all = strict.diagnostics;
  const auto named = std::find_if(all.begin(), all.end(), [](const Diagnostic& d) {
    return d.severity == Severity::error && d.message.find(GetParam().first_missing) != std::string::npos;
  });
  ASSERT_NE(named, all.end()) << describe(all);
  EXPECT_EQ(fs::path(named->file).filename(), fs::path(path).filename());
  EXPECT_GT(named->line, 0u);

  audit::AuditOptions lenient;
  lenient.read.skip_missing_includes = true;
  const AuditRun run = run_file(path, lenient);
  EXPECT_TRUE(clean(run));
}

INSTANTIATE_TEST_SUITE_P(
    Decks, IncompleteDeck,
    testing::Values(
        Incomplete{"body_contacts_no_mesh/model/50F-seated/vivaplus-50F.key", "vivaplus"},
        Incomplete{"shoes/model/50F-standing/vivaplus-50F-standing.key", "vivaplus_50F-standing_nodes.k"},
        Incomplete{"l_bracket/tests/testfiles/run/case-keywords/L_bracket_dynain.key", "database_cards_static.key"},
        Incomplete{"l_bracket/tests/testfiles/run/case-keywords/L_bracket_allin1.key", "control_cards_nonlin.key"}));

/// An optimiser's template: without its parameters an error names each, with them it is whole.
TEST(TemplateDeck, NeedsItsParameters) {
  NEED_REAL_DECKS();
  const std::string path = fs::canonical(folder / "car5/car5.k").string();
  const AuditRun bare = run_file(path);
  ASSERT_GT(bare.errors(), 0u);
  for (const auto& d : bare.diagnostics) {
    if (d.severity == Severity::error) {
      EXPECT_NE(d.message.find("parameter"), std::string::npos) << describe({d});
    }
  }
  const AuditRun run =
      run_text("*KEYWORD\n*PARAMETER\nRtbumper         3.0\nRthood           1.0\n*INCLUDE\n" + path + "\n");
  ASSERT_TRUE(clean(run));
  const NaiveCount count = naive_count(path);
  EXPECT_EQ(run.report.model.nodes, count.nodes);
  EXPECT_EQ(run.report.model.shells, count.shells);
  EXPECT_EQ(run.report.contacts.size(), count.contacts.size());
}

// The solver's own run of this deck counts three constraint equations for each node that it tied.
TEST(RealRun, TiesAsManyNodesAsTheSolver) {
  NEED_REAL_DECKS();
  std::ifstream messag(folder / "tied_plate_with_run" / "messag");
  std::uint64_t equations = 0;
  for (std::string line; equations == 0 && std::getline(messag, line);)
    if (line.find("no. of tie ") != std::string::npos) equations = std::stoull(line.substr(line.find('=') + 1));
  ASSERT_GT(equations, 0u);
  const AuditRun run = run_file((folder / "tied_plate_with_run/main.k").string());
  std::uint64_t ties = 0;
  for (const ContactSummary& contact : run.report.contacts) ties += contact.ties;
  EXPECT_EQ(3 * ties, equations);
  EXPECT_TRUE(run.report.tie_failures.empty());  // and it printed no warning of an untied node
}

/// What stands behind the last `=` of the lines with these words.
std::vector<std::string> printed(const fs::path& path, const std::string& words) {
  std::vector<std::string> values;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.find(words) == std::string::npos) continue;
    std::string value = line.substr(line.rfind('=') == std::string::npos ? line.rfind(' ') : line.rfind('=') + 1);
    std::erase(value, ' ');
    values.push_back(value);
  }
  return values;
}

// The solver backed the two ties of this run with penalty contacts between the same segments, and printed their time
// steps. The material is that of the run (density as echoed, E and ν at the start), which the deck beside it no longer
// has.
TEST(RealRun, TimeStepsOfContactAreThoseThatTheSolverPrints) {
  NEED_REAL_DECKS();
  const fs::path run_folder = fs::canonical(folder / "tied_plate_with_run");
  std::string deck = "*KEYWORD\n*MAT_ELASTIC\n1,7.8e-9,210000.,0.3\n*SECTION_SOLID\n1,2\n*CONTROL_TIMESTEP\n0.1,1.0\n";
  for (const char* part : {"1", "2", "3"}) deck += std::string("*PART\npart\n") + part + ",1,1\n";
  for (const char* contact : {"80086,\n6767,67671,0,0", "8009,\n6969,69691,0,0"})
    deck += std::string("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n") + contact + "\n0.\n1.,1.\n";
  for (const char* file : {"geometry.k", "boundary.k"}) deck += "*INCLUDE\n" + (run_folder / file).string() + "\n";
  audit::AuditOptions options;
  options.select = {"GC420"};
  const AuditRun run = run_text(deck, options);
  ASSERT_TRUE(clean(run)) << describe(run.diagnostics);
  ASSERT_TRUE(run.report.predicted);

  const fs::path messag = run_folder / "messag";
  const auto steps = printed(messag, "surface timestep "), nodes = printed(messag, "controlling surf"),
             parts = printed(messag, "part ID of surf"), limit = printed(messag, "should not exceed");
  const auto& predicted = run.report.predicted->surface_timesteps;
  ASSERT_EQ(steps.size(), 4u);
  ASSERT_EQ(predicted.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(fmt::format("{:.3E}", predicted[i].timestep), steps[i]);
    EXPECT_EQ(std::to_string(predicted[i].node), nodes.at(i));
    EXPECT_EQ(std::to_string(predicted[i].part), parts.at(i));
  }
  ASSERT_EQ(limit.size(), 1u);
  EXPECT_EQ(fmt::format("{:.3E}", run.report.predicted->contact_timestep), limit[0]);

  std::ifstream d3hsp(run_folder / "d3hsp");
  std::string line, kind, step;
  while (std::getline(d3hsp, line) && line.find("100 smallest timesteps") == std::string::npos) continue;
  for (int skipped = 0; skipped < 3; ++skipped) std::getline(d3hsp, line);
  std::istringstream(line) >> kind >> kind >> step >> step;
  EXPECT_EQ(fmt::format("{:.4E}", run.report.predicted->element_timestep), step);
}

/// Fragments, templates and decks of other solvers' physics: no crash, and a report or a reason.
TEST(AnyDeck, GivesAReportOrAReason) {
  NEED_REAL_DECKS();
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    const bool deck = extension == ".k" || extension == ".key" || extension == ".dyn" || extension == ".asc";
    if (!deck || !entry.is_regular_file()) continue;
    const AuditRun run = run_file(entry.path().string());
    EXPECT_TRUE(run.ok || run.errors() > 0) << entry.path();
    for (const auto& d : run.diagnostics) EXPECT_FALSE(d.message.empty()) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 100u);
}

}  // namespace
}  // namespace gapcheck::audit_test::real_decks_test
