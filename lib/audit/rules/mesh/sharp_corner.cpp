#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"

namespace gapcheck::audit::rule::sharp_corner {
namespace {

/// Degrees remaining between two segments with a common edge: they are folded by 180 less this.
constexpr std::array thresholds{
    Threshold{"angle", 30, 0, 60, "degrees between two segments, below which they are listed"}};

/// The mean of a segment's corners that are not on the edge, seen from the edge's first end.
Vector inward(const model::SegmentNodes& n, NodeIndex a, NodeIndex b, const std::vector<Vector>& x) {
  Vector sum = Vector::Zero();
  for (const NodeIndex corner : n)
    if (corner != a && corner != b) sum += x[corner.value] - x[a.value];
  return sum;
}

/// Cosine of the angle between two segments at a common edge: 1 if they lie on each other, -1 if they are flat.
double cosine_at_edge(const contact::ContactMesh& mesh, std::size_t i, std::size_t j, NodeIndex a, NodeIndex b) {
  const std::vector<Vector>& x = mesh.model().mesh.nodes.x;
  const Vector edge = x[b.value] - x[a.value];
  Vector p = inward(mesh.nodes(i), a, b, x), q = inward(mesh.nodes(j), a, b, x);
  const double squared_edge = edge.squaredNorm();
  if (!(squared_edge > 0)) return -1;
  p -= p.dot(edge) / squared_edge * edge;
  q -= q.dot(edge) / squared_edge * edge;
  const double dot = p.dot(q);
  return dot > 0 ? dot / std::sqrt(p.squaredNorm() * q.squaredNorm()) : -1;
}

/// Two segments on the same corners: a shell on the face of a solid.
bool same_corners(const model::SegmentNodes& p, const model::SegmentNodes& q) {
  return std::all_of(p.begin(), p.end(), [&](NodeIndex n) { return std::find(q.begin(), q.end(), n) != q.end(); });
}

/// The shape of a tool or barrier is meant, and stays as it is.
bool rigid(const model::Model& model, PartIndex part) { return part != none<PartIndex> && model.rigid(part); }

double degrees(double cosine) { return std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi; }

void run(const RuleIdentity& rule, Context& context, Report& report) {
  contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh == nullptr) return;
  const auto& quality = mesh->quality();
  mesh->build_edges();
  const double least_angle = context.threshold(rule, thresholds[0]);
  const double limit = std::cos(least_angle * std::numbers::pi / 180);
  std::vector<Found> found =
      find_all(context.model().mesh.nodes.size(), [&](std::size_t node, std::vector<Found>& list) {
        const auto uses = mesh->edges_at(node);
        const NodeIndex a{static_cast<std::uint32_t>(node)};
        for (std::size_t k = 0; k < uses.size(); ++k)
          for (std::size_t m = k + 1; m < std::min(uses.size(), k + contact::most_uses); ++m) {
            if (uses[k].other != uses[m].other) continue;
            const std::size_t i = uses[k].segment, j = uses[m].segment;
            if (quality[i].fault != contact::SegmentFault::none || quality[j].fault != contact::SegmentFault::none)
              continue;
            const double cosine = cosine_at_edge(*mesh, i, j, a, uses[k].other);
            if (!(cosine > limit) || same_corners(mesh->nodes(i), mesh->nodes(j))) continue;
            // Ties look for a node's segment once, at the start; fabric is folded on purpose, at its seams sharply.
            if (mesh->only_tied(i) || mesh->only_tied(j) || (of_fabric(*mesh, i) && of_fabric(*mesh, j))) continue;
            const PartIndex p = mesh->part(i), q = mesh->part(j);
            if (rigid(context.model(), p) && rigid(context.model(), q)) continue;
            if (context.part_chosen(p) || context.part_chosen(q))
              list.push_back({part_pair(p, q), cosine, static_cast<std::uint64_t>(i) << 32 | j});
          }
      });
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const std::size_t i = f.item >> 32, j = f.item & 0xFFFFFFFFU;
        return segment_finding(
            rule, context, *mesh, i,
            fmt::format("{}{} and {}{} meet at {:.1f} degrees (below {}): contact finds no clear side in "
                        "so sharp a corner; round it with a row of elements",
                        segment_name(*mesh, i), of_part(*mesh, i), segment_name(*mesh, j), of_part(*mesh, j),
                        degrees(f.weight), least_angle));
      },
      [&](const Found& f, std::uint64_t count) {
        return segments_finding(rule, context, *mesh, f.item >> 32,
                                fmt::format("{} more pairs of segments{} meet at less than {} degrees, down to {:.1f}",
                                            count, of_part(*mesh, f.item >> 32), least_angle, degrees(f.weight)));
      },
      collect_segments(context, [&](const Found& f, const auto& add) {
        add(mesh->nodes(f.item >> 32));
        add(mesh->nodes(f.item & 0xFFFFFFFFU));
      }));
}

}  // namespace

const Rule definition{
    .identity = {"GC512", "sharp-corner", Severity::note, "two segments in contact fold onto each other at an edge",
                 Need::surfaces, "Nodes near the fold jump between its two sides"},
    .run = run,
    .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::sharp_corner
