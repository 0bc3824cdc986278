#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "keyword/card.hpp"

namespace gapcheck::keyword {

/// A deck given as text, with what reading it reported.
struct TextDeck {
  Diagnostics diagnostics;
  Deck deck;
  explicit TextDeck(const std::string& text) {
    auto result = read_deck_text(text, "deck.k", {}, diagnostics);
    EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
    if (result) deck = std::move(result).value();
  }
  [[nodiscard]] const Block& block(const std::string& name) const {
    for (const Block& block : deck.blocks())
      if (block.name == name) return block;
    ADD_FAILURE() << "no block " << name;
    static const Block missing;
    return missing;
  }
  [[nodiscard]] CardReader reader(const std::string& name) { return {deck, block(name), diagnostics}; }
};

/// A directory of its own that is removed at the end. While it lives the working directory is an empty one, since
/// includes are looked up there first.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "gapcheck-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
    std::filesystem::create_directory(path_ / "empty");
    std::filesystem::current_path(path_ / "empty");
  }
  ~TemporaryDirectory() {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(path_);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  std::string write(const std::string& name, const std::string& text) const {
    const auto file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file.string();
  }
  [[nodiscard]] std::string path(const std::string& name = "") const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_, before_ = std::filesystem::current_path();
};

inline std::vector<std::string> names(const Deck& deck) {
  std::vector<std::string> list;
  for (const Block& block : deck.blocks()) list.push_back(block.name);
  return list;
}

/// One definition of *PARAMETER in its 20 columns.
inline std::string pair(const std::string& name, const std::string& value) {
  return name + std::string(10 - name.size(), ' ') + std::string(10 - value.size(), ' ') + value;
}

/// "line: message" of every report, for searching.
inline std::string reports(const Diagnostics& diagnostics) {
  std::string all;
  for (const Diagnostic& diagnostic : diagnostics.sorted())
    all += diagnostic.file + ":" + std::to_string(diagnostic.line) + ": " + diagnostic.message + "\n";
  return all;
}

inline std::size_t count_errors(const Diagnostics& diagnostics) {
  std::size_t errors = 0;
  for (const Diagnostic& diagnostic : diagnostics.sorted()) errors += diagnostic.severity == Severity::error ? 1 : 0;
  return errors;
}

}  // namespace gapcheck::keyword
