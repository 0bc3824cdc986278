#include "keyword/file_cache.hpp"

#include <fmt/format.h>

#include "keyword/rows.hpp"
#include "support.hpp"

namespace gapcheck::keyword::file_cache_test {
namespace {

TEST(FileCache, DecksShareTheirIncludes) {
  TemporaryDirectory directory;
  directory.write("mesh.k", "*NODE\n1,0,0,0\n*END\n");
  directory.write("a.k", "*KEYWORD\n*INCLUDE\nmesh.k\n*PART\n");
  directory.write("b.k", "*KEYWORD\n*INCLUDE\n../" + std::filesystem::path(directory.path()).filename().string() +
                             "/mesh.k\n*TITLE\n");
  FileCache cache;
  ReadOptions options;
  options.cache = &cache;
  Diagnostics diagnostics;
  const auto a = read_deck(directory.path("a.k"), options, diagnostics);
  const auto b = read_deck(directory.path("b.k"), options, diagnostics);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a.value().counters().shared_files, 0u);
  EXPECT_EQ(b.value().counters().shared_files, 1u);
  EXPECT_EQ(cache.shared(), 1u);
  ASSERT_EQ(b.value().files().size(), 2u);
  EXPECT_EQ(a.value().files()[1].bytes.data(), b.value().files()[1].bytes.data());
  EXPECT_NE(a.value().files()[1].path, b.value().files()[1].path);
}

/// What is read with a cache is what is read without one.
TEST(FileCache, ChangesNothing) {
  TemporaryDirectory directory;
  directory.write("twice.k", "\xEF\xBB\xBF*NODE\n1,0,0,0\n*SET_NODE\n");
  directory.write("main.k", "*INCLUDE\ntwice.k\ntwice.k\n*PART\n");
  FileCache cache;
  ReadOptions with;
  with.cache = &cache;
  for (int time = 0; time < 2; ++time) {
    Diagnostics one, other;
    const auto cached = read_deck(directory.path("main.k"), with, one),
               plain = read_deck(directory.path("main.k"), {}, other);
    ASSERT_TRUE(cached.ok() && plain.ok());
    EXPECT_EQ(names(cached.value()), names(plain.value()));
    for (std::size_t i = 0; i < plain.value().blocks().size(); ++i) {
      EXPECT_EQ(cached.value().blocks()[i].body, plain.value().blocks()[i].body);
      EXPECT_EQ(cached.value().blocks()[i].line, plain.value().blocks()[i].line);
    }
    EXPECT_EQ(plain.value().counters().shared_files, 0u) << "the same file twice in one deck is nothing shared";
    EXPECT_EQ(cached.value().counters().shared_files, time == 0 ? 0u : 2u);
  }
}

TEST(FileCache, ADeckOutlivesIt) {
  TemporaryDirectory directory;
  directory.write("main.k", "*KEYWORD\n*NODE\n1,0,0,0\n");
  Diagnostics diagnostics;
  Deck deck;
  {
    FileCache cache;
    ReadOptions options;
    options.cache = &cache;
    deck = read_deck(directory.path("main.k"), options, diagnostics).value();
  }
  EXPECT_EQ(deck.blocks()[1].body, "1,0,0,0\n");
}

TEST(FileCache, WhatCannotBeOpenedIsTriedAgain) {
  TemporaryDirectory directory;
  FileCache cache;
  EXPECT_FALSE(cache.open(directory.path("later.k"), "").ok());
  directory.write("later.k", "*NODE\n");
  EXPECT_TRUE(cache.open(directory.path("later.k"), "").ok());
  EXPECT_EQ(cache.shared(), 0u);
}

TEST(FileCache, AFileThatHasChangedIsReadAndScannedAgain) {
  TemporaryDirectory directory;
  FileCache cache;
  ReadOptions options;
  options.cache = &cache;
  Diagnostics diagnostics;
  const std::string path = directory.write("main.k", "*KEYWORD\n*NODE\n1,0,0,0\n");
  EXPECT_EQ(read_deck(path, options, diagnostics).value().blocks().size(), 2u);
  directory.write("main.k", "*KEYWORD\n*PART\n*TITLE\n*NODE\n");
  const auto deck = read_deck(path, options, diagnostics);
  EXPECT_EQ(deck.value().blocks().size(), 4u);
  EXPECT_EQ(cache.shared(), 0u);
  EXPECT_TRUE(deck.value().unchanged().ok());
  directory.write("main.k", "*KEYWORD\n");
  EXPECT_FALSE(deck.value().unchanged().ok());
  EXPECT_EQ(deck.value().blocks()[1].name, "PART") << "the text is that of the reading";
}

TEST(FileCache, DroppedTextIsReadAgainForTheNextDeck) {
  TemporaryDirectory directory;
  std::string nodes;
  for (int i = 1; i <= 20000; ++i) nodes += std::to_string(i) + ",0,0,0\n";
  directory.write("mesh.k", "*NODE\n" + nodes + "*SET_NODE\n1\n2,3\n*NODE\n7,0,0,0\n");
  const std::string path = directory.write("main.k", "*KEYWORD\n*INCLUDE\nmesh.k\n*PART\na\n1\n");
  FileCache cache;
  ReadOptions options;
  options.cache = &cache;
  Diagnostics diagnostics;
  auto first = read_deck(path, options, diagnostics);
  ASSERT_TRUE(first.ok());
  Deck& deck = first.value();
  deck.drop_text([](std::string_view name) { return name == "NODE"; });
  ASSERT_EQ(deck.blocks().size(), 6u);
  EXPECT_EQ(deck.blocks()[2].name, "NODE");
  EXPECT_EQ(deck.blocks()[2].body, "");
  EXPECT_EQ(deck.blocks()[3].body, "1\n2,3\n");
  EXPECT_EQ(deck.blocks()[4].body, "7,0,0,0\n") << "too short to be worth it";
  EXPECT_EQ(deck.blocks()[5].body, "a\n1\n");
  EXPECT_EQ(deck.files()[1].bytes, "");
  const auto second = read_deck(path, options, diagnostics);
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(second.value().blocks()[2].body, nodes);
  EXPECT_EQ(second.value().counters().shared_files, 2u) << "they are not scanned again";
}

/// The rows of the block with this name, by a layout of three columns of ids.
Rows rows_of(const Deck& deck, std::string_view name, Diagnostics& diagnostics) {
  static const CardLayout layout{"ids",
                                 {{"id", 0, 10, FieldType::integer, IdKind::node},
                                  {"part", 10, 10, FieldType::integer, IdKind::part},
                                  {"x", 20, 10, FieldType::real, IdKind::plain}}};
  for (const Block& block : deck.blocks())
    if (block.name == name) return read_rows(deck, block, layout, diagnostics);
  return {};
}

/// A row of that layout.
std::string row(const std::string& id, const std::string& part, const std::string& x) {
  return fmt::format("{:>10}{:>10}{:>10}\n", id, part, x);
}

std::vector<std::string> messages(const Diagnostics& diagnostics) {
  std::vector<std::string> all;
  for (const Diagnostic& diagnostic : diagnostics.sorted()) all.push_back(diagnostic.message);
  return all;
}

/// Rows of *NODE of a deck read with a cache, which must be those of the deck read alone.
Rows read_with(FileCache& cache, const std::string& path) {
  ReadOptions options;
  options.cache = &cache;
  Diagnostics one, other;
  Rows rows = rows_of(read_deck(path, options, one).value(), "NODE", one);
  const Rows alone = rows_of(read_deck(path, {}, other).value(), "NODE", other);
  EXPECT_EQ(rows.integers, alone.integers);
  EXPECT_EQ(rows.reals, alone.reals);
  EXPECT_EQ(rows.lines, alone.lines);
  EXPECT_EQ(messages(one), messages(other));
  return rows;
}

TEST(FileCache, TablesOfASharedIncludeAreReadOnce) {
  TemporaryDirectory directory;
  std::string nodes;
  for (int i = 1; i <= 5000; ++i) nodes += row(std::to_string(i), "7", std::to_string(i) + ".5");
  directory.write("mesh.k", "*NODE\n" + nodes);
  const std::string a = directory.write("a.k", "*KEYWORD\n*INCLUDE\nmesh.k\n"),
                    b = directory.write("b.k", "*KEYWORD\n*TITLE\nb\n*INCLUDE\nmesh.k\n"),
                    shifted = directory.write(
                        "shifted.k", "*KEYWORD\n*INCLUDE_TRANSFORM\nmesh.k\n" + row("1000", "", "") + "\n\n\n");
  FileCache cache;
  cache.keep_included(1'000'000);
  EXPECT_EQ(read_with(cache, a).count, 5000u);
  EXPECT_EQ(cache.used_tables(), 0u);
  EXPECT_EQ(read_with(cache, b).integers[0], 1);
  EXPECT_EQ(cache.used_tables(), 1u);
  EXPECT_EQ(read_with(cache, shifted).integers[0], 1001) << "with other offsets it is another table";
  EXPECT_EQ(cache.used_tables(), 1u);
  read_with(cache, shifted);
  EXPECT_EQ(cache.used_tables(), 2u);
  directory.write("mesh.k", "*NODE\n" + row("9", "7", "1"));
  EXPECT_EQ(read_with(cache, a).count, 1u) << "a file that has changed is read again";
}

TEST(FileCache, WhatHangsOnTheDeckIsReadForEachDeck) {
  TemporaryDirectory directory;
  directory.write("mesh.k", "*NODE\n" + row("1", "7", "&height"));
  directory.write("faulty.k", "*NODE\n" + row("1", "7", "1.2.3"));
  FileCache cache;
  cache.keep_included(1'000'000);
  for (const char* const height : {"1", "2"}) {
    const std::string text = fmt::format("*KEYWORD\n*PARAMETER\nR height  {:>10}\n*INCLUDE\nmesh.k\n", height);
    EXPECT_EQ(read_with(cache, directory.write(fmt::format("{}.k", height), text)).reals[0], height[0] - '0');
  }
  const std::string main = directory.write("main.k", "*KEYWORD\n*INCLUDE\nfaulty.k\n");
  for (int time = 0; time < 2; ++time) {
    read_with(cache, main);
    ReadOptions options;
    options.cache = &cache;
    Diagnostics diagnostics;
    rows_of(read_deck(main, options, diagnostics).value(), "NODE", diagnostics);
    EXPECT_TRUE(diagnostics.has_errors());
  }
  EXPECT_EQ(cache.used_tables(), 0u);
}

TEST(FileCache, NoMoreIsKeptThanIsAllowed) {
  TemporaryDirectory directory;
  std::string nodes;
  for (int i = 1; i <= 1000; ++i) nodes += row(std::to_string(i), "7", "0.5");
  directory.write("mesh.k", "*NODE\n" + nodes);
  const std::string main = directory.write("main.k", "*KEYWORD\n*INCLUDE\nmesh.k\n");
  for (const std::uint64_t bytes : {std::uint64_t{0}, std::uint64_t{1000}, std::uint64_t{nodes.size() + 1000}}) {
    FileCache cache;
    cache.keep_included(bytes);
    for (int time = 0; time < 3; ++time) EXPECT_EQ(read_with(cache, main).count, 1000u);
    EXPECT_EQ(cache.used_tables(), 0u) << bytes;
  }
}

}  // namespace
}  // namespace gapcheck::keyword::file_cache_test
