// The page of --html: as a file, and in Chromium where it is installed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
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
  /// Two wavy plates of n by n shells that penetrate each other here and there.
  void write_plates(const std::string& name, int n) const {
    std::ofstream out(folder_ / name);
    out << "*KEYWORD\n";
    for (int p = 1; p <= 2; ++p)
      out << fmt::format("*PART\nplate\n{:10}{:10}{:10}\n*SECTION_SHELL\n{:10}{:10}\n", p, p, 1, p, 2)
          << "        1.        1.        1.        1.\n";
    out << "*MAT_ELASTIC\n         1  7.85e-09   210000.       0.3\n*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         "
           "1all\n"
           "         0         0         5         0\n        0.\n        1.        1.\n*NODE\n";
    for (int p = 0, id = 1; p < 2; ++p)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i, ++id)
          out << fmt::format("{:8}{:16}{:16}{:16.6f}\n", id, 5. * i + 1.5 * p, 5. * j + 2 * p,
                             p * (0.9 + 0.25 * std::sin(0.1 * i) * std::cos(0.1 * j)));
    out << "*ELEMENT_SHELL\n";
    for (int p = 0, id = 1; p < 2; ++p)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i, ++id) {
          const int a = 1 + (p * (n + 1) + j) * (n + 1) + i;
          out << fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", id, p + 1, a, a + 1, a + n + 2, a + n + 1);
        }
    out << "*END\n";
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

// Each line of the report, and each annotation, names its finding by the position that it has in the JSON.
TEST_F(Html, LinesAndAnnotationsPointToTheirFindings) {
  const std::string file = deck("tied_then_contact.k");
  const auto findings = nlohmann::json::parse(gapcheck("audit --format json " + file).out)["findings"];
  for (const char* format : {"text", "github"}) {
    const std::string command = std::string("audit --fail-on never --format ") + format + " " + file;
    EXPECT_EQ(gapcheck(command).out.find("#f"), std::string::npos);
    const std::string out = gapcheck(command + " --html page.html").out;
    std::size_t links = 0;
    const std::regex line("(GC[0-9]+) [^\\n]*node ([0-9]+)[^\\n]*page[.]html#f([0-9]+)");
    for (std::sregex_iterator match(out.begin(), out.end(), line), end; match != end; ++match, ++links) {
      const std::size_t number = std::stoul((*match)[3]);
      ASSERT_TRUE(number >= 1 && number <= findings.size()) << match->str();
      EXPECT_EQ(findings[number - 1]["id"], (*match)[1].str()) << match->str();
      EXPECT_EQ(findings[number - 1]["node"], std::stoll((*match)[2])) << match->str();
    }
    EXPECT_GE(links, 2U) << out;
  }
}

TEST_F(Html, IsTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(gapcheck("audit --quiet --jobs 1 --html one.html " + deck("two_plates_tilted.k")).err, "");
  EXPECT_EQ(gapcheck("audit --quiet --jobs 4 --html four.html " + deck("two_plates_tilted.k")).err, "");
  EXPECT_NE(content(folder_ / "one.html"), "");
  EXPECT_EQ(content(folder_ / "one.html"), content(folder_ / "four.html"));
}

TEST_F(Html, AFileThatCannotBeWrittenIsAnError) {
  const Ended run = gapcheck("audit --html no/such/folder.html " + deck("clean.k"));
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("no/such/folder.html"), std::string::npos) << run.err;
}

TEST_F(Html, ADeckInChromium) {
  ASSERT_EQ(gapcheck("audit --html page.html " + deck("two_plates_tilted.k")).code, 0);
  expect_good("page.html --whole");
}

TEST_F(Html, BeforeAndAfterInChromium) {
  ASSERT_EQ(gapcheck("fix --dry-run --html page.html " + deck("two_plates.k")).code, 0);
  EXPECT_NE(content(folder_ / "page.html").find("18 nodes penetrating before, 0 after; 32 nodes moved"),
            std::string::npos);
  expect_good("page.html");
  ASSERT_EQ(gapcheck("start --html start.html " + deck("ignore_0.k")).code, 1);
  EXPECT_NE(content(folder_ / "start.html").find("nodes are moved before the first cycle, by at most 0.3006"),
            std::string::npos);
  expect_good("start.html");
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
  expect_good("page.html --whole");
}

TEST_F(Html, TheMeshOfALogComesFromItsDeck) {
  use("smp");
  const Ended run = gapcheck("messag --html page.html messag --deck " + deck("two_plates.k"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(content(folder_ / "page.html").find("\"model_faces\":"), std::string::npos);
}

TEST_F(Html, ALargeDeckInChromium) {
  write_plates("plates.k", 145);
  ASSERT_EQ(gapcheck("audit --quiet --fail-on never --html page.html plates.k").code, 0);
  EXPECT_LT(content(folder_ / "page.html").size(), 9'000'000u);
  expect_good("page.html --large");
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
