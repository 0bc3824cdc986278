#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::model {

/// A model with everything that was said while it was read.
struct Read {
  Model model;
  std::vector<Diagnostic> diagnostics;

  [[nodiscard]] std::size_t errors() const { return count(Severity::error); }
  [[nodiscard]] std::size_t warnings() const { return count(Severity::warning); }
  [[nodiscard]] std::size_t faults(Fault::Kind kind) const {
    std::size_t number = 0;
    for (const Fault& fault : model.faults) number += fault.kind == kind ? 1 : 0;
    return number;
  }
  /// All messages, one per line, for EXPECT texts.
  [[nodiscard]] std::string text() const {
    std::string all;
    for (const Diagnostic& d : diagnostics) all += d.file + ":" + std::to_string(d.line) + ": " + d.message + "\n";
    for (const Fault& fault : model.faults) all += std::to_string(fault.place.line) + ": " + fault.message + "\n";
    return all;
  }

 private:
  [[nodiscard]] std::size_t count(Severity severity) const {
    std::size_t number = 0;
    for (const Diagnostic& d : diagnostics) number += d.severity == severity ? 1 : 0;
    return number;
  }
};

inline Read read_text(std::string text) {
  Diagnostics diagnostics;
  auto deck = keyword::read_deck_text(std::move(text), "a.k", {}, diagnostics);
  if (!deck) {
    ADD_FAILURE() << deck.error().message;
    return {};
  }
  auto model = read_model(deck.value(), diagnostics);
  if (!model) {
    ADD_FAILURE() << model.error().message;
    return {};
  }
  return {std::move(model).value(), diagnostics.sorted()};
}

/// Node i (from 1) at (i, 10 i, 100 i).
inline std::string nodes_text(int count) {
  std::string text = "*NODE\n";
  for (int i = 1; i <= count; ++i)
    text += std::to_string(i) + "," + std::to_string(i) + "," + std::to_string(10 * i) + "," + std::to_string(100 * i) +
            "\n";
  return text;
}

/// Part 1 with shell section 1 (thickness 2) and elastic material 1.
inline const std::string part_text =
    "*PART\nplate\n         1         1         1\n"
    "*SECTION_SHELL\n         1         2\n       2.0\n"
    "*MAT_ELASTIC\n         1     0.001   21000.0       0.3\n";

}  // namespace gapcheck::model
