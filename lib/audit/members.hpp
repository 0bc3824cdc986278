#pragma once
#include <functional>
#include <vector>

#include "audit/grouped.hpp"
#include "audit/rule.hpp"

namespace gapcheck::audit {

/// The segment by the ids of its nodes.
void add_segment(const model::Nodes& nodes, const model::SegmentNodes& segment, FindingMembers& members);

/// The collector for add_grouped(); empty unless AuditOptions::members asks for it. `segments(found, add)` calls
/// add(nodes) for each segment of one thing. The context must outlive it.
using SegmentsOf = std::function<void(const Found&, const std::function<void(const model::SegmentNodes&)>& add)>;
[[nodiscard]] Collect collect_segments(const Context& context, SegmentsOf segments);
/// The same for things that are one node each.
[[nodiscard]] Collect collect_nodes(const Context& context, std::function<NodeIndex(const Found&)> node);

/// Findings that list nothing but name elements get their segments: shells and beams themselves, all faces of solids
/// and thick shells. Elements of several kinds with the same id are all taken if they belong to a part that the finding
/// names, or if it names none.
void add_named_elements(const model::Model& model, std::vector<Finding>& findings);

}  // namespace gapcheck::audit
