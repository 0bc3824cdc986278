#pragma once
#include <cstdint>
#include <gapcheck/audit.hpp>
#include <gapcheck/report.hpp>
#include <gapcheck/result.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gapcheck::api {

/// Shells that never were a deck, and one contact between them. The arrays are read during the call only.
struct ShellMesh {
  std::span<const double> points = {};                 ///< n × 3, row by row, -1e30 to 1e30
  std::span<const std::int64_t> shells = {};           ///< m × 4 rows of `points`, from 0; a triangle repeats its last
  std::span<const std::int64_t> parts = {};            ///< m ids, 1 or more; empty: all shells belong to part 1
  double thickness = 0;                                ///< of all parts, above 0
  std::map<std::int64_t, double> part_thickness = {};  ///< by part id, where it is another one
  /// Keyword after *CONTACT_, of a type without cards of its own; empty: an automatic single surface.
  std::string contact = {};
  /// Ids of the parts that the contact names on either side; empty: all parts. A single surface has one side,
  /// `tracked`.
  std::vector<std::int64_t> tracked = {}, reference = {};
};

/// The keyword deck of these shells: ids of nodes and shells are their rows plus 1, numbers keep all digits, the
/// material of all parts is steel in mm, t and s. Errors, each with the array and the row: arrays whose lengths do not
/// match, corners beyond the rows of `points`, coordinates that are not finite or out of range, thicknesses that are
/// not above 0, parts without shells, a contact that needs more than its surfaces.
[[nodiscard]] Result<std::string> shell_deck(const ShellMesh& mesh);

/// Audits that deck. Files and lines of the report are those of shell_deck(), under the name "arrays".
///
///     const std::vector<double> points{0, 0, 0, 9, 0, 0, 9, 9, 0, 0, 0, 0.5, 9, 0, 0.5, 9, 9, 0.5};
///     const std::vector<std::int64_t> shells{0, 1, 2, 2, 3, 4, 5, 5};
///     const auto report = gapcheck::api::audit_arrays({.points = points, .shells = shells, .thickness = 0.8});
[[nodiscard]] Result<Report> audit_arrays(const ShellMesh& mesh, const AuditOptions& options = {});

}  // namespace gapcheck::api
