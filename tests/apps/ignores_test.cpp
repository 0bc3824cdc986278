// Ignores as users see them; the example of their page is run.
#include <gtest/gtest.h>

#include <string>

#include "program.hpp"

namespace gapcheck::ignores_test {
namespace {

class Ignores : public Program {
 protected:
  /// The first comment of the page, in front of an example deck.
  void write_deck() const {
    const std::string page = content(project / "docs/ignores.md"), mark = "    $ gapcheck: ";
    const auto at = page.find(mark);
    ASSERT_NE(at, page.npos);
    file("model.k", page.substr(at + 4, page.find('\n', at) - at - 3) + content(project / "data/two_plates.k"));
  }
  /// The page's block between its marks, without the indentation.
  static std::string example() {
    const std::string page = content(project / "docs/ignores.md"), begin = "<!-- example: begin -->\n";
    const auto from = page.find(begin) + begin.size(), to = page.find("<!-- example: end -->");
    std::string text;
    std::istringstream lines(page.substr(from, to - from));
    for (std::string line; std::getline(lines, line);) text += (line.empty() ? line : line.substr(4)) + '\n';
    return text;
  }
};

TEST_F(Ignores, ThePageShowsWhatIsPrinted) {
  write_deck();
  const Ended run = gapcheck("audit --select GC1 --top 2 --fail-on warning model.k");
  EXPECT_EQ(run.code, 1) << "some penetrations are left";
  EXPECT_EQ("$ gapcheck audit --select GC1 --top 2 model.k\n" + run.out, example());
}

TEST_F(Ignores, DoNotCountForTheExitCode) {
  const std::string deck = content(project / "data/two_plates.k");
  file("all.k", "$ gapcheck: ignore GC1\n" + deck);
  const Ended run = gapcheck("audit --fail-on note --select GC1,GC5 all.k");
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_NE(run.out.find("18 ignored\n  all.k:1 (18)\n"), std::string::npos) << run.out;
  file("expired.k", "$ gapcheck: ignore GC1 until=2020-01-01\n" + deck);
  EXPECT_EQ(gapcheck("audit --fail-on warning expired.k").code, 1);
}

TEST_F(Ignores, FormatsWithoutAPlaceForThemSayHowMany) {
  write_deck();
  for (const std::string format : {"csv", "gitlab"}) {
    EXPECT_NE(gapcheck("audit --format " + format + " model.k").err.find("ignored, not in the " + format),
              std::string::npos);
    EXPECT_EQ(gapcheck("audit --quiet --format " + format + " model.k").err, "");
  }
  EXPECT_EQ(gapcheck("audit --format json model.k").err, "");
}

TEST_F(Ignores, TheSameForAnyNumberOfJobs) {
  write_deck();
  for (const std::string format : {"text", "sarif", "github", "csv"}) {
    const std::string one = gapcheck("audit --jobs 1 --format " + format + " model.k").out;
    EXPECT_NE(one.find("GC101"), std::string::npos) << one;
    EXPECT_EQ(one, gapcheck("audit --jobs 4 --format " + format + " model.k").out);
  }
}

}  // namespace
}  // namespace gapcheck::ignores_test
