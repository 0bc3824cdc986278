// Every deck at hand: the blocks must be those that a plain line scan finds.
#include <fstream>
#include <map>

#include "keyword/rows.hpp"
#include "support.hpp"

namespace gapcheck::keyword::real_decks_test {
namespace {

namespace fs = std::filesystem;

bool looks_like_a_deck(const fs::path& path) {
  const auto extension = path.extension();
  return extension == ".k" || extension == ".key" || extension == ".dyn" || extension == ".asc" || extension == ".txt";
}

std::vector<fs::path> decks() {
  std::vector<fs::path> list;
  const fs::path root = fs::path(GAPCHECK_ROOT) / "../shared/decks";
  std::error_code error;
  for (fs::recursive_directory_iterator it(root, error), end; it != end; it.increment(error))
    if (it->is_regular_file() && looks_like_a_deck(it->path()) && it->file_size() > 0) list.push_back(it->path());
  std::sort(list.begin(), list.end());
  return list;
}

/// Keyword names of one file with their lines, by the plainest means.
std::vector<std::pair<std::string, std::uint32_t>> keywords_of(const fs::path& path) {
  std::vector<std::pair<std::string, std::uint32_t>> found;
  std::ifstream file(path, std::ios::binary);
  std::uint32_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line[0] != '*') continue;
    std::string name;
    for (std::size_t i = 1; i < line.size() && line[i] != ' ' && line[i] != '\t' && line[i] != '\r'; ++i)
      name += static_cast<char>(std::toupper(static_cast<unsigned char>(line[i])));
    if (!name.empty() && std::string("+-%").find(name.back()) != std::string::npos) name.pop_back();
    found.emplace_back(name, number);
    if (name == "END") break;
  }
  return found;
}

TEST(RealDecks, BlocksAreThoseOfALineScan) {
  const auto list = decks();
  if (list.empty()) GTEST_SKIP() << "no decks in ../shared/decks beside the project";
  const TemporaryDirectory elsewhere;
  std::size_t blocks = 0;
  for (const fs::path& path : list) {
    Diagnostics diagnostics;
    ReadOptions options;
    options.skip_missing_includes = true;
    const auto result = read_deck(path.string(), options, diagnostics);
    ASSERT_TRUE(result.ok()) << path << ": " << result.error().message;
    const Deck& deck = result.value();
    std::map<std::uint32_t, std::vector<std::pair<std::string, std::uint32_t>>> by_file;
    for (const Block& block : deck.blocks()) by_file[block.file.value].emplace_back(block.name, block.line);
    for (std::size_t i = 0; i < deck.files().size(); ++i)
      EXPECT_EQ(by_file[static_cast<std::uint32_t>(i)], keywords_of(deck.files()[i].path)) << deck.files()[i].path;
    blocks += deck.blocks().size();
  }
  EXPECT_GT(blocks, 5000u);
}

TEST(RealDecks, NodesAndShellsReadWithoutReports) {
  const auto list = decks();
  if (list.empty()) GTEST_SKIP() << "no decks in ../shared/decks beside the project";
  const TemporaryDirectory elsewhere;
  std::size_t rows = 0;
  for (const fs::path& path : list) {
    // Templates hold question marks in place of numbers, others have mistakes on purpose.
    if (path.string().find("templates") != std::string::npos) continue;
    if (path.string().find("error_location") != std::string::npos) continue;
    Diagnostics reading, diagnostics;
    ReadOptions options;
    options.skip_missing_includes = true;
    const auto deck = read_deck(path.string(), options, reading);
    ASSERT_TRUE(deck.ok());
    for (const Block& block : deck.value().blocks())
      if (block.name == "NODE" || block.name == "ELEMENT_SHELL" || block.name == "ELEMENT_BEAM")
        rows += read_rows(deck.value(), block, card_layout(block.name, "card1"), diagnostics).count;
    EXPECT_EQ(reports(diagnostics), "") << path;
  }
  EXPECT_GT(rows, 100000u);
}

}  // namespace
}  // namespace gapcheck::keyword::real_decks_test
