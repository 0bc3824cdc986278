#include "contact/pair/orientation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "contact/pair/closest_segment.hpp"
#include "geometry/batch/plane_band.hpp"

namespace gapcheck::contact {

bool solver_turns(const model::Controls& controls, std::int64_t surface_type) {
  constexpr auto first_of_parts = static_cast<std::int64_t>(model::SurfaceType::part_set);
  if (controls.orien == 0) return false;
  return controls.orien >= 2 || surface_type >= first_of_parts;
}

std::vector<bool> flipped_segments(const PairScene& scene, const CandidateSearch& search) {
  const Segments& s = scene.segments;
  const auto turns = [&](SegmentIndex i) {
    return s.element_kind[i.value] == model::ElementKind::shell && scene.oriented(i);
  };
  const Positions all = positions<SegmentIndex>(s.size());
  bool any = false;
  for (const SegmentIndex i : all)
    if ((any = turns(i))) break;
  if (!any || !solver_turns(scene.model.controls, scene.surface_type)) return {};
  // One vote count per part; the last one is for segments without a known part.
  std::vector<std::atomic<std::int64_t>> votes(scene.model.parts.size() + 1);
  const auto ballot = [&](SegmentIndex i) -> std::atomic<std::int64_t>& {
    const PartIndex part = part_of(scene.model.mesh, s, i.value);
    return votes[part == none<PartIndex> ? votes.size() - 1 : part.value];
  };
  SweepCounters unused;
  for_each_candidate(
      scene, search,
      [&](SegmentIndex i) {
        if (!turns(i)) return 0.0;
        const geometry::Facet f = scene.facet(i);
        return std::sqrt(std::max((f.x[2] - f.x[0]).squaredNorm(), (f.x[3] - f.x[1]).squaredNorm()));
      },
      unused,
      [&](SegmentIndex segment, std::span<const SlotIndex> slots) {
        if (!turns(segment)) return;
        const geometry::Facet facet = scene.facet(segment);
        const geometry::PlaneBand face(facet, 0);
        for (const SlotIndex slot : slots) {
          const Vector query = scene.position(slot);
          if (face.usable() && face.outside(query)) continue;
          // Where two meshes are alike, all nodes are straight above corners: the border counts.
          const auto closest = geometry::closest_point(facet, query, 0);
          // A node that a tie has moved onto the surface is on neither side of it, whatever rounding says.
          const bool beside = std::abs(closest.gap) > default_tolerance(0, largest_coordinate(facet, query));
          if (closest.in_band && beside) ballot(segment) += closest.gap > 0 ? 1 : -1;
        }
      });
  std::vector<bool> flipped(s.size(), false);
  for (const SegmentIndex i : all) flipped[i.value] = turns(i) && ballot(i) < 0;
  return flipped;
}

}  // namespace gapcheck::contact
