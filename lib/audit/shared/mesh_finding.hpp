#pragma once
#include <mutex>
#include <string>
#include <vector>

#include "audit/grouped.hpp"
#include "audit/rule.hpp"
#include "base/parallel.hpp"
#include "contact/surface/contact_mesh.hpp"

namespace gapcheck::audit {

/// The segments in contact; nullptr (and a word in --stats) where there are none.
[[nodiscard]] contact::ContactMesh* mesh_in_contact(const RuleIdentity& rule, Context& context);

/// "shell 12", "face 1 2 3 4 of solid 7", "segment 1 2 3 4".
[[nodiscard]] std::string segment_name(const contact::ContactMesh& mesh, std::size_t segment);

/// " of part 3", or nothing.
[[nodiscard]] std::string of_part(const contact::ContactMesh& mesh, std::size_t segment);

/// The segment's part is of *MAT_FABRIC.
[[nodiscard]] bool of_fabric(const contact::ContactMesh& mesh, std::size_t segment);

/// A finding with the element, part, middle and place of a segment, and the first contact that has it.
[[nodiscard]] Finding segment_finding(const RuleIdentity& rule, const Context& context,
                                      const contact::ContactMesh& mesh, std::size_t segment, std::string message);

/// The finding for the rest of a group: its part and contact, no element.
[[nodiscard]] Finding segments_finding(const RuleIdentity& rule, const Context& context,
                                       const contact::ContactMesh& mesh, std::size_t segment, std::string message);

/// A finding with the id and place of a node.
[[nodiscard]] Finding node_finding(const RuleIdentity& rule, const Context& context, NodeIndex node,
                                   std::string message);

/// Groups by the part of the segment.
[[nodiscard]] inline std::int64_t part_group(const contact::ContactMesh& mesh, std::size_t segment) {
  const PartIndex part = mesh.part(segment);
  return part == none<PartIndex> ? -1 : static_cast<std::int64_t>(part.value);
}

/// Calls judge(i, found) for i in [0, count) on many threads; returns everything put into `found`, in no order.
template <class Judge>
std::vector<Found> find_all(std::size_t count, const Judge& judge) {
  std::vector<Found> all;
  std::mutex mutex;
  parallel_for(count, 8192, [&](std::size_t begin, std::size_t end) {
    std::vector<Found> found;
    for (std::size_t i = begin; i < end; ++i) judge(i, found);
    if (found.empty()) return;
    const std::scoped_lock lock(mutex);
    all.insert(all.end(), found.begin(), found.end());
  });
  return all;
}

}  // namespace gapcheck::audit
