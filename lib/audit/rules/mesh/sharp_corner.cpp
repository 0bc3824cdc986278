#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

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

/// True if two segments surely meet at more than a right angle at the edge from `a`, which nearly all do: found without
/// telling their corners apart, since those on the edge do not count across it.
bool surely_open(const model::SegmentNodes& m, const model::SegmentNodes& n, const Vector& a, const Vector& edge,
                 const std::vector<Vector>& x) {
  Vector p = Vector::Zero(), q = Vector::Zero();
  for (std::size_t c = 0; c < 4; ++c) {
    p += x[m[c].value] - a;
    q += x[n[c].value] - a;
  }
  constexpr double margin = 1e-12;  // far more than the rounding of these products
  const double squared_edge = edge.squaredNorm();
  const double across = p.dot(q) * squared_edge - p.dot(edge) * q.dot(edge);
  return across < -margin * (p.squaredNorm() + q.squaredNorm()) * squared_edge;
}

/// Cosine of the angle between two segments at a common edge: 1 if they lie on each other, -1 if they are flat or meet
/// at more than a right angle.
double cosine_at_edge(const contact::ContactMesh& mesh, std::size_t i, std::size_t j, NodeIndex a, NodeIndex b) {
  const std::vector<Vector>& x = mesh.model().mesh.nodes.x;
  const Vector edge = x[b.value] - x[a.value];
  if (surely_open(mesh.nodes(i), mesh.nodes(j), x[a.value], edge, x)) return -1;
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

bool rigid(const model::Model& model, PartIndex part) { return part != none<PartIndex> && model.rigid(part); }

/// The nodes of deformable segments, in cubes that are not smaller than any distance that is asked for.
class DeformableNodes {
 public:
  DeformableNodes(const contact::ContactMesh& mesh, double cube) : x_(mesh.model().mesh.nodes.x), cube_(cube) {
    std::vector<std::uint8_t> seen(x_.size());
    for (std::size_t s = 0; s < mesh.size(); ++s) {
      if (rigid(mesh.model(), mesh.part(s))) continue;
      for (const NodeIndex n : mesh.nodes(s))
        if (std::exchange(seen[n.value], std::uint8_t{1}) == 0)
          if (const auto key = cube_of(x_[n.value])) in_[*key].push_back(n);
    }
  }

  /// Whether one that is not a corner of these segments is nearer to the point than `distance`.
  [[nodiscard]] bool near(const Vector& point, double distance, const model::SegmentNodes& p,
                          const model::SegmentNodes& q) const {
    const auto corner = [](const model::SegmentNodes& s, NodeIndex n) {
      return std::find(s.begin(), s.end(), n) != s.end();
    };
    const auto key = cube_of(point);
    if (!key) return false;
    for (int k = 0; k < 27; ++k) {
      const auto found = in_.find({(*key)[0] + k % 3 - 1, (*key)[1] + k / 3 % 3 - 1, (*key)[2] + k / 9 - 1});
      if (found == in_.end()) continue;
      for (const NodeIndex n : found->second)
        if ((x_[n.value] - point).norm() < distance && !corner(p, n) && !corner(q, n)) return true;
    }
    return false;
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  [[nodiscard]] std::optional<Key> cube_of(const Vector& point) const {
    constexpr double most = 1e15;  // exact as an integer, with room for neighbours
    Key key;
    for (int i = 0; i < 3; ++i) {
      const double at = std::floor(point[i] / cube_);
      if (!(std::abs(at) < most)) return std::nullopt;
      key[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(at);
    }
    return key;
  }

  const std::vector<Vector>& x_;
  double cube_;
  std::map<Key, std::vector<NodeIndex>> in_;
};

/// A pair of segments, as Found::item holds it.
struct Pair {
  explicit Pair(const Found& f) : i(f.item >> 32), j(f.item & 0xFFFFFFFFU) {}
  std::size_t i, j;
};

/// The shape of a tool or barrier is meant, and stays as it is: it matters where something deformable is about to meet
/// it, nearer than the segments are long.
void drop_rigid_far_from_all(const contact::ContactMesh& mesh, std::vector<Found>& found) {
  const std::vector<Vector>& x = mesh.model().mesh.nodes.x;
  const auto both_rigid = [&](const Pair& p) {
    return rigid(mesh.model(), mesh.part(p.i)) && rigid(mesh.model(), mesh.part(p.j));
  };
  const auto reach = [&](const Pair& p) {
    return std::max(contact::edge_range(mesh.nodes(p.i), x).longest, contact::edge_range(mesh.nodes(p.j), x).longest);
  };
  double most = 0;
  for (const Found& f : found)
    if (const Pair p(f); both_rigid(p)) most = std::max(most, reach(p));
  if (!(most > 0)) return;
  const DeformableNodes nodes(mesh, most);
  std::erase_if(found, [&](const Found& f) {
    const Pair p(f);
    if (!both_rigid(p)) return false;
    Vector middle = Vector::Zero();
    int common = 0;
    for (const NodeIndex n : mesh.nodes(p.i)) {
      const model::SegmentNodes& other = mesh.nodes(p.j);
      if (std::find(other.begin(), other.end(), n) == other.end()) continue;
      middle += x[n.value];
      ++common;
    }
    return common == 0 || !nodes.near(middle / common, reach(p), mesh.nodes(p.i), mesh.nodes(p.j));
  });
}

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
            if (context.part_chosen(p) || context.part_chosen(q))
              list.push_back({part_pair(p, q), cosine, static_cast<std::uint64_t>(i) << 32 | j});
          }
      });
  drop_rigid_far_from_all(*mesh, found);
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const auto [i, j] = Pair(f);
        return segment_finding(
            rule, context, *mesh, i,
            fmt::format("{}{} and {}{} meet at {:.1f} degrees (below {}): contact finds no clear side in "
                        "so sharp a corner; round it with a row of elements",
                        segment_name(*mesh, i), of_part(*mesh, i), segment_name(*mesh, j), of_part(*mesh, j),
                        degrees(f.weight), least_angle));
      },
      [&](const Found& f, std::uint64_t count) {
        return segments_finding(rule, context, *mesh, Pair(f).i,
                                fmt::format("{} more pairs of segments{} meet at less than {} degrees, down to {:.1f}",
                                            count, of_part(*mesh, Pair(f).i), least_angle, degrees(f.weight)));
      },
      collect_segments(context, [&](const Found& f, const auto& add) {
        add(mesh->nodes(Pair(f).i));
        add(mesh->nodes(Pair(f).j));
      }));
}

}  // namespace

const Rule definition{
    .identity = {"GC512", "sharp-corner", Severity::note, "two segments in contact fold onto each other at an edge",
                 Need::surfaces, "Nodes near the fold jump between its two sides"},
    .run = run,
    .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::sharp_corner
