#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/ids.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// A node whose motion the deck requests.
struct HistoryNode {
  NodeIndex node;
  std::string title;
};

/// An element whose stresses the deck requests.
struct HistoryElement {
  std::uint32_t element = 0;  ///< position in its array of Mesh
  std::string title;
};

/// The files of curves that a run can write into a binout.
inline constexpr std::array<std::string_view, 15> binout_branches{"glstat",  "matsum",  "nodout", "rcforc",  "sleout",
                                                                  "secforc", "spcforc", "bndout", "rwforc",  "rbdout",
                                                                  "swforc",  "elout",   "deforc", "jntforc", "abstat"};

/// Intervals of the result files in the model's time; zero: not requested. A DT not above zero counts as none.
struct Output {
  double d3plot = 0, intfor = 0;
  Place intfor_place;
  double glstat = 0, matsum = 0, nodout = 0, rcforc = 0, sleout = 0, ncforc = 0;
  double secforc = 0, spcforc = 0, bndout = 0, rwforc = 0, rbdout = 0, swforc = 0, elout = 0;
  double deforc = 0, jntforc = 0, abstat = 0;
  /// BINARY of *DATABASE_…, by file: 0, 1 text, 2 binout, 3 both. Absent: a file without a card, or one that is no
  /// branch of the binout.
  std::map<std::string, int, std::less<>> binary;
  std::vector<HistoryNode> history_nodes;                                     ///< in the order of the deck, each once
  std::vector<HistoryElement> history_solids, history_beams, history_shells;  ///< the same
  bool local_shells = false;  ///< EOCS = 1 of *CONTROL_OUTPUT: elout has shells in their own axes
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
