#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gapcheck/includes.hpp>
#include <gapcheck/records.hpp>
#include <gapcheck/result.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::api {

/// How the start of a run is followed.
struct StartOptions {
  Includes includes = {};
  bool picture = false;  ///< audit the deck as well and keep what html() draws
  bool mesh = false;     ///< audit the deck as well and keep the elements for vtu()
  /// Called now and then by the thread that works, which waits for it. False stops the work, which is an error then. It
  /// must not throw. Empty: no calls.
  std::function<bool()> watch = {};
  std::size_t jobs = 0;  ///< as AuditOptions::jobs
};

/// What moved a node before the first cycle.
enum class StartCause : std::uint8_t {
  shot,         ///< the shooting-node logic, when the contact was initialised
  tied,         ///< a tie, onto the segment that it ties to
  first_cycle,  ///< the shooting-node logic in the first cycle: an earlier move had pushed it into a segment
};
/// "shot", "tied", "first-cycle".
[[nodiscard]] std::string_view name(StartCause cause);

/// n moves of nodes in the order in which they happen, as parallel arrays like Penetrations. A node may be moved more
/// than once. Positions in the deck's coordinates.
struct StartMoves {
  [[nodiscard]] std::size_t size() const { return node.size(); }

  std::span<const std::uint32_t> contact;    ///< n, positions in Start::contacts
  std::span<const std::int64_t> node;        ///< n ids
  std::span<const std::int64_t> part;        ///< n ids, of the node; 0: not known
  std::span<const std::int64_t> other_part;  ///< n ids, of the segment; 0: not known
  std::span<const double> from, to;          ///< n × 3
  std::span<const StartCause> cause;         ///< n
};

/// n nodes that penetrate as the first cycle begins, beyond the rounding of their coordinates, by contact, deepest
/// first, then by node. Lengths and energies in the deck's units.
struct StartNodes {
  [[nodiscard]] std::size_t size() const { return node.size(); }

  std::span<const std::uint32_t> contact;    ///< n, positions in Start::contacts
  std::span<const std::int64_t> node;        ///< n ids
  std::span<const std::int64_t> part;        ///< n ids, of the node; 0: not known
  std::span<const std::int64_t> other_part;  ///< n ids, of the segment; 0: not known
  std::span<const Outcome> outcome;          ///< n: kept (forgiven by IGNORE), forced or released
  /// n. Kept: the penetration that is forgiven; forced: the one that the spring pushes against; released: the way back
  /// out of the contact zone.
  std::span<const double> depth;
  std::span<const double> contact_distance;  ///< n; 0: without contact thickness
  std::span<const double> energy;            ///< n, of the spring; 0: none, or not known
  std::span<const double> to_release;  ///< n, further penetration with which it is released; infinity: none, not known
};

/// The n nodes of the deck, and where they are in the first cycle.
struct StartPositions {
  [[nodiscard]] std::size_t size() const { return node.size(); }

  std::span<const std::int64_t> node;  ///< n ids
  std::span<const double> deck;        ///< n × 3
  std::span<const double> start;       ///< n × 3
};

/// What a contact does before the first step, in all or between two parts. Numbers of nodes and elements; lengths and
/// energies in the deck's units.
struct StartCounts {
  std::uint64_t moved = 0;
  double largest_move = 0, total_move = 0;
  std::array<std::uint64_t, 5> histogram{};  ///< nodes in equal bins from 0 to the largest move
  std::uint64_t kept = 0;                    ///< whose penetration IGNORE forgives
  double deepest_kept = 0;
  std::optional<double> least_share;  ///< smallest share of the contact thickness that is left; none: no thickness
  std::uint64_t forced = 0;           ///< with a force from the beginning
  double deepest_forced = 0;
  double energy = 0;                 ///< of their springs
  std::uint64_t released = 0;        ///< without contact until they have left the contact zone
  double way_out = 0;                ///< the longest way out
  std::optional<double> to_release;  ///< smallest further penetration with which a kept or forced node is released
  std::uint64_t touched = 0, changed = 0, collapsed = 0;  ///< elements at moved nodes; visibly changed; unusable
};

struct StartContact : StartCounts {
  std::int64_t id = 0;
  std::string title, keyword;
  std::string score;      ///< one line: "starts clean", "loses 14 nodes"
  std::string not_known;  ///< why nothing is known about it; empty: something is
  std::string no_energy;  ///< why the energy of its springs is not known; empty: it is
};

/// Two parts in a contact.
struct StartPair : StartCounts {
  std::uint32_t contact = 0;              ///< position in Start::contacts
  std::int64_t part = 0, other_part = 0;  ///< ids: of the nodes, of the segments; 0: not known
};

/// A node that is moved more than once.
struct StartRepeat {
  std::int64_t node = 0;                ///< id
  std::vector<std::uint32_t> contacts;  ///< positions of those that moved it, in that order
  double path = 0, net = 0;             ///< sum of the moves; from the deck to the start
  bool back = false;                    ///< a move goes against an earlier one
};

/// An element with a moved node that has visibly changed or collapsed.
struct StartElement {
  struct Shape {
    double edge_ratio = 1;  ///< longest edge over shortest one
    double warp = 0;        ///< of shells, degrees
    double size = 0;        ///< length, area or volume; negative: turned inside out
    double step = 0;        ///< stable time step without TSSFAC; infinity: it has none
  };

  std::string_view kind;                ///< "shell", "solid", "thick shell" or "beam"
  std::int64_t id = 0, part = 0;        ///< ids
  std::int64_t contact = 0;             ///< id of the contact that moved its farthest node last
  Shape before, after;                  ///< in the deck, at the start
  bool inverted = false, flat = false;  ///< by the moves
};

