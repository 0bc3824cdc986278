// Decks by other authors, counted once more by a plain walk over their lines.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "read.hpp"

namespace gapcheck::model::real_decks_test {
namespace {

namespace fs = std::filesystem;

struct Counts {
  std::size_t nodes = 0, shells = 0, solids = 0, beams = 0, particles = 0, parts = 0, contacts = 0;
  bool operator==(const Counts&) const = default;
};

void PrintTo(const Counts& c, std::ostream* out) {
  *out << c.nodes << " nodes, " << c.shells << " shells, " << c.solids << " solids, " << c.beams << " beams, "
       << c.particles << " particles, " << c.parts << " parts, " << c.contacts << " contacts";
}

/// One keyword with its data lines, blank ones included.
struct PlainBlock {
  std::string name;
  std::vector<std::string> lines;
};

std::vector<PlainBlock> plain_blocks(const std::vector<fs::path>& files) {
  std::vector<PlainBlock> blocks;
  for (const fs::path& path : files) {
    std::ifstream stream(path);
    for (std::string line; std::getline(stream, line);) {
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
      if (line.starts_with('$')) continue;
      if (line.starts_with('*')) {
        std::transform(line.begin(), line.end(), line.begin(), [](unsigned char c) { return std::toupper(c); });
        const std::string name = line.substr(1, line.find_first_of(" \t") - 1);
        if (name == "END") break;
        blocks.push_back({name, {}});
      } else if (!blocks.empty()) {
        blocks.back().lines.push_back(line);
      }
    }
  }
  return blocks;
}

Counts plain_count(const std::vector<fs::path>& files) {
  Counts counts;
  for (const PlainBlock& block : plain_blocks(files)) {
    const auto rows = static_cast<std::size_t>(
        std::count_if(block.lines.begin(), block.lines.end(), [](const std::string& line) { return !line.empty(); }));
    if (block.name == "NODE") counts.nodes += rows;
    if (block.name == "ELEMENT_SHELL") counts.shells += rows;
    if (block.name == "ELEMENT_SHELL_THICKNESS") counts.shells += rows / 2;
    if (block.name == "ELEMENT_SHELL_OFFSET_COMPOSITE") counts.shells += 1;
    if (block.name == "ELEMENT_SOLID" && rows > 0) {
      const bool two_lines = block.lines.front().find(',') == std::string::npos && block.lines.front().size() <= 16;
      counts.solids += two_lines ? rows / 2 : rows;
    }
    if (block.name == "ELEMENT_BEAM") counts.beams += rows;
    if (block.name == "ELEMENT_SPH") counts.particles += rows;
    if (block.name == "PART") counts.parts += block.lines.size() / 2;
    if (block.name.starts_with("PART_INERTIA") || block.name == "PART_CONTACT") ++counts.parts;
    if (block.name.starts_with("CONTACT_")) ++counts.contacts;
  }
  return counts;
}

Counts counts_of(const Model& model) {
  return {model.mesh.nodes.size(),     model.mesh.shells.size(), model.mesh.solids.size(), model.mesh.beams.size(),
          model.mesh.particles.size(), model.parts.size(),       model.contacts.size()};
}

class RealDecks : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(decks)) GTEST_SKIP() << "the real decks are not beside the project: " << decks;
  }
  const fs::path decks = fs::path(GAPCHECK_ROOT) / ".." / "shared" / "decks";

  /// Reads the first file and compares with a plain count over all of them.
  Read compare(const std::vector<std::string>& names) {
    std::vector<fs::path> files;
    for (const std::string& name : names) files.push_back(decks / name);
    Diagnostics diagnostics;
    keyword::ReadOptions options;
    options.skip_missing_includes = true;
    auto deck = keyword::read_deck(files.front().string(), options, diagnostics);
    EXPECT_TRUE(deck.ok()) << names.front();
    if (!deck.ok()) return {};
    auto model = read_model(deck.value(), diagnostics);
    Read read{std::move(model).value(), diagnostics.sorted()};
    EXPECT_EQ(counts_of(read.model), plain_count(files)) << names.front() << "\n" << read.text();
    return read;
  }
};

TEST_F(RealDecks, WholeDecksAreReadWithoutErrorsOrFaults) {
  const std::vector<std::vector<std::string>> cases = {
      {"ball_plate/ball_plate.k"},
      {"bird_on_panel/bird.k"},
      {"bird_strike_composite/input.k"},
      {"birdball_eroding/birdball.k"},
      {"car6/car6_crash.k"},
      {"car6_refined/lsopt_car6/car6_crash_v2.k"},
      {"two_body_impact/main.k"},
      {"car6_refined/lsopt_car6/main_v222.k", "car6_refined/lsopt_car6/car6_crash_v222.k"},
      {"tied_plate_with_run/main.k", "tied_plate_with_run/geometry.k", "tied_plate_with_run/boundary.k",
       "tied_plate_with_run/MAT_CWM355.k"},
  };
  for (const auto& files : cases) {
    const Read read = compare(files);
    EXPECT_EQ(read.errors(), 0u) << files.front() << "\n" << read.text();
    EXPECT_TRUE(read.model.faults.empty()) << files.front() << "\n" << read.text();
    EXPECT_GT(read.model.contacts.size(), 0u) << files.front();
  }
}

TEST_F(RealDecks, DecksWithHolesSayWhatIsMissing) {
  const Read forming = compare({"roll_forming/model.k"});
  EXPECT_EQ(forming.model.mesh.shells.size(), 3562u);
  EXPECT_NE(forming.text().find("contact 1: part 1 of SURFA is not defined"), std::string::npos);
  const Read car5 = compare({"car5/car5.k"});
  EXPECT_NE(car5.text().find("tbumper"), std::string::npos);
  const Read body = compare({"body_contacts_no_mesh/model/common/vivaplus-constraineds-contacts.k"});
  EXPECT_EQ(body.model.contacts.size(), 53u);
  for (const Contact& contact : body.model.contacts) EXPECT_TRUE(contact.known) << contact.written;
  EXPECT_EQ(body.errors(), 0u) << body.text();
}

TEST_F(RealDecks, ContactsOfTheTemplatesAreKnown) {
  std::size_t contacts = 0, expected = 0;
  for (const auto& entry : fs::directory_iterator(decks / "keyword_templates" / "keywords" / "c")) {
    Diagnostics diagnostics;
    auto deck = keyword::read_deck(entry.path().string(), {}, diagnostics);
    ASSERT_TRUE(deck.ok()) << entry.path();
    const auto model = read_model(deck.value(), diagnostics);
    for (const Contact& contact : model.value().contacts) {
      EXPECT_TRUE(contact.known) << contact.written;
      ++contacts;
    }
    for (const PlainBlock& block : plain_blocks({entry.path()})) expected += block.name.starts_with("CONTACT_") ? 1 : 0;
  }
  EXPECT_EQ(contacts, expected);
  EXPECT_GT(contacts, 10u);
}

TEST_F(RealDecks, EveryFileIsStood) {
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(decks)) {
    const std::string extension = entry.path().extension().string();
    if (!entry.is_regular_file() ||
        (extension != ".k" && extension != ".key" && extension != ".dyn" && extension != ".txt"))
      continue;
    Diagnostics diagnostics;
    keyword::ReadOptions options;
    options.skip_missing_includes = true;
    auto deck = keyword::read_deck(entry.path().string(), options, diagnostics);
    if (!deck) continue;
    EXPECT_TRUE(read_model(deck.value(), diagnostics).ok()) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 100u);
}

}  // namespace
}  // namespace gapcheck::model::real_decks_test
