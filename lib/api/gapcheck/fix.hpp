#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gapcheck/includes.hpp>
#include <gapcheck/result.hpp>
#include <memory>
#include <string>
#include <vector>

namespace gapcheck::api {

/// Parts or nodes that must not move: all ids from first to last.
struct Lock {
  enum class Of : std::uint8_t { parts, nodes };

  Of of = Of::parts;
  std::int64_t first = 0, last = 0;  ///< 1 or more, `last` not below `first`
};

/// The nodes of a part move less if its factor is larger than that of other parts.
struct Priority {
  std::int64_t part = 0;  ///< id
  double factor = 1;      ///< 1e-6 to 1e6
};

/// How a deck may be corrected. The defaults are those of `gapcheck fix`.
struct FixOptions {
  Includes includes = {};
  std::vector<Lock> locks = {};
  std::vector<Priority> priorities = {};
  bool recommended = false;  ///< nodes of contacts with IGNORE = 2 go where the solver recommends; no others move
  bool free_welds = false;   ///< nodes of spot welds, rivets and weld elements may move against each other
  std::size_t jobs = 0;      ///< as AuditOptions::jobs
  /// Called now and then by the thread that works, which waits for it. False stops the correction, which is an error
  /// then. It must not throw. Empty: no calls.
  std::function<bool()> watch = {};
};

/// One contact before and after the correction.
struct FixContact {
  struct State {
    std::uint64_t penetrations = 0, released = 0;  ///< `released`: too deep, not among the penetrations
    double deepest = 0;
  };

  std::int64_t id = 0;
  std::string keyword, title;
  std::string not_checked;  ///< why neither penetrations nor ties were decided; empty: they were
  State before, after;
  bool by_segments = false;  ///< SOFT = 2 or mortar: `before` and `after` are corners of segments
  std::uint64_t edges_before = 0, edges_after = 0;  ///< edges that penetrate others, in types 26
};

/// A node that was moved; coordinates of the deck.
struct MovedNode {
  std::int64_t node = 0;  ///< id
  double from[3] = {}, to[3] = {};
  bool onto_tie = false;             ///< onto the segment that it is tied to
  std::uint32_t file = 0, line = 0;  ///< `file` is a position in Fix::files
};

/// A node that penetrates after the correction.
struct UnfixedNode {
  std::int64_t contact = 0, node = 0, part = 0, element = 0, element_part = 0;  ///< ids; 0: unknown
  double depth = 0, contact_distance = 0;
  bool released = false;  ///< so deep that the solver releases it
  std::string reason;     ///< what holds it: "locked", "rigid", "shape", …; "none": no way was found
};

/// One rigid wall before and after the correction, of those in which nodes lie.
struct FixWall {
  std::int64_t id = 0;
  std::string title;
  std::uint64_t nodes_before = 0, nodes_after = 0;
  double deepest_before = 0, deepest_after = 0;
  std::vector<UnfixedNode> unfixed;  ///< without contact, part and element
};

/// Instead of moving nodes: what else would remove the penetrations of two parts.
struct FixProposal {
  struct Alternative {
    std::string text;  ///< what it is
    std::string card;  ///< the keyword lines
  };

  std::int64_t contact = 0, part = 0, other_part = 0;  ///< ids; part 0: nodes without part
  std::uint64_t penetrations = 0;
  double deepest = 0;
  double thickness = 0;  ///< the largest for both parts without penetrations; 0: none was found
  std::vector<Alternative> alternatives;
};

/// A file of the deck after the correction. Everything except the lines of moved nodes is unchanged, byte for byte.
struct ChangedFile {
  std::string path;         ///< of the file that was read, which stays unchanged
  std::string place;        ///< path below the main file's folder; only its name if it is elsewhere
  std::uint64_t lines = 0;  ///< that differ
  std::string text;
};

/// Holds what text() and json() write; not for use.
struct FixStore;

/// A correction of a deck. Lengths and coordinates in the deck's units.
struct Fix {
  /// Nothing penetrates any more, and no tied node keeps a separation that was to be removed.
  bool solved = false;
  std::vector<std::string> files;  ///< of the deck; what `file` members refer to
  std::vector<FixContact> contacts;
  std::vector<FixWall> walls;          ///< in the order of the deck
  std::vector<MovedNode> moved;        ///< by node id
  std::vector<UnfixedNode> unfixed;    ///< by contact, deepest first
  std::vector<FixProposal> proposals;  ///< by contact and parts
  std::vector<ChangedFile> changed;    ///< in the order of the deck; empty: nothing was moved
  double largest_move = 0, total_move = 0;
  std::uint64_t elements_touched = 0, elements_worsened = 0;  ///< with a moved node; of these with a worse shape
  bool cut_short = false;                 ///< the search ended because it took too long; more might be possible
  std::vector<std::string> notes;         ///< input that the correction ignores
  std::vector<Diagnostic> diagnostics;    ///< warnings about the deck, by file and line
  std::shared_ptr<const FixStore> store;  ///< what text() and json() work on
};

/// Moves nodes as little as possible until nothing penetrates initially any more. Writes nothing: `changed` holds the
/// new texts, which take as much memory as the files. Errors: the deck cannot be read in full; a keyword that moves or
/// creates nodes and is not known; an option that names no part or node of the deck, or no valid number. Takes minutes
/// at most; FixOptions::watch stops it in less than the time of a search of all contacts. May be called from several
/// threads at once.
///
///     const auto fix = gapcheck::api::fix_deck("model.k");
///     if (!fix) return fail(fix.error());
///     for (const auto& file : fix.value().changed) write("fixed/" + file.place, file.text);
[[nodiscard]] Result<Fix> fix_deck(const std::string& path, const FixOptions& options = {});

/// The correction as `gapcheck fix` prints it. `top`: nodes and pairs of parts to list.
[[nodiscard]] std::string text(const Fix& fix, std::size_t top = 10);
/// The same as JSON, complete.
[[nodiscard]] std::string json(const Fix& fix);

}  // namespace gapcheck::api
