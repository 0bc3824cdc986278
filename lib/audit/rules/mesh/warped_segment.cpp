#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"

namespace gapcheck::audit::rule::warped_segment {
namespace {

/// Mesh checks of pre-processors warn between 5 and 20; contact bears more than the element itself.
constexpr std::array thresholds{
    Threshold{"angle", 20, 0, 180, "degrees between the two triangles of a quad, above which it is listed"}};

void run(const RuleIdentity& rule, Context& context, Report& report) {
  contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh == nullptr) return;
  const auto& quality = mesh->quality();
  const double largest_warp = context.threshold(rule, thresholds[0]);
  const auto limit = static_cast<float>(std::cos(largest_warp * std::numbers::pi / 180));
  std::vector<Found> found = find_all(mesh->size(), [&](std::size_t i, std::vector<Found>& list) {
    const contact::SegmentQuality& q = quality[i];
    if (q.fault != contact::SegmentFault::none || !(q.warp_cosine < limit) || of_fabric(*mesh, i))
      return;  // folded fabric has no shape that could be corrected
    if (context.part_chosen(mesh->part(i)))
      list.push_back({part_group(*mesh, i), -static_cast<double>(q.warp_cosine), i});
  });
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        return segment_finding(
            rule, context, *mesh, f.item,
            fmt::format("{}{} is warped by {:.1f} degrees; more than {} leave open on which side of it a node "
                        "is: split it into triangles or remesh",
                        segment_name(*mesh, f.item), of_part(*mesh, f.item), contact::warp_degrees(quality[f.item]),
                        largest_warp));
      },
      [&](const Found& f, std::uint64_t count) {
        return segments_finding(
            rule, context, *mesh, f.item,
            fmt::format("{} more segments{} are warped by more than {} degrees, up to {:.1f}", count,
                        of_part(*mesh, f.item), largest_warp, contact::warp_degrees(quality[f.item])));
      },
      collect_segments(context, [&](const Found& f, const auto& add) { add(mesh->nodes(f.item)); }));
}

}  // namespace

const Rule definition{
    .identity = {"GC504", "warped-segment", Severity::warning, "a quadrilateral segment in contact is far from flat",
                 Need::surfaces, "Contact finds wrong distances on the warped segments"},
    .run = run,
    .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::warped_segment
