#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "records/fix_proof.hpp"
#include "records/repair.hpp"

namespace gapcheck {

/// Why a node was not moved, or no further.
enum class HoldReason : std::uint8_t {
  none,
  locked,       ///< the user locked it or its part
  rigid,        ///< a rigid body has it
  constrained,  ///< a boundary condition holds it
  unwritable,   ///< its line in the deck cannot be rewritten: a parameter, defined twice, …
  shape,        ///< an element would be turned inside out, warped or stretched too much
  conflict,     ///< freeing it from one segment pushes it into another
  crossing,     ///< elements that did not cross before would cross
};
[[nodiscard]] std::string_view name(HoldReason reason);
/// "its part or the node itself is locked"
[[nodiscard]] std::string_view words(HoldReason reason);

/// A node with its coordinates in the deck and after the correction; in the model's units.
struct MovedNode {
  std::int64_t node = 0;
  Vector from = Vector::Zero(), to = Vector::Zero();
  bool onto_tie = false;             ///< moved onto the segment that it is tied to
  std::uint32_t file = 0, line = 0;  ///< file is a position in FixReport::files
  [[nodiscard]] double distance() const { return (to - from).norm(); }
};

/// A node that penetrates after the correction.
struct UnfixedNode {
  std::uint32_t contact = 0;  ///< position in FixReport::contacts
  std::int64_t node = 0, part = 0, element = 0, element_part = 0;
  double depth = 0, contact_distance = 0;
  bool released = false;  ///< too deep: the solver releases it
  HoldReason reason = HoldReason::none;
  std::uint32_t file = 0, line = 0;
};

/// Elements that still cross along one line after the correction.
struct LeftCrossing {
  std::uint32_t contact = 0;                    ///< position in FixReport::contacts
  std::int64_t part = 0, other_part = 0;        ///< ids; 0: elements without part
  std::int64_t element = 0, other_element = 0;  ///< one of each
  std::uint64_t pairs = 0;                      ///< of elements
  std::string why;                              ///< in words
};

/// A body of solids that lies wholly inside another part; it stays there.
struct EnclosedSolids {
  std::uint32_t contact = 0;              ///< position in FixReport::contacts
  std::int64_t part = 0, outer_part = 0;  ///< ids
  std::int64_t element = 0;               ///< the first of its solids
  std::uint64_t solids = 0;
};

/// An alternative that would remove the penetrations between two parts: what it is, and the keyword lines.
struct FixAlternative {
  std::string text, card;
  RepairKind kind = RepairKind::exclude;
  RepairSettings settings = {};  ///< the same for a program
  double cost = 1;  ///< share of the contact distance that is given away or forgiven; 1: the contact itself
};

/// Alternatives to moving nodes for two parts.
struct FixProposal {
  std::int64_t contact = 0, part = 0, other_part = 0;  ///< ids; part 0: nodes without part
  std::uint64_t penetrations = 0;
  double deepest = 0;
  double thickness = 0;       ///< the largest for both without penetrations; 0: none was found
  bool not_searched = false;  ///< OPTT was not searched: there are too many pairs
  std::vector<FixAlternative> alternatives;
};

/// One contact before and after.
struct FixContact {
  struct State {
    std::uint64_t penetrations = 0, released = 0;
    double deepest = 0;
  };
  std::int64_t id = 0;
  std::string keyword, title, not_checked;
  State before, after;
  bool by_segments = false;  ///< SOFT = 2 or mortar: `before` and `after` are corners of segments
  std::uint64_t edges_before = 0, edges_after = 0;  ///< edges that penetrate others, in types 26
};

/// One rigid wall before and after, of those in which nodes lie.
struct FixWall {
  std::int64_t id = 0;
  std::string title;
  FixContact::State before, after;
  std::vector<UnfixedNode> unfixed;  ///< by node; without contact and element
};

/// A file of the deck that has changed.
struct FixedFile {
  std::string path;     ///< as read
  std::string written;  ///< where the new one is; empty: not written
  std::uint64_t lines = 0;
};

/// Everything that a correction of penetrations reports.
struct FixReport {
  std::string input;
  std::vector<std::string> files;  ///< of the deck; what `file` members point into
  std::vector<FixContact> contacts;
  std::vector<FixWall> walls;            ///< in the order of the deck
  std::vector<MovedNode> moved;          ///< ascending by node id
  std::vector<UnfixedNode> unfixed;      ///< by contact, deepest first
  std::vector<LeftCrossing> crossings;   ///< after it, by contact
  std::vector<EnclosedSolids> enclosed;  ///< after it
  std::vector<FixProposal> proposals;    ///< by contact and parts
  std::vector<FixedFile> changed;        ///< in the order of the deck
  std::vector<std::string> notes;        ///< input that is not supported
  double largest_move = 0, total_move = 0;
  std::uint64_t elements_touched = 0, elements_worsened = 0;  ///< with a moved node; of these with a worse shape
  std::uint64_t crossings_before = 0, crossings_after = 0;    ///< elements that cross another one
  std::uint64_t separated_ties_before = 0, separated_ties_after = 0;
  std::uint64_t rounds = 0;
  bool cut_short = false;  ///< the search ended because it took too long; more might be possible
  bool dry_run = false;
  std::optional<FixProof> proof;  ///< runs before and after, where they were asked for
  [[nodiscard]] double mean_move() const { return moved.empty() ? 0 : total_move / static_cast<double>(moved.size()); }
};

/// Nodes and edges that penetrate before the correction, and after it.
[[nodiscard]] std::uint64_t penetrating_before(const FixReport& report);
[[nodiscard]] std::uint64_t penetrating_after(const FixReport& report);
/// True if nothing penetrates or crosses any more and no tied node keeps a separation that was to be removed.
[[nodiscard]] bool complete(const FixReport& report);

}  // namespace gapcheck
