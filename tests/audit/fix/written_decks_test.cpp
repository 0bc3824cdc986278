// Random scenes whose nodes are written in all the ways that a deck knows: what a correction writes reads back as it
// was predicted, and everything that the report does not list is the same byte for byte.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "audit/fix/run_fix.hpp"
#include "audit/random_scene.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::written_decks_test {
namespace {

namespace fs = std::filesystem;

/// Of random scenes; in the fourth, bodies are so deep in each other that nothing moves, which takes seconds to find
/// out.
constexpr std::array<std::uint64_t, 5> seeds{1, 2, 3, 5, 6};

/// How the nodes stand in a file.
struct Form {
  std::string name, suffix;      ///< suffix: of *NODE
  int id_width = 8, width = 16;  ///< 0: free format
  bool carriage_return = false, last_newline = true, comments = false, parameters = false, twice = false;
  std::string codes;  ///< behind the coordinates
};

const std::vector<Form>& forms() {
  static const std::vector<Form> list{
      {"standard", "", 8, 16, false, true, false, false, false, ""},
      {"i10", "%", 10, 16, false, true, true, false, false, ""},
      {"long", "+", 20, 20, false, true, false, false, false, ""},
      {"free", "", 0, 0, false, true, true, false, false, ""},
      {"carriage returns", "", 8, 16, true, true, true, false, false, "       0       0"},
      {"no newline at the end", "", 8, 16, false, false, false, false, false, ""},
      {"free, carriage returns, no newline", "", 0, 0, true, false, false, false, false, ", 0,0"},
      {"parameters", "", 0, 0, false, true, false, true, false, ""},
      {"defined twice", "", 8, 16, false, true, false, false, true, ""}};
  return list;
}

/// Where an include puts its coordinates.
enum class Placement { plain, moved, turned, scaled };
constexpr std::array placements{Placement::plain, Placement::moved, Placement::turned, Placement::scaled};

Vector in_file(Placement placement, const Vector& x) {
  const double angle = std::numbers::pi / 6;
  switch (placement) {
    case Placement::moved:
      return x - Vector(100, -50, 8);
    case Placement::turned:
      return {std::cos(angle) * x.x() + std::sin(angle) * x.y(), std::cos(angle) * x.y() - std::sin(angle) * x.x(),
              x.z()};
    case Placement::scaled:
      return x / 1000;
    default:
      return x;
  }
}

std::string include_card(Placement placement, const std::string& file) {
  if (placement == Placement::plain) return "*INCLUDE\n" + file + "\n";
  const std::string rest = fmt::format("\n\n{:>10}{:>10}{:>10}{:>10}{:>10}\n",
                                       placement == Placement::scaled ? "1000." : "1.", "1.", "1.", "", 1);
  const int transformation = placement == Placement::moved ? 7 : placement == Placement::turned ? 8 : 0;
  return "*INCLUDE_TRANSFORM\n" + file + "\n" + rest +
         (transformation > 0 ? fmt::format("{:10}\n", transformation) : "\n");
}

const std::string transformations =
    "*DEFINE_TRANSFORMATION\n         7\nTRANSL          100.      -50.        8.\n"
    "*DEFINE_TRANSFORMATION\n         8\nROTATE            0.        0.        1.        0.        0.        0.       "
    "30.\n";

std::string node_line(const Form& form, const Scene::Node& node, const Vector& x) {
  if (form.width == 0) {
    if (form.parameters && node.id % 3 == 0) return fmt::format("{},&x{},{},{}", node.id, node.id, x.y(), x.z());
    return fmt::format("{},{}, {} ,{}{}", node.id, x.x(), x.y(), x.z(), form.codes);
  }
  std::string line = fmt::format("{:{}}", node.id, form.id_width);
  for (int i = 0; i < 3; ++i) line += fmt::format("{:{}.9g}", x[i], form.width);
  return line + form.codes;
}

std::string node_file(const Form& form, Placement placement, const std::vector<Scene::Node>& nodes) {
  std::string text = "*KEYWORD\n";
  if (form.parameters)
    for (const Scene::Node& node : nodes)
      if (node.id % 3 == 0) text += fmt::format("*PARAMETER\nRx{},{}\n", node.id, in_file(placement, node.x).x());
  text += "*NODE" + form.suffix + "\n";
  for (const Scene::Node& node : nodes) {
    if (form.comments && node.id % 4 == 0) text += "$ 1234567         1.              2.              3.\n";
    text += node_line(form, node, in_file(placement, node.x)) + "\n";
  }
  if (form.twice) text += node_line(form, nodes.front(), in_file(placement, nodes.front().x)) + "\n";
  if (!form.last_newline) text.pop_back();
  if (!form.carriage_return) return text;
  std::string with;
  for (const char c : text) with += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return with;
}

std::string read_bytes(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

std::vector<std::string> lines_of(const std::string& bytes) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at <= bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    lines.push_back(bytes.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

class WrittenDecks : public testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "gapcheck-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    fs::create_directory(folder_ / "before");
    fs::create_directory(folder_ / "after");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) {
    for (const char* side : {"before", "after"}) std::ofstream(folder_ / side / name, std::ios::binary) << text;
    names_.insert(name);
  }

  /// The scene with its nodes in one include for each placement; returns the main file.
  fs::path write_scene(const Scene& scene, const Form& form) {
    std::map<Placement, std::vector<Scene::Node>> by_placement;
    for (const Scene::Node& node : scene.nodes)
      by_placement[placements[static_cast<std::size_t>(node.id) % placements.size()]].push_back(node);
    Scene rest = scene;
    rest.nodes.clear();
    std::string text = rest.text(), includes = transformations;
    for (const auto& [placement, nodes] : by_placement) {
      const std::string name = fmt::format("nodes{}.k", static_cast<int>(placement));
      write(name, node_file(form, placement, nodes));
      includes += include_card(placement, name);
    }
    text.insert(text.find("*NODE\n"), includes);
    write("main.k", text);
    return folder_ / "before" / "main.k";
  }

  fs::path folder_;
  std::set<std::string> names_;
};

TEST_P(WrittenDecks, ReadBackAsPredicted) {
  const Form& form = forms()[GetParam()];
  std::uint64_t moved = 0, before = 0, after = 0;
  for (const std::uint64_t seed : seeds) {
    const std::string where = fmt::format("{}, seed {}", form.name, seed);
    const fs::path main = write_scene(random_scene(seed), form);
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck(main.string(), {}, diagnostics);
    ASSERT_TRUE(deck.ok()) << where;
    auto fix = audit::fix_penetrations(deck.value(), {}, diagnostics);
    ASSERT_TRUE(fix.ok()) << where << fix.error().message;
    ASSERT_FALSE(diagnostics.has_errors()) << where << ": " << diagnostics.sorted()[0].message;
    const FixReport& report = fix.value().report;
    for (const audit::Fix::File& file : fix.value().files) {
      const std::string_view bytes = deck.value().file(file.file).bytes;
      std::ofstream(folder_ / "after" / fs::path(deck.value().file(file.file).path).filename(), std::ios::binary)
          << keyword::with_lines(bytes, keyword::LineIndex(bytes), file.edits);
    }
    // Only the lines that the report lists differ.
    std::map<std::string, std::set<std::size_t>> listed;
    for (const MovedNode& m : report.moved) listed[fs::path(report.files[m.file]).filename()].insert(m.line - 1);
    for (const std::string& name : names_) {
      const auto old = lines_of(read_bytes(folder_ / "before" / name)),
                 now = lines_of(read_bytes(folder_ / "after" / name));
      ASSERT_EQ(old.size(), now.size()) << where;
      for (std::size_t i = 0; i < old.size(); ++i) {
        EXPECT_EQ(old[i] != now[i], listed[name].contains(i)) << where << " " << name << ":" << i + 1;
        EXPECT_EQ(old[i].ends_with('\r'), now[i].ends_with('\r')) << where;
        EXPECT_EQ(old[i].substr(0, static_cast<std::size_t>(form.id_width)),
                  now[i].substr(0, static_cast<std::size_t>(form.id_width)));
        if (!form.codes.empty() && listed[name].contains(i)) {
          EXPECT_NE(now[i].find(form.codes), std::string::npos) << where;
        }
      }
    }
    // An audit of what was written finds what was predicted.
    audit::AuditOptions options;
    options.select = {"GC101", "GC102"};
    const AuditRun audit = run_file((folder_ / "after/main.k").string(), options);
    ASSERT_TRUE(audit.ok) << where << describe(audit.diagnostics);
    ASSERT_EQ(audit.report.contacts.size(), report.contacts.size());
    for (std::size_t c = 0; c < report.contacts.size(); ++c) {
      before += report.contacts[c].before.penetrations + report.contacts[c].before.released;
      after += report.contacts[c].after.penetrations + report.contacts[c].after.released;
    }
    const FixRun again = fix_file((folder_ / "after/main.k").string());
    for (std::size_t c = 0; c < report.contacts.size(); ++c) {
      EXPECT_EQ(again.report().contacts[c].before.penetrations, report.contacts[c].after.penetrations) << where;
      EXPECT_EQ(again.report().contacts[c].before.released, report.contacts[c].after.released) << where;
    }
    if (report.unfixed.empty()) {
      EXPECT_TRUE(audit.report.penetrations.empty()) << where;
    }
    Diagnostics reading;
    const auto written = keyword::read_deck((folder_ / "after/main.k").string(), {}, reading);
    const auto model = model::read_model(written.value(), reading);
    for (const MovedNode& m : report.moved) {
      const auto node = model.value().mesh.nodes.lookup.find(m.node);
      ASSERT_TRUE(node.has_value());
      EXPECT_EQ(model.value().mesh.nodes.x[*node], m.to) << where << ", node " << m.node;
      EXPECT_FALSE(form.parameters && m.node % 3 == 0) << where;
    }
    moved += report.moved.size();
  }
  EXPECT_GT(moved, 10u) << form.name;
  EXPECT_LT(after, before) << form.name;
}

INSTANTIATE_TEST_SUITE_P(Forms, WrittenDecks, testing::Range<std::size_t>(0, forms().size()),
                         [](const auto& form) { return fmt::format("form{}", form.param); });

// Far from the origin a field of 16 columns holds few decimals: what is written must be free all the same.
TEST(WrittenDecksFarAway, FewDecimalsAreEnough) {
  for (const double offset : {1e6, 1e9, 1e12}) {
    Scene scene;
    scene.parts = {{1, false, 1.0}, {2, false, 1.0}};
    for (int p = 0; p < 2; ++p) {
      for (int j = 0; j <= 2; ++j)
        for (int i = 0; i <= 2; ++i)
          scene.nodes.push_back({100 * (p + 1) + 3 * j + i, Vector(5.0 * i, 5.0 * j, offset + 0.5 * p)});
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
          const std::int64_t a = 100 * (p + 1) + 3 * j + i;
          scene.elements.push_back({10 * (p + 1) + 2 * j + i, p + 1, {a, a + 1, a + 4, a + 3}});
        }
    }
    scene.contacts = {{1, "AUTOMATIC_SINGLE_SURFACE"}};
    std::string text = scene.text();
    for (const Scene::Node& node : scene.nodes) {
      const std::string free = fmt::format("{},{},{},{}\n", node.id, node.x.x(), node.x.y(), node.x.z());
      const std::size_t at = text.find("\n" + free) + 1;
      ASSERT_NE(at, 0u);
      text.replace(at, free.size(),
                   fmt::format("{:8}{:16}{:16}{:16.1f}\n", node.id, node.x.x(), node.x.y(), node.x.z()));
    }
    const FixRun run = fix_text(text);
    EXPECT_FALSE(run.report().moved.empty()) << offset;
    EXPECT_TRUE(complete(run.report())) << offset;
    EXPECT_EQ(fix_text(run.text).report().contacts[0].before.penetrations, 0u) << offset;
  }
}

}  // namespace
}  // namespace gapcheck::audit_test::written_decks_test
