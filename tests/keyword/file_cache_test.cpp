#include "keyword/file_cache.hpp"

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

}  // namespace
}  // namespace gapcheck::keyword::file_cache_test
