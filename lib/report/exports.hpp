#pragma once
#include <functional>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "base/vector.hpp"
#include "records/report.hpp"

namespace gapcheck::report {

/// Coordinates of a node, where a record itself has none (tie failures, MPP lines).
using NodePosition = std::function<std::optional<Vector>(std::int64_t node)>;

/// Keyword file with one beam per penetration: first node where the tracked node is, second one on the contact surface,
/// so that its length is the penetration. One *PART per interface and warning type, with a speaking title. New node and
/// element ids start above every id of the report.
[[nodiscard]] std::string keyword_beams(const Report& report, const NodePosition& position);

/// Session file for Animator 3 (`ide nod …`) or Animator 4 (`sel nod …` with groups `id<sid> <warn-type>`).
[[nodiscard]] std::string animator_session(const Report& report, bool animator4);

/// Medina protocol: the tracked nodes and new nodes at the other end of each penetration, numbered from `first_node`.
[[nodiscard]] std::string medina_protocol(const Report& report, const NodePosition& position, std::int64_t first_node);

}  // namespace gapcheck::report
