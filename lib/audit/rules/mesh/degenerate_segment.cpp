#include <fmt/format.h>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"

namespace gapcheck::audit::rule::degenerate_segment {
namespace {

using contact::SegmentFault;

std::string_view what_is_wrong(SegmentFault fault) {
  switch (fault) {
    case SegmentFault::none:
      break;
    case SegmentFault::not_finite:
      return "has a corner without finite coordinates; correct the node or its transformation";
    case SegmentFault::few_nodes:
      return "has fewer than three different nodes; delete it";
    case SegmentFault::zero_area:
      return "has no area: its corners lie on one line; delete it or move its nodes";
    case SegmentFault::crossed:
      return "crosses itself (bow-tie); write its nodes in the order of its outline";
    case SegmentFault::folded:
      return "is an arrowhead: one corner turns inward by more than 180 degrees; split it into triangles";
    case SegmentFault::repeated_node:
      return "repeats a node, but not the third one; write it as a triangle with the fourth node equal to the third";
  }
  return "";
}

/// The solver copes with these, though not well.
bool bearable(SegmentFault fault) { return fault == SegmentFault::folded || fault == SegmentFault::repeated_node; }

void run(const RuleIdentity& rule, Context& context, Report& report) {
  contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh == nullptr) return;
  const auto& quality = mesh->quality();
  std::vector<Found> found = find_all(mesh->size(), [&](std::size_t i, std::vector<Found>& list) {
    const SegmentFault fault = quality[i].fault;
    if (fault == SegmentFault::none || !context.part_chosen(mesh->part(i))) return;
    // One group for each part and fault, so that no kind of fault hides another.
    list.push_back({part_group(*mesh, i) * 8 + static_cast<std::int64_t>(fault), 0, i});
  });
  const auto severe = [&](Finding f, std::size_t i) {
    if (bearable(quality[i].fault)) f.severity = Severity::warning;
    return f;
  };
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        return severe(segment_finding(rule, context, *mesh, f.item,
                                      fmt::format("{}{} {}", segment_name(*mesh, f.item), of_part(*mesh, f.item),
                                                  what_is_wrong(quality[f.item].fault))),
                      f.item);
      },
      [&](const Found& f, std::uint64_t count) {
        return severe(segments_finding(rule, context, *mesh, f.item,
                                       fmt::format("{} more segments{} like {}: each {}", count, of_part(*mesh, f.item),
                                                   segment_name(*mesh, f.item), what_is_wrong(quality[f.item].fault))),
                      f.item);
      },
      collect_segments(context, [&](const Found& f, const auto& add) { add(mesh->nodes(f.item)); }));
}

}  // namespace

const Rule definition{
    {"GC505", "degenerate-segment", Severity::error, "a segment in contact has no area, crosses itself or is folded",
     Need::surfaces, "Contact finds no direction on the segment"},
    run};

}  // namespace gapcheck::audit::rule::degenerate_segment
