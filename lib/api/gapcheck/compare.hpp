#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gapcheck/includes.hpp>
#include <gapcheck/report.hpp>
#include <gapcheck/result.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gapcheck::api {

/// What is compared. The defaults are those of `gapcheck compare`. Tolerances are numbers of 0 or more; anything else
/// is an error.
struct CompareOptions {
  double tolerance = 0;                     ///< of depths, in the deck's unit, besides the rounding of printed numbers
  std::vector<std::int64_t> contacts = {};  ///< only the contacts with these ids; empty: all
  Includes includes = {};                   ///< of decks
  std::vector<std::string> message_tables = {};  ///< as RunReadOptions::message_tables
  bool curves = true;                            ///< compare the curves and d3plots of two directories
  double curve_tolerance = 1e-3;                 ///< share of the larger one by which curves and nodes may differ
  std::vector<std::string> curve_names = {};     ///< only curves with one of these texts in their name; empty: all
  std::size_t jobs = 0;                          ///< as AuditOptions::jobs
  /// Called now and then by the thread that works, which waits for it. False stops the comparison, which is an error
  /// then. It must not throw. Empty: no calls.
  std::function<bool()> watch = {};
};

/// How the records of one contact agree. Numbers of nodes, except for the difference of depths.
struct ContactComparison {
  std::int64_t id = 0;
  std::string title, type;
  std::uint64_t agree = 0, depth_differs = 0, only_first = 0, only_second = 0;
  double largest_difference = 0;                             ///< of depth
  bool missing_in_first = false, missing_in_second = false;  ///< the whole contact
  bool not_checked = false;    ///< one source did not decide it, so its records are not compared
  bool counts_only = false;    ///< one source lists no nodes: their numbers are compared
  bool ties_compared = false;  ///< both say which nodes stay untied
  std::uint64_t ties_agree = 0, ties_other_reason = 0, ties_only_first = 0, ties_only_second = 0;
};

/// A node whose penetration differs.
struct DepthDifference {
  std::int64_t contact = 0, node = 0;   ///< ids
  std::optional<double> first, second;  ///< depth; none: the source has no such penetration
};

/// A node that is untied in one source only, or for another reason.
struct TieDifference {
  std::int64_t contact = 0, node = 0;      ///< ids
  std::optional<TieReason> first, second;  ///< none: not untied in that source
};

/// How well one curve follows another by ISO/TS 18571; scores from 0 to 1, 1: the same curve.
struct CurveRating {
  double overall = 1, corridor = 1, phase = 1, magnitude = 1, slope = 1;
};

/// One curve that both runs have, compared at the times of both within their common range.
struct CurvePair {
  enum class Verdict : std::uint8_t { agrees, differs, no_common_times };

  std::string name;
  Verdict verdict = Verdict::agrees;
  double largest_first = 0, largest_second = 0;  ///< absolute values in the common range
  double largest_difference = 0, time = 0;       ///< largest |a - b|, and when
  double relative_difference = 0;                ///< the same over the larger of the two largest values
  double l2_difference = 0;           ///< square root of the integral of (a - b)², over the larger one of a² and b²
  std::optional<CurveRating> rating;  ///< of the second against the first; none where that is zero throughout
};

/// The curves of two runs.
struct CurveComparison {
  std::vector<CurvePair> pairs;  ///< those that differ first, then by relative difference, the largest first
  std::vector<std::string> only_first, only_second;  ///< names; for a file that only one run has, the file's name
  std::size_t agree = 0, differ = 0, without_common_times = 0;
};

/// How far the nodes of one part lie apart in two d3plots.
struct PartMotion {
  std::int64_t part = 0;                        ///< id; 0: nodes of no element
  std::size_t nodes = 0;                        ///< that both runs have
  double largest_distance = 0, time = 0;        ///< and when
  std::int64_t node = 0;                        ///< that lies so far apart
  std::vector<double> largest = {}, mean = {};  ///< distance at each of MotionComparison::times
  bool differs = false;
};

/// The nodes of two d3plots, part by part.
struct MotionComparison {
  std::vector<double> times;        ///< of the first one's states within the common range
  double largest_displacement = 0;  ///< of any node in either run
  std::vector<PartMotion> parts;    ///< largest distance first
  std::size_t differ = 0;           ///< parts
};

/// Holds what text() and json() write; not for use.
struct ComparisonStore;

/// Two compared sources. Copies share the data of the reports' views.
struct Comparison {
  bool equal = false;    ///< no difference in penetrations, ties, curves and motion
  bool complete = true;  ///< false: one of the sources could not be read in full; see the reports' diagnostics
  Report first, second;
  std::vector<ContactComparison> contacts;       ///< as in the first report, then those that only the second has
  std::vector<DepthDifference> differences;      ///< by contact, then the largest first
  std::vector<TieDifference> tie_differences;    ///< by contact, then by node id
  std::optional<CurveComparison> curves;         ///< only for two directories with result files
  std::optional<MotionComparison> motion;        ///< only for two directories with a d3plot
  std::shared_ptr<const ComparisonStore> store;  ///< what text() and json() work on
};

/// Compares two decks, two runs, or a deck and a run: penetrations and ties node by node, contacts by their ids; for
/// two directories also the curves and the motion of nodes. Each source is a keyword deck (by its extension .k, .key,
/// .dyn or its first line), a file of the solver or the directory of a run. A curve or a contact without records that
/// only one source has is not a difference. Errors: a source that cannot be read; an option that names no contact of
/// either source, no curve that both have or no valid number. May be called from several threads at once.
///
///     const auto comparison = gapcheck::api::compare("model.k", "out");
///     if (!comparison) return fail(comparison.error());
///     print(comparison.value().equal, comparison.value().differences.size());
[[nodiscard]] Result<Comparison> compare(const std::string& first, const std::string& second,
                                         const CompareOptions& options = {});

/// The comparison as `gapcheck compare` prints it. `top`: largest differences to list, per contact and of the curves.
[[nodiscard]] std::string text(const Comparison& comparison, std::size_t top = 10);
/// The same as JSON, complete.
[[nodiscard]] std::string json(const Comparison& comparison);

}  // namespace gapcheck::api
