#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "audit/fix/fix.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::audit_test {

/// A correction with the deck that it makes of its main file.
struct FixRun {
  audit::Fix fix;
  std::string text;  ///< the main file afterwards
  std::size_t errors = 0;
  [[nodiscard]] const FixReport& report() const { return fix.report; }
  [[nodiscard]] const MovedNode* moved(std::int64_t node) const {
    for (const MovedNode& m : fix.report.moved)
      if (m.node == node) return &m;
    return nullptr;
  }
  [[nodiscard]] Vector move(std::int64_t node) const {
    const MovedNode* m = moved(node);
    return m == nullptr ? Vector(Vector::Zero()) : Vector(m->to - m->from);
  }
};

/// The model of a deck that has to be readable.
inline model::Model model_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok());
  return std::move(model).value();
}

/// Corrects a deck that has been read.
inline FixRun run_fix(const Result<keyword::Deck>& deck, const audit::FixOptions& options = {}) {
  FixRun run;
  EXPECT_TRUE(deck.ok());
  if (!deck) return run;
  Diagnostics diagnostics;
  auto fix = audit::fix_penetrations(deck.value(), options, diagnostics);
  EXPECT_TRUE(fix.ok());
  run.errors = diagnostics.has_errors() ? 1 : 0;
  const std::string_view bytes = deck.value().file(FileIndex{0}).bytes;
  run.text = bytes;
  if (!fix) return run;
  run.fix = std::move(fix).value();
  for (const audit::Fix::File& file : run.fix.files)
    if (file.file == FileIndex{0}) run.text = keyword::with_lines(bytes, keyword::LineIndex(bytes), file.edits);
  return run;
}

inline FixRun fix_text(const std::string& text, const audit::FixOptions& options = {}) {
  Diagnostics diagnostics;
  return run_fix(keyword::read_deck_text(text, "deck.k", {}, diagnostics), options);
}

inline FixRun fix_file(const std::string& path, const audit::FixOptions& options = {}) {
  Diagnostics diagnostics;
  return run_fix(keyword::read_deck(path, {}, diagnostics), options);
}

/// Every line is as before but for the coordinates of the nodes that the report lists.
inline void expect_only_listed_lines(const std::string& before, const FixRun& run) {
  std::istringstream a(before), b(run.text);
  std::set<std::uint32_t> listed;
  for (const MovedNode& m : run.report().moved)
    if (m.file == 0) listed.insert(m.line);
  std::string x, y;
  for (std::uint32_t line = 1; std::getline(a, x); ++line) {
    ASSERT_TRUE(std::getline(b, y));
    if (!listed.contains(line)) {
      EXPECT_EQ(x, y) << line;
      continue;
    }
    EXPECT_NE(x, y) << line;
    EXPECT_EQ(x.substr(0, 8), y.substr(0, 8)) << line;
    EXPECT_EQ(x.substr(std::min<std::size_t>(56, x.size())), y.substr(std::min<std::size_t>(56, y.size()))) << line;
  }
  EXPECT_FALSE(std::getline(b, y));
}

}  // namespace gapcheck::audit_test