/// Two elements that cross each other at the start and not in the deck.
struct StartCrossing {
  std::string_view kind, other_kind;                            ///< as StartElement::kind
  std::int64_t id = 0, part = 0, other_id = 0, other_part = 0;  ///< ids
  std::int64_t contact = 0;                                     ///< id of the first contact that keeps them apart
  std::int64_t moved_by = 0;  ///< id of the contact that last moved one of their nodes
  double depth = 0;           ///< by which they stick out behind each other, the smaller of the two
};

/// A part of the deck for which run_deck() refuses it.
struct StartRefusal {
  std::string keyword;  ///< without `*`; empty: `why` names it
  std::string file;
  std::uint32_t line = 0;
  std::string why;
};

/// What the nodes of one part do to the segments of another one, if all go on along straight lines.
struct ExpectedContact {
  std::uint32_t contact = 0;              ///< position in Start::contacts
  std::int64_t part = 0, other_part = 0;  ///< ids: of the nodes, of the segments; 0: not known
  std::uint64_t nodes = 0;                ///< that meet a segment
  std::int64_t node = 0;                  ///< the first of them, an id
  double time = 0, speed = 0;             ///< when it does; greatest speed of approach, along the normal
  std::optional<double> in_step;  ///< largest share of 0.8 of the contact distance that a node comes closer in one step
  std::uint64_t crossing = 0;     ///< nodes that come closer by all of it
  std::optional<double> margin;   ///< depth of release over the depth that is reached; none: not known
  std::optional<double> alone;    ///< the same with the spring of each node alone, where parts deform
  std::optional<double> low, high;  ///< between which the margin of the run lies
  std::string reason;               ///< why the margin is not known; empty: it is
  bool lost = false, held = false, never_released = false;
};

/// Nodes of a part that reach a rigid wall along straight lines.
struct ExpectedWall {
  std::int64_t wall = 0, part = 0;  ///< ids; part 0: none
  std::uint64_t nodes = 0;
  std::int64_t node = 0;  ///< the first of them, an id
  double time = 0, speed = 0;
};

/// What will meet, if all goes on along straight lines, and where contact will not hold it.
struct ExpectedContacts {
  double until = 0, end = 0, step = 0;     ///< as far as the search has looked; of the run; of its first cycle
  std::vector<ExpectedContact> contacts;   ///< the least margin first
  std::vector<ExpectedWall> walls;         ///< by time
  std::vector<std::string> not_looked_at;  ///< what could meet and is not looked at
};

/// Holds what the views of a start point into; not for use.
struct StartStore;

/// The geometry and the energy with which a run of a deck starts. Copies share the arrays; the views stay valid while
/// one of the copies lives.
///
///     const StartMoves& m = start.moves;
///     for (std::size_t i = 0; i < m.size(); ++i) print(m.node[i], m.to[3 * i] - m.from[3 * i]);
struct Start {
  std::string input;                   ///< the path as it was given
  bool clean = true;                   ///< every contact starts clean and the moves spoil nothing
  std::vector<std::string> files;      ///< of the deck
  std::vector<StartContact> contacts;  ///< in deck order
  std::vector<StartPair> pairs;        ///< by contact, then parts; only those with which something happens
  StartMoves moves;
  StartNodes nodes;
  StartPositions positions;
  std::vector<StartRepeat> repeats;    ///< ascending by node
  std::vector<StartElement> elements;  ///< collapsed ones first, then by loss of step
  std::vector<StartCrossing> crossings;
  std::optional<ExpectedContacts> expected;  ///< none: nothing moves at the start
  std::uint64_t moved = 0;  ///< nodes that are not where the deck has them, beyond the rounding of their coordinates
  double largest_move = 0;  ///< from the deck to the start
  double energy = 0;        ///< of all contact springs, as far as it is known
  std::uint64_t touched = 0, changed = 0, collapsed = 0;  ///< elements, as StartCounts
  std::optional<double> kinetic, first_step;              ///< of the run's first cycle, where it was calculated
  double step_before = 0, step_after = 0;   ///< smallest step of an element in the deck, at the start; infinity: none
  bool first_cycle = false;                 ///< contacts are followed through it; else through initialisation
  std::vector<StartRefusal> refused;        ///< why run_deck() refuses the deck
  std::vector<std::string> notes;           ///< input that is not supported
  std::vector<Diagnostic> diagnostics;      ///< warnings about the deck, by file and line
  std::shared_ptr<const StartStore> store;  ///< what text() and the like work on
};

/// Prepares a run of the deck, follows its contacts through the first cycle, and tells what they did to the geometry of
/// the deck. A deck that run_deck() refuses is followed as far as possible; Start::refused says why. Writes nothing.
/// Errors: the deck cannot be read in full; `watch` stopped it. Memory: some 200 bytes per node beyond those of an
/// audit. May be called from several threads at once.
///
///     const auto start = gapcheck::api::start_deck("model.k");
///     if (!start) return fail(start.error());
///     print(start.value().moves.size(), start.value().energy);
[[nodiscard]] Result<Start> start_deck(const std::string& path, const StartOptions& options = {});

/// The start as `gapcheck start` prints it. `top`: pairs of parts, elements and nodes to list.
[[nodiscard]] std::string text(const Start& start, std::size_t top = 10);
/// The same as JSON, complete.
[[nodiscard]] std::string json(const Start& start);
/// The page of `gapcheck start --html`: the mesh in the deck and at the start, and the findings of the deck; empty
/// without StartOptions::picture.
[[nodiscard]] std::string html(const Start& start);
/// The grid of `gapcheck start --vtu` for ParaView; empty without StartOptions::mesh.
[[nodiscard]] std::string vtu(const Start& start);

}  // namespace gapcheck::api
