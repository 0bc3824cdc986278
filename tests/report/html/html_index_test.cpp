#include "report/html/html_index.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "report/sample.hpp"

namespace gapcheck::report::html_index_test {
namespace {

bool has(const std::string& page, const std::string& part) { return page.find(part) != std::string::npos; }

TEST(HtmlIndex, ALineForEachDeckGravestFirst) {
  Report clean;
  clean.source = "deck";
  clean.input = "a.k";
  Report bad = sample_report();
  bad.page = "pages/plates.html";
  const std::vector<Report> decks{clean, bad};
  const std::vector<Unread> unread{{"lost.k", "cannot be opened"}};
  const std::string page = html_index({decks, unread}, "pages/index.html", "1.2.3");
  EXPECT_TRUE(has(page, "<h1>3 decks: 3 errors, 1 warning, 1 note; 1 not audited</h1>")) << page;
  const std::size_t lost = page.find("lost.k"), plates = page.find("plates.k"), a = page.find(">a.k<");
  EXPECT_LT(lost, plates);
  EXPECT_LT(plates, a);
  EXPECT_TRUE(has(page, "<td class=\"unread\">not audited</td><td></td><td></td><td></td><td>cannot be opened</td>"));
  EXPECT_TRUE(has(page,
                  "<td><a href=\"plates.html\">plates.k</a></td><td class=\"error\">errors</td>"
                  "<td class=\"number\">3</td><td class=\"number\">1</td><td class=\"number\">1</td>"
                  "<td><a href=\"plates.html#f"))
      << page;
  EXPECT_TRUE(has(page, "GC102 released-node: contact 7: node 14 ")) << page;
  EXPECT_TRUE(has(page, "<td>a.k</td><td class=\"clean\">nothing found</td><td class=\"number\">0</td>")) << page;
  EXPECT_EQ(page, html_index({decks, unread}, "pages/index.html", "1.2.3"));
}

TEST(HtmlIndex, ALineForEachRule) {
  std::vector<Report> decks(3);
  for (std::size_t i = 0; i < 2; ++i) decks[i].findings = {make_finding("GC501", "duplicate-id", "a")};
  const std::string row =
      "<tr><td>GC501 duplicate-id</td><td class=\"error\">error</td><td class=\"number\">2</td>"
      "<td class=\"number\">2</td>";
  EXPECT_TRUE(has(html_index({decks, {}}, "index.html", ""), row + "</tr>\n</table>"));
  decks[0].baseline.emplace().states = {BaselineState::unchanged};
  decks[1].baseline.emplace().states = {BaselineState::fresh};
  const std::string page = html_index({decks, {}}, "index.html", "");
  EXPECT_TRUE(has(page, "<th class=\"number\">new</th>")) << page;
  EXPECT_TRUE(has(page, row + "<td class=\"number\">1</td><td class=\"number\">0</td><td class=\"number\">1</td>"
                              "<td class=\"number\">0</td></tr>"))
      << page;
  EXPECT_FALSE(has(html_index(Report{}, "index.html", ""), "Rules")) << "nothing was found";
}

TEST(HtmlIndex, LinksLeadFromTheIndex) {
  Report report = sample_report();
  const auto link = [&](const std::string& index, const std::string& page) {
    report.page = page;
    const std::string text = html_index(report, index, "");
    const std::size_t at = text.find("<td><a href=\"") + 13;
    return text.substr(at, text.find('"', at) - at);
  };
  EXPECT_EQ(link("index.html", "out/a.html"), "out/a.html");
  EXPECT_EQ(link("out/index.html", "out/side/a.html"), "side/a.html");
  EXPECT_EQ(link("out/index.html", "other/a.html"), "../other/a.html");
  EXPECT_EQ(link("/x/index.html", "/x/y/../a.html"), "a.html");
  EXPECT_EQ(link("index.html", "a b#1?\"<ü%.html"), "a%20b%231%3F%22%3C%C3%BC%25.html");
  EXPECT_EQ(link("index.html", "javascript:x"), "javascript%3Ax");
}

TEST(HtmlIndex, TextOfDecksIsEscaped) {
  Report report = sample_report();
  report.input = "<script>alert(1)</script>\x1b.k";
  report.penetrations.clear(), report.tie_failures.clear();
  report.findings = {make_finding("GC501", "duplicate-id", "\"<img src=x onerror=y>\" & more")};
  const std::vector<Unread> unread{{"<b>", "<i>&"}};
  const std::string page = html_index({std::span(&report, 1), unread}, "i.html", "<v>");
  for (const char* markup : {"<script>", "<img", "<b>", "<i>", "<v>", "\x1b"}) EXPECT_FALSE(has(page, markup)) << page;
  EXPECT_TRUE(has(page, "&lt;script&gt;alert(1)&lt;/script&gt;?.k")) << page;
  EXPECT_TRUE(has(page, "&lt;img src=x onerror=y&gt;")) << page;
  EXPECT_TRUE(has(page, "default-src 'none'"));
}

TEST(HtmlIndex, LongMessagesAreCut) {
  Report report;
  report.findings = {make_finding("GC501", "duplicate-id", std::string(100000, 'x'))};
  EXPECT_LT(html_index(report, "i.html", "").size(), 5000u);
}

}  // namespace
}  // namespace gapcheck::report::html_index_test
