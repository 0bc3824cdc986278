// The page of --html: as a file, and in Chromium where it is installed.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <string>

#include "program.hpp"

namespace gapcheck::html_test {
namespace {

class Html : public Program {
 protected:
  /// Holds a page against what it promises.
  void expect_good(const std::string& page) const {
    const Ended run = shell("python3 -B '" + (project / "tests/apps/html_chromium.py").string() + "' " + page);
    if (run.code == 77) GTEST_SKIP() << "Chromium is not installed";
    EXPECT_EQ(run.code, 0) << run.out << run.err;
  }
  [[nodiscard]] std::string deck(const std::string& name) const {
    return "'" + (project / "data" / name).string() + "'";
  }
};

TEST_F(Html, IsWrittenBesideTheResults) {
  const Ended plain = gapcheck("audit --format csv " + deck("two_plates.k"));
  const Ended with_page = gapcheck("audit --format csv --html page.html " + deck("two_plates.k"));
  EXPECT_EQ(with_page.out, plain.out);
  EXPECT_EQ(with_page.code, plain.code);
  const std::string page = content(folder_ / "page.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_NE(page.find("\"model_faces\":"), std::string::npos) << "the mesh is not in it";
  EXPECT_LT(page.size(), 1'500'000u);
}

TEST_F(Html, IsTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(gapcheck("audit --quiet --jobs 1 --html one.html " + deck("two_plates_tilted.k")).err, "");
  EXPECT_EQ(gapcheck("audit --quiet --jobs 4 --html four.html " + deck("two_plates_tilted.k")).err, "");
  EXPECT_EQ(content(folder_ / "one.html"), content(folder_ / "four.html"));
}

TEST_F(Html, AFileThatCannotBeWrittenIsAnError) {
  const Ended run = gapcheck("audit --html no/such/folder.html " + deck("clean.k"));
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("no/such/folder.html"), std::string::npos) << run.err;
}

TEST_F(Html, ADeckInChromium) {
  ASSERT_EQ(gapcheck("audit --html page.html " + deck("two_plates_tilted.k")).code, 0);
  expect_good("page.html");
}

TEST_F(Html, ABaselineAndIgnoresInChromium) {
  const std::string text = content(project / "data/two_plates.k");
  file("deck.k", text);
  ASSERT_EQ(gapcheck("audit --quiet --write-baseline known deck.k").code, 0);
  const std::string deeper = std::regex_replace(text, std::regex("             0\\.7\n"), "             0.6\n");
  file("deck.k", "$ gapcheck: ignore GC101 node=1000-1999 because <b>it</b> is\n" + deeper);
  ASSERT_EQ(gapcheck("audit --baseline known --html page.html deck.k").code, 0);
  expect_good("page.html");
}

TEST_F(Html, ACleanDeckInChromium) {
  ASSERT_EQ(gapcheck("audit --html page.html " + deck("clean.k")).code, 0);
  expect_good("page.html");
}

TEST_F(Html, ALogInChromium) {
  use("smp");
  const Ended run = gapcheck("messag --html page.html messag");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(content(folder_ / "page.html").find("\"model_faces\":"), std::string::npos);
  expect_good("page.html");
}

TEST_F(Html, TheMeshOfALogComesFromItsDeck) {
  use("smp");
  const Ended run = gapcheck("messag --html page.html messag --deck " + deck("two_plates.k"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(content(folder_ / "page.html").find("\"model_faces\":"), std::string::npos);
}

TEST_F(Html, AHostileDeckInChromium) {
  std::string text = content(project / "data/two_plates.k");
  const std::string title = "lower plate";
  ASSERT_NE(text.find(title), std::string::npos);
  text.replace(text.find(title), title.size(), "</script><script>injected = 1</script><img src=x onerror=injected=1>");
  file("<img src=x onerror='injected=1'>.k", text);
  ASSERT_EQ(gapcheck("audit --html page.html \"./<img src=x onerror='injected=1'>.k\"").code, 0);
  ASSERT_NE(content(folder_ / "page.html"), "");
  expect_good("page.html");
}

}  // namespace
}  // namespace gapcheck::html_test
