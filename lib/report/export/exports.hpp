#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "base/vector.hpp"
#include "records/report.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {

/// Coordinates of a node for records without their own (tie failures, MPP lines). May be empty: none are known. Several
/// threads may call it.
using NodePosition = std::function<std::optional<Vector>(std::int64_t node)>;

/// Keyword file with one beam per penetration: first node where the tracked node is, second one on the contact surface,
/// so its length is the penetration. One *PART per interface and warning type, with a descriptive title, and one set of
/// the tracked nodes themselves, which only the model defines. New ids start above every id of the report; with more
/// than 8 digits the file is in long format. Records that cannot be drawn are in the sets, with a comment.
/// Passed on in pieces of about a megabyte.
void keyword_beams(const Report& report, const NodePosition& position, const Sink& sink);
[[nodiscard]] std::string keyword_beams(const Report& report, const NodePosition& position);

/// Keyword file with one *SET_NODE_LIST_TITLE and one *SET_SEGMENT_TITLE per rule and contact, if its findings name
/// nodes or segments; both have the same id. Nodes: tracked nodes of penetrations, nodes of ties, nodes that other
/// findings name or list, or if they name none the corners of their segments. Segments: those with penetrations, and
/// those that other findings list (Finding::members). Anything with fewer than three corners is in the node set. Ids
/// count up from `first_id`, or where that is 0 from above the deck's sets (without a deck: above every id of the
/// report). With ids of more than ten digits the file is in long format. Findings in no set are counted in comments.
[[nodiscard]] std::string keyword_sets(const Report& report, std::int64_t first_id);

/// Session file for Animator 3 (`ide nod …`) or Animator 4 (`sel nod …` with groups `id<sid> <warn-type>`).
[[nodiscard]] std::string animator_session(const Report& report, bool animator4);

/// Medina protocol: the tracked nodes and new nodes at the other end of each penetration, numbered from `first_node`
/// (lower where that many numbers do not exist above it).
[[nodiscard]] std::string medina_protocol(const Report& report, const NodePosition& position, std::int64_t first_node);

}  // namespace gapcheck::report
