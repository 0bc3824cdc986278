#pragma once
#include "report/export/exports.hpp"
#include "report/export/vtu.hpp"

namespace gapcheck::report {

/// The elements of Report::mesh with the findings at them and at their nodes; nodes of findings that belong to no
/// element become vertices if their position is known (without a mesh: all of them).
///
/// Points: depth (0: none) and remaining (NaN: no penetration) of the deepest penetration, way_out (from the node to
/// the contact surface), move (with Report::moves: where the node goes), node, contact, outcome (0: none, 1 + Outcome,
/// 11 + TieReason), rule (101 for GC101, 0: none). Cells: thickness (in contact), depth of the deepest node in the
/// element, element, part, contact, rule. A node or element of several findings has the number of the rule that comes
/// first in the report. Words: input, outcomes, left_out (what could not be placed).
[[nodiscard]] VtuGrid finding_grid(const Report& report, const NodePosition& position);

}  // namespace gapcheck::report
