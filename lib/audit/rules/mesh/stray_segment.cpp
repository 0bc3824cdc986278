#include <fmt/format.h>

#include <limits>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"

namespace gapcheck::audit::rule::stray_segment {
namespace {

void run(const RuleIdentity& rule, Context& context, Report& report) {
  contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh == nullptr) return;
  std::vector<Found> found = find_all(mesh->size(), [&](std::size_t i, std::vector<Found>& list) {
    if (mesh->element(i) == std::numeric_limits<std::uint32_t>::max() && context.part_chosen(none<PartIndex>))
      list.push_back({mesh->contact(i).value, 0, i});
  });
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        Finding at =
            segment_finding(rule, context, *mesh, f.item,
                            fmt::format("{} is not a face of any element: it has no material and no thickness, so "
                                        "contact gives it no stiffness; make the set from the elements' faces anew",
                                        segment_name(*mesh, f.item)));
        at.node = context.model().mesh.nodes.id[mesh->nodes(f.item)[0].value];
        return at;
      },
      [&](const Found& f, std::uint64_t count) {
        return segments_finding(rule, context, *mesh, f.item,
                                fmt::format("{} more segments of this contact are not faces of any element", count));
      },
      collect_segments(context, [&](const Found& f, const auto& add) { add(mesh->nodes(f.item)); }));
}

}  // namespace

const Rule definition{
    {"GC509", "stray-segment", Severity::warning, "a segment of a contact's segment set belongs to no element",
     Need::surfaces, "The contact acts on a surface that belongs to nothing"},
    run};

}  // namespace gapcheck::audit::rule::stray_segment
