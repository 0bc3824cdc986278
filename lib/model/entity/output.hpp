#pragma once
#include <string>
#include <vector>

#include "base/ids.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// A node whose motion the deck requests.
struct HistoryNode {
  NodeIndex node;
  std::string title;
};

/// Intervals of the result files in the model's time; zero: not requested. A DT not above zero counts as none.
struct Output {
  double d3plot = 0;
  double glstat = 0, matsum = 0, nodout = 0, rcforc = 0, sleout = 0, ncforc = 0;
  std::vector<HistoryNode> history_nodes;  ///< in the order of the deck, each once
  /// Requests of the deck that are not met: curves of intervals, nodes that do not exist. Only a run reports them.
  struct Note {
    Place place;
    std::string text;
  };
  std::vector<Note> notes;
  /// A result file with an interval that a run does not write.
  struct Unwritten {
    Place place;
    std::string name;  ///< "elout"
  };
  std::vector<Unwritten> unwritten;  ///< in the order of the deck
  /// The notes, with one more that names all unwritten files, at the first of them.
  [[nodiscard]] std::vector<Note> all_notes() const;
};

}  // namespace gapcheck::model
