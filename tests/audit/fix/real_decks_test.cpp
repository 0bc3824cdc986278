// Decks by other authors, where they are at hand.
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "audit/fix/run_fix.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::real_decks_test {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(GAPCHECK_ROOT) / ".." / "shared" / "decks";

#define NEED_REAL_DECKS() \
  if (!fs::exists(folder)) GTEST_SKIP() << "no decks in " << folder << "; put them there to run this test"

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(FixRealDecks, ACarIsFreeAndNothingElseHasChanged) {
  NEED_REAL_DECKS();
  const fs::path path = fs::canonical(folder / "car6/car6_crash.k");
  // Three spot welds join nodes that are too near to each other: those six stay, and nothing else.
  const FixRun welded = fix_file(path.string());
  EXPECT_EQ(welded.report().unfixed.size(), 6u);
  for (const UnfixedNode& node : welded.report().unfixed) EXPECT_EQ(node.reason, HoldReason::constrained);
  audit::FixOptions free_welds;
  free_welds.free_welds = true;
  const FixRun run = fix_file(path.string(), free_welds);
  EXPECT_TRUE(complete(run.report()));
  EXPECT_LE(run.report().crossings_after, run.report().crossings_before);
  audit::AuditOptions options;
  options.select = {"GC101", "GC102"};
  EXPECT_FALSE(run_file(path.string(), options).report.penetrations.empty());
  EXPECT_TRUE(run_text(run.text, options).report.penetrations.empty());
  std::ostringstream original;
  original << std::ifstream(path, std::ios::binary).rdbuf();
  const auto before = lines_of(original.str()), after = lines_of(run.text);
  ASSERT_EQ(before.size(), after.size());
  std::set<std::size_t> listed;
  for (const MovedNode& m : run.report().moved) listed.insert(m.line - 1);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i] != after[i], listed.contains(i)) << i + 1;
}

TEST(FixRealDecks, ADeckWithoutPenetrationsStays) {
  NEED_REAL_DECKS();
  const FixRun run = fix_file((folder / "ball_plate/ball_plate.k").string());
  EXPECT_TRUE(complete(run.report()));
  EXPECT_TRUE(run.report().moved.empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::real_decks_test
