#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "records/baseline.hpp"
#include "records/element_mesh.hpp"
#include "records/ignored.hpp"
#include "records/node_move.hpp"
#include "records/penetration.hpp"
#include "records/portability.hpp"
#include "records/scene_mesh.hpp"
#include "records/solver_run.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck {

/// Ids of all nodes and segments that one finding represents; triangles, beams and edges repeat their last node.
struct FindingMembers {
  std::vector<std::int64_t> nodes;
  std::vector<std::array<std::int64_t, 4>> segments;
};

/// One finding that is not a penetration record (references, definitions, mesh, input). Ids of 0 and negative lengths:
/// not known or without a meaning for the rule.
struct Finding {
  std::string id;    ///< "GC501"
  std::string rule;  ///< "duplicate-id"
  Severity severity = Severity::warning;
  std::string message;
  std::int64_t contact = 0;  ///< contact id
  std::int64_t node = 0, part = 0;
  std::int64_t element = 0, element_part = 0;
  double penetration = -1, contact_distance = -1;
  std::optional<Vector> point;  ///< where to look
  std::uint64_t count = 1;      ///< more than 1: a line that represents that many things
  std::string file;             ///< empty: none
  std::uint32_t line = 0;
  std::string_view consequence = {};  ///< of the rule (RuleIdentity), in static storage; empty: not known
  std::uint32_t key = 0;              ///< not 0: findings that follow from this one have it as their `cause`
  std::uint32_t cause = 0;            ///< key of the finding that this one follows from; 0: stands by itself
  FindingMembers members = {};        ///< only on request; what a rule does not list may be missing
};

/// What the solver says of the initial penetrations of one contact, all its blocks together.
struct InitialSummary {
  std::uint64_t messages = 0, nodes = 0, eliminated = 0;
  double least = 0, greatest = 0;  ///< penetration: of the nodes; of those eliminated where there are no others
  /// Of another block of the same contact: its other side, or what was eliminated later.
  void add(const InitialSummary& other);
};

/// One contact definition and what was found in it.
struct ContactSummary {
  std::int64_t id = 0;
  std::uint32_t order = 0;  ///< place in the deck, from 1
  std::string title;        ///< empty: none
  std::string keyword;      ///< "CONTACT_AUTOMATIC_SINGLE_SURFACE"
  std::string type;         ///< solver's code: "13", "a3"
  std::uint64_t tracked_nodes = 0, segments = 0;
  std::uint64_t penetrations = 0, released = 0, edge_zone = 0;
  double max_penetration = 0;  ///< of `penetrations`
  std::uint64_t segment_penetrations = 0, mortar_penetrations = 0, edge_penetrations = 0;
  std::uint64_t ties = 0, untied = 0;
  std::uint64_t out_of_reach = 0;  ///< tracked nodes of parts and segments that are too far away to be meant to tie
  std::vector<std::int64_t> nodes_out_of_reach;   ///< their ids, ascending
  std::uint64_t reported_penetrations = 0;        ///< a count given in the files without a list of nodes (MPP); 0: none
  std::optional<InitialSummary> initial_summary;  ///< of the solver's files; none: they have none
  double contact_time_s = -1;                     ///< CPU seconds spent in it; negative: unknown
  std::string not_checked;                        ///< why neither penetrations nor ties were decided; empty: they were
  std::uint64_t judged_nearest = 0;  ///< nodes and edges that meet too many others: compared to the nearest only
  bool ties_judged = false;          ///< of a deck: its nodes were judged as ties, not as penetrations
  bool by_segments = false;          ///< judged segment against segment: the solver lists no nodes of it
  std::string file;
  std::uint32_t line = 0;
};

/// Adds one record to the contact's numbers.
void count(const Penetration& record, ContactSummary& contact);
/// Resets those numbers.
void clear_counts(ContactSummary& contact);

struct ModelCounts {
  std::uint64_t nodes = 0, shells = 0, solids = 0, beams = 0, thick_shells = 0, discrete = 0, masses = 0, particles = 0,
                parts = 0, contacts = 0;
};

struct Timing {
  double read_s = 0, model_s = 0, surface_s = 0, search_s = 0, total_s = 0;
};

/// Severities that replace those of the rules, by rule id.
using Severities = std::map<std::string, Severity, std::less<>>;

/// Everything that one source (deck, messag, run) reports; all views and writers work on it.
struct Report {
  std::string source;                       ///< "deck"
  std::string input;                        ///< as given by the user
  std::vector<std::string> as_if;           ///< values that replaced the deck's: "SST=0.5"
  std::vector<std::int64_t> unknown_parts;  ///< of --part: ids that the deck does not have
  std::string settings;                     ///< path of the settings file that was used; empty: none
  std::string page;                         ///< of --html, for links to its findings; empty: none was written
  Severities severities;                    ///< of the records; `findings` already have theirs
  std::vector<std::string> files;           ///< what Penetration::file points into
  ModelCounts model;
  std::vector<ContactSummary> contacts;        ///< in deck order
  std::vector<Penetration> penetrations;       ///< by contact, deepest first, then node id
  std::vector<TieFailure> tie_failures;        ///< by contact, reason, node id
  std::vector<Finding> findings;               ///< by id; of one rule as it found them
  Ignored ignored;                             ///< what was found and left out on purpose
  std::optional<BaselineComparison> baseline;  ///< only if the findings were compared with one
  std::optional<SolverRun> run;                ///< only where solver files were read
  std::optional<Portability> portability;      ///< only where it was asked for
  std::optional<Timesteps> predicted;          ///< time steps computed from a deck, if a rule asked for them
  std::vector<std::pair<std::string, std::string>> statistics;  ///< for --stats, in order of printing
  Timing timing;
  std::optional<SceneMesh> scene;   ///< only where it was asked for
  std::vector<NodeMove> moves;      ///< nodes that pictures show before and after, by id
  std::string said_of_moves;        ///< of these, for a reader: "32 nodes move by at most 0.2078"
  std::optional<ElementMesh> mesh;  ///< only where it was asked for
  std::int64_t highest_set = 0;     ///< largest id of a set of the deck; 0: none, or no deck was read
};

}  // namespace gapcheck
