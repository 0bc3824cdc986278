#pragma once
#include <string>
#include <vector>

#include "base/ids.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// A node whose motion the deck asks for.
struct HistoryNode {
  NodeIndex node;
  std::string title;
};

/// Intervals of the result files in the model's time; zero: not asked for. A DT that is not above zero counts as none.
struct Output {
  double d3plot = 0;
  double glstat = 0, matsum = 0, nodout = 0, rcforc = 0, sleout = 0, ncforc = 0;
  std::vector<HistoryNode> history_nodes;  ///< in the order of the deck, each once
  /// What the deck asks for and will not get: curves of intervals, nodes that do not exist. Only a run needs to tell.
  struct Note {
    Place place;
    std::string text;
  };
  std::vector<Note> notes;
};

}  // namespace gapcheck::model
