#pragma once
#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "common/file_guard.hpp"
#include "keyword/deck.hpp"
#include "records/node_move.hpp"

namespace gapcheck::app {

/// Files that show a deck before and after its nodes move; empty names: not requested.
struct BeforeAfter {
  std::string html, vtu;
};
void add_before_after(CLI::App& command, BeforeAfter& files);

/// The outputs that are requested, under their names.
[[nodiscard]] std::vector<PlannedOutput> planned_outputs(const BeforeAfter& files);

/// Audits the deck and writes the requested files with the moves. `said`: a sentence about them for the page.
[[nodiscard]] Status write(const BeforeAfter& files, const std::string& deck, const keyword::ReadOptions& read,
                           std::vector<NodeMove> moves, std::string said);

}  // namespace gapcheck::app
