// Runs of the decks of data/workshop/ against the curves that scripts/make_reference_curves.py kept of them.
#include <fmt/format.h>

#include <regex>
#include <vector>

#include "program.hpp"

namespace gapcheck::workshop_curves_test {
namespace {

namespace fs = std::filesystem;

const fs::path workshop = fs::path(GAPCHECK_ROOT) / "data/workshop";

/// The deck with output intervals fifty times as long, as the script makes it.
std::string coarse(const std::string& text) {
  static const std::regex interval("(\\*DATABASE_(?:GLSTAT|SLEOUT|NCFORC|RCFORC|NODOUT)\n)\\s*(\\S+)");
  std::string result;
  auto at = text.cbegin();
  for (auto found = std::sregex_iterator(text.begin(), text.end(), interval); found != std::sregex_iterator();
       ++found) {
    result.append(at, (*found)[0].first);
    result += (*found)[1].str() + fmt::format("{:10.4g}", std::stod((*found)[2].str()) * 50);
    at = (*found)[0].second;
  }
  return result.append(at, text.cend());
}

class WorkshopCurves : public Program {
 protected:
  /// Runs a deck that a text is and compares the run with the reference of `name`.
  [[nodiscard]] Ended compared(const std::string& text, const std::string& name) const {
    file("deck.k", text);
    const Ended run = gapcheck("run deck.k -o out --quiet");
    EXPECT_EQ(run.code, 0) << name << run.err;
    return gapcheck("compare '" + (workshop / "curves" / name).string() + "' out");
  }
};

TEST_F(WorkshopCurves, EveryDeckRunsAsItsReference) {
  std::size_t decks = 0;
  for (const auto& entry : fs::directory_iterator(workshop)) {
    if (entry.path().extension() != ".k") continue;
    const std::string name = entry.path().stem();
    ++decks;
    ASSERT_TRUE(fs::exists(workshop / "curves" / name)) << name << ": run scripts/make_reference_curves.py";
    const Ended run = compared(coarse(content(entry.path())), name);
    EXPECT_EQ(run.code, 0) << name << '\n' << run.out << run.err;
    EXPECT_NE(run.out.find("curves agree"), std::string::npos) << name << '\n' << run.out;
  }
  EXPECT_GE(decks, 28u);
}

TEST_F(WorkshopCurves, AChangedPenaltyIsFound) {
  std::string text = coarse(content(workshop / "rebound_reference.k"));
  text.insert(text.rfind("*END"), "*CONTROL_CONTACT\n      0.11\n");
  const Ended run = compared(text, "rebound_reference");
  EXPECT_EQ(run.code, 1) << run.err;
  for (const char* curve : {"nodout", "glstat sliding"}) EXPECT_NE(run.out.find(curve), std::string::npos) << run.out;
}

}  // namespace
}  // namespace gapcheck::workshop_curves_test
