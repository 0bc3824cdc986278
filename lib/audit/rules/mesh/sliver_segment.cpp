#include <fmt/format.h>

#include <array>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"
#include "model/entity/faces.hpp"

namespace gapcheck::audit::rule::sliver_segment {
namespace {

constexpr std::array thresholds{Threshold{"height", 0.05, 0, 1, "height over longest edge, below which it is listed"}};

/// The segment is a side of a thin brick, whose largest face is no sliver: thin as the body is, nothing to remesh.
bool side_of_thin_brick(const contact::ContactMesh& mesh, std::size_t segment, float least_slenderness) {
  const bool thick_shell = mesh.kind(segment) == model::ElementKind::thick_shell;
  if (mesh.element(segment) == no_position || (mesh.kind(segment) != model::ElementKind::solid && !thick_shell))
    return false;
  const model::Mesh& all = mesh.model().mesh;
  const auto& elements = thick_shell ? all.thick_shells : all.solids;
  contact::SegmentQuality largest;
  for (const model::SegmentNodes& face : model::SolidFaces(elements.nodes[mesh.element(segment)]))
    if (const auto q = contact::segment_quality(face, all.nodes.x); q.size > largest.size) largest = q;
  return largest.slenderness >= least_slenderness;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh == nullptr) return;
  const auto& quality = mesh->quality();
  const auto least_slenderness = static_cast<float>(context.threshold(rule, thresholds[0]));
  std::vector<Found> found = find_all(mesh->size(), [&](std::size_t i, std::vector<Found>& list) {
    const contact::SegmentQuality& q = quality[i];
    if (q.fault != contact::SegmentFault::none || !(q.slenderness < least_slenderness)) return;
    if (context.part_chosen(mesh->part(i)) && !side_of_thin_brick(*mesh, i, least_slenderness))
      list.push_back({part_group(*mesh, i), -static_cast<double>(q.slenderness), i});
  });
  const auto edge = [&](std::size_t i) {
    return contact::edge_range(mesh->nodes(i), context.model().mesh.nodes.x).longest;
  };
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const double longest = edge(f.item);
        return segment_finding(
            rule, context, *mesh, f.item,
            fmt::format("{}{} is a sliver: {:.3g} high and {:.3g} long, a ratio of {:.3g} (below {}); "
                        "collapse or remesh it",
                        segment_name(*mesh, f.item), of_part(*mesh, f.item), quality[f.item].slenderness * longest,
                        longest, quality[f.item].slenderness, least_slenderness));
      },
      [&](const Found& f, std::uint64_t count) {
        return segments_finding(
            rule, context, *mesh, f.item,
            fmt::format("{} more segments{} are slivers, down to a ratio of {:.3g} (below {})", count,
                        of_part(*mesh, f.item), quality[f.item].slenderness, least_slenderness));
      },
      collect_segments(context, [&](const Found& f, const auto& add) { add(mesh->nodes(f.item)); }));
}

}  // namespace

const Rule definition{
    .identity = {"GC506", "sliver-segment", Severity::warning, "a segment in contact is much longer than it is wide",
                 Need::surfaces, "Contact on the slivers is unstable, or needs a small step"},
    .run = run,
    .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::sliver_segment
