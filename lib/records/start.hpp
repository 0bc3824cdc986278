#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "records/expected_contact.hpp"
#include "records/penetration.hpp"

namespace gapcheck {

/// What moved a node before the first step.
enum class StartCause : std::uint8_t {
  shot,         ///< the shooting-node logic, when the contact was initialised
  tied,         ///< a tie, onto the segment that it ties to
  first_cycle,  ///< the shooting-node logic in the first cycle: an earlier move had pushed it into a segment
};
[[nodiscard]] std::string_view name(StartCause cause);

/// One move of one node. Lengths here and below are in the deck's unit.
struct StartMove {
  std::uint32_t contact = 0;  ///< position in StartReport::contacts
  std::int64_t node = 0;
  std::int64_t part = 0, other_part = 0;  ///< ids of the node's part and of the segment's; 0: not known
  Vector from = Vector::Zero(), to = Vector::Zero();
  StartCause cause = StartCause::shot;
};

/// A node that penetrates as the first cycle begins, beyond the rounding of its coordinates.
struct StartNode {
  std::uint32_t contact = 0;  ///< position in StartReport::contacts
  std::int64_t node = 0;
  std::int64_t part = 0, other_part = 0;  ///< ids of the node's part and of the segment's; 0: not known
  Outcome outcome = Outcome::forced;      ///< kept, forced or released
  /// Kept: the penetration that IGNORE forgives; forced: the one that the spring pushes against; released: the way back
  /// out of the contact zone.
  double depth = 0;
  double contact_distance = 0;  ///< 0: without contact thickness
  double energy = 0;            ///< of its spring; 0: it has none, or it is not known
  /// Further penetration with which it is released; infinity: none, or not known.
  double to_release = std::numeric_limits<double>::infinity();
};

/// An element with a moved node, in the deck and at the start.
struct StartElement {
  struct Shape {
    double edge_ratio = 1;                                  ///< longest edge over shortest one; beams: 1
    double warp = 0;                                        ///< of shells, degrees
    double size = 0;                                        ///< length, area or volume; negative: turned inside out
    double step = std::numeric_limits<double>::infinity();  ///< without TSSFAC; infinity: it has none
  };
  std::string_view kind;  ///< "shell", "solid", "thick shell" or "beam"
  std::int64_t id = 0, part = 0;
  std::int64_t contact = 0;  ///< id of the contact that moved its farthest node last
  Shape before, after;
  bool inverted = false, flat = false;  ///< by the moves
  [[nodiscard]] bool collapsed() const { return inverted || flat; }
};

/// What the moves do to the elements at moved nodes.
struct StartShapes {
  std::uint64_t touched = 0, changed = 0, collapsed = 0;  ///< with a moved node; of these visibly changed; unusable
  /// Positions in StartReport::elements: those with the largest edge ratio and warp and the smallest step afterwards,
  /// among those in which it has become worse.
  std::optional<std::size_t> edge_ratio, warp, step;
};

/// Number of bins of a histogram of moves: equal ones, from 0 to the largest move.
inline constexpr std::size_t start_bins = 5;

/// What a contact does before the first step, in all or between two parts.
struct StartCounts {
  std::uint64_t moved = 0;  ///< nodes; moves within the rounding of the coordinates do not count
  double largest_move = 0, total_move = 0;
  std::array<std::uint64_t, start_bins> histogram{};  ///< of these moves
  std::uint64_t kept = 0;                             ///< nodes whose penetration IGNORE forgives
  double deepest_kept = 0;                            ///< largest forgiven penetration
  std::optional<double> least_share;                  ///< smallest share of the contact thickness that is left
  std::uint64_t forced = 0;                           ///< nodes with a force from the beginning
  double deepest_forced = 0;
  double energy = 0;                 ///< of their springs: sum of k p² / 2
  std::uint64_t released = 0;        ///< nodes without contact until they have left the contact zone
  double way_out = 0;                ///< of released nodes: the longest way back out of the contact zone
  std::optional<double> to_release;  ///< smallest further penetration with which a kept or forced node is released
  StartShapes shapes;
  [[nodiscard]] bool clean() const { return moved + kept + forced + released == 0; }
};

/// Two parts in a contact.
struct StartPair : StartCounts {
  std::uint32_t contact = 0;              ///< position in StartReport::contacts
  std::int64_t part = 0, other_part = 0;  ///< ids: of the nodes, of the segments; 0: not known
};

struct StartContact : StartCounts {
  std::int64_t id = 0;
  std::string title, keyword;
  std::string not_known;  ///< why nothing is known about it; empty: something is
  std::string no_energy;  ///< why the energy of its springs is not known; empty: it is
};

/// A node that is moved more than once.
struct StartRepeat {
  std::int64_t node = 0;
  std::vector<std::uint32_t> contacts;  ///< positions of those that moved it, in that order
  double path = 0, net = 0;             ///< sum of the moves, and from the deck to the start
  bool back = false;                    ///< a move goes against an earlier one
};

/// Two elements that cross each other at the start and not in the deck.
struct StartCrossing {
  struct Element {
    std::string_view kind;
    std::int64_t id = 0, part = 0;
  };
  Element a, b;
  std::int64_t contact = 0;   ///< id of the first contact that keeps them apart
  std::int64_t moved_by = 0;  ///< id of the contact that last moved one of their nodes
  double depth = 0;           ///< by which they stick out behind each other, the smaller of the two
};

/// A part of the deck for which `run` refuses it.
struct StartRefusal {
  std::string keyword;  ///< without `*`; empty: `why` names it
  std::string file;
  std::uint32_t line = 0;
  std::string why;
};

/// The geometry and the energy with which a run starts.
struct StartReport {
  std::string input;
  std::vector<StartContact> contacts;  ///< in deck order
  std::vector<StartPair> pairs;        ///< by contact, then parts; only those with which something happens
  std::vector<StartMove> moves;        ///< in the order in which they happen
  std::vector<StartNode> nodes;        ///< by contact, deepest first, then by node
  std::vector<StartRepeat> repeats;    ///< ascending by node
  std::vector<StartElement> elements;  ///< visibly changed or collapsed: collapsed ones first, then by loss of step
  StartShapes shapes;                  ///< of all moves together
  std::vector<StartCrossing> crossings;
  std::optional<ExpectedContacts> expected;  ///< nothing: nothing moves at the start
  std::uint64_t moved = 0;  ///< nodes that are not where the deck has them, beyond the rounding of their coordinates
  double largest_move = 0;  ///< from the deck to the start
  double energy = 0;        ///< of all contact springs, as far as it is known
  /// Kinetic energy and step of the run's first cycle, where it was calculated.
  std::optional<double> kinetic, first_step;
  /// Smallest step of all elements in the deck and at the start, without TSSFAC; infinity: none has one.
  double step_before = std::numeric_limits<double>::infinity(), step_after = std::numeric_limits<double>::infinity();
  bool first_cycle = false;           ///< contacts are followed through the first cycle; else through initialisation
  std::vector<StartRefusal> refused;  ///< why `run` refuses the deck
  std::vector<std::string> notes;     ///< input that is not supported
  std::vector<std::string> written;   ///< files of --write-deck
  double rounding = 0;                ///< largest distance between a written node and the node at the start
};

/// One line about a contact: "starts clean", "loses 14 nodes; starts with 12 from nothing".
[[nodiscard]] std::string score(const StartContact& contact);
/// True if every contact starts clean and the moves spoil nothing.
[[nodiscard]] bool starts_clean(const StartReport& report);

}  // namespace gapcheck
