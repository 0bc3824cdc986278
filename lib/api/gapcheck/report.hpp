#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <gapcheck/mesh.hpp>
#include <gapcheck/part_history.hpp>
#include <gapcheck/records.hpp>
#include <gapcheck/result.hpp>
#include <gapcheck/solver_run.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gapcheck::api {

/// One contact definition and what was found in it. Lengths in the deck's unit.
struct Contact {
  std::int64_t id = 0;
  std::uint32_t order = 0;  ///< position in the deck, from 1
  std::string title;        ///< empty: none
  std::string keyword;      ///< "CONTACT_AUTOMATIC_SINGLE_SURFACE"; empty: the source does not say
  std::string type;         ///< the solver's code: "13", "a3"
  std::uint64_t tracked_nodes = 0, segments = 0;
  std::uint64_t penetrations = 0;  ///< of kind initial
  double max_penetration = 0;      ///< of these
  std::uint64_t released = 0, edge_zone = 0, segment_penetrations = 0, mortar_penetrations = 0, edge_penetrations = 0;
  std::uint64_t ties = 0, untied = 0;
  std::uint64_t out_of_reach = 0;           ///< tracked nodes that are too far away to be meant to tie
  std::uint64_t reported_penetrations = 0;  ///< a count in the solver's files without a list of nodes (MPP); 0: none
  std::uint64_t judged_nearest = 0;  ///< nodes and edges within reach of too many others: only the nearest counted
  std::string not_checked;           ///< why neither penetrations nor ties were decided; empty: they were
  std::string file;                  ///< of the definition; empty: unknown
  std::uint32_t line = 0;
};

/// A finding that is not in the arrays of penetrations and ties: references, definitions, thickness, mesh, input, runs.
/// Ids of 0, negative lengths and an empty file: unknown, or without a meaning for the rule.
struct Finding {
  std::string id;    ///< "GC501"
  std::string rule;  ///< "duplicate-id"
  Severity severity = Severity::warning;
  std::string message;
  std::int64_t contact = 0;  ///< id
  std::int64_t node = 0, part = 0, element = 0, element_part = 0;
  double penetration = -1, contact_distance = -1;
  std::optional<std::array<double, 3>> point;  ///< where to look, in the deck's coordinates
  std::uint64_t count = 1;                     ///< more than 1: one line that represents that many things
  std::string file;
  std::uint32_t line = 0;
};

/// Numbers of findings by severity, penetrations and ties included.
struct Totals {
  std::size_t errors = 0, warnings = 0, notes = 0;
};

/// Size of a deck.
struct ModelCounts {
  std::uint64_t nodes = 0, shells = 0, solids = 0, beams = 0, thick_shells = 0, discrete = 0, masses = 0, particles = 0,
                parts = 0, contacts = 0;
};

/// Holds what the views of a report point into; not for use.
struct ReportStore;

/// Everything that one source reports: a deck that was audited, or the files of a run that were read. Copies share the
/// arrays; the views stay valid while one of the copies lives. Reading one report from several threads is safe.
///
///     const Penetrations& p = report.penetrations;
///     for (std::size_t i = 0; i < p.size(); ++i)
///       std::printf("%lld %g\n", static_cast<long long>(p.node[i]), p.depth[i]);
struct Report {
  std::string source;              ///< "deck" or "messag"
  std::string input;               ///< the path as it was given
  ModelCounts model;               ///< of decks; zeros: the model is not known
  std::vector<std::string> files;  ///< that were read; what the `file` arrays of penetrations and ties refer to
  std::vector<Contact> contacts;   ///< in deck order; what their `contact` arrays refer to
  Penetrations penetrations;       ///< by contact, deepest first, then by node id
  Ties ties;                       ///< by contact, reason, node id
  std::vector<Finding> findings;   ///< all others, by rule
  Totals totals;
  std::size_t ignored = 0;  ///< findings that the deck's comments leave out on purpose; they are in nothing above
  std::optional<Timesteps> predicted;  ///< computed from a deck, if a rule asked for them
  std::optional<SolverRun> run;        ///< only if solver files were read
  std::optional<PartHistory> parts;    ///< over the time of a run whose matsum was read
  std::optional<Mesh> mesh;            ///< of a deck, if AuditOptions::mesh was set
  /// False: the input could not be read in full; the report has what could be read. Then at least one diagnostic is an
  /// error.
  bool complete = true;
  std::vector<Diagnostic> diagnostics;       ///< about the input: errors first, then by file and line; at most 1000
  std::size_t diagnostics_left_out = 0;      ///< beyond these
  std::shared_ptr<const ReportStore> store;  ///< what write() works on
};

}  // namespace gapcheck::api
