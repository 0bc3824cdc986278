#include "contact/ties.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "contact/closest_segment.hpp"

namespace gapcheck::contact {
namespace {

constexpr double thickness_share = 0.6, diagonal_share = 0.05;  // [workshop]
/// PARMAX of tied contacts (MPP default).
constexpr double default_parmax = 1.035;

struct Candidate {
  std::uint32_t slot, segment;
  double distance;
};

double min_diagonal(const geometry::Facet& f) {
  return std::sqrt(std::min((f.x[2] - f.x[0]).squaredNorm(), (f.x[3] - f.x[1]).squaredNorm()));
}

bool moves_node(const ContactType& type) { return type.code == "2" || type.code == "6" || type.code == "7"; }

bool solid(const Segments& s, std::uint32_t i) {
  return s.element_kind[i] == model::ElementKind::solid || s.element_kind[i] == model::ElementKind::thick_shell;
}

}  // namespace

double tie_distance(double node_thickness, double segment_thickness, double diagonal, bool solid_segment,
                    bool negative_thickness) {
  const double d1 = thickness_share * (node_thickness + segment_thickness);
  const double d2 = diagonal_share * diagonal;
  if (negative_thickness) return d1;
  return solid_segment ? d2 : std::max(d1, d2);
}

void Ties::add(NodeIndex node, PartIndex part) { parts_[node.value].push_back(part); }

bool Ties::tied(NodeIndex node, PartIndex part) const {
  const auto found = parts_.find(node.value);
  if (found == parts_.end()) return false;
  return std::find(found->second.begin(), found->second.end(), part) != found->second.end();
}

std::uint64_t apply_ties(const model::Model& model, const model::Contact& contact, const ContactType& type,
                         const CandidateSearch& search, std::vector<Vector>& x,
                         Ties& ties) {
  // Ties measure from the mid-surface with the true thickness, whatever SHLTHK says.
  const ContactSettings all_thickness{.shlthk = 2};
  Selection a = select(model, contact.a, type, x);
  fill_thickness(a.segments, model, thickness_side(contact, all_thickness, model.controls, false), x);
  Selection b = select(model, contact.b, type, x);
  if (b.segments.size() == 0) return 0;
  fill_thickness(b.segments, model, thickness_side(contact, all_thickness, model.controls, true), x);
  const TrackedNodes nodes =
      tracked_nodes(a, model, thickness_side(contact, all_thickness, model.controls, false), x);
  const Neighbours neighbours(b.segments, model.mesh);
  PairScene scene{model, contact, type, all_thickness, x, b.segments, nodes, neighbours, {}, {}};
  const bool negative = contact.sst < 0 || contact.mst < 0;
  const double parmax = contact.parmax > 0 ? contact.parmax : contact.maxpar > 0 ? contact.maxpar : default_parmax;
  double largest_half = 0;
  for (const double half : nodes.half) largest_half = std::max(largest_half, half);
  const auto limit = [&](double node_half, std::uint32_t s) {
    return tie_distance(2 * node_half, 2 * b.segments.half[s], min_diagonal(scene.facet(s)), solid(b.segments, s), negative);
  };
  std::mutex mutex;
  std::vector<Candidate> candidates;
  SweepCounters sweep;
  for_each_candidate(
      scene, search, [&](std::uint32_t s) { return limit(largest_half, s); }, sweep,
      [&](std::uint32_t segment, std::span<const std::uint32_t> slots) {
        if (scene.line(segment)) return;
        const geometry::Facet facet = scene.facet(segment);
        for (const std::uint32_t slot : slots) {
          const Vector& q = x[nodes.node[slot].value];
          const auto closest = geometry::closest_point(facet, q, parmax - 1);
          if (!closest.in_band) continue;
          const double bound = limit(nodes.half[slot], segment);
          if (closest.squared_distance > bound * bound * (1 + 1e-12)) continue;
          const std::lock_guard lock(mutex);
          candidates.push_back({slot, segment, std::sqrt(closest.squared_distance)});
        }
      });
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& l, const Candidate& r) {
    return std::tie(l.slot, l.distance, l.segment) < std::tie(r.slot, r.distance, r.segment);
  });
  // All targets first: a node must not move before its neighbours have been measured.
  std::vector<std::pair<NodeIndex, Vector>> moves;
  std::uint64_t tied = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i > 0 && candidates[i].slot == candidates[i - 1].slot) continue;
    const NodeIndex node = nodes.node[candidates[i].slot];
    if (ties.tied(node)) continue;
    ties.add(node, part_of(model.mesh, b.segments, candidates[i].segment));
    ++tied;
    if (moves_node(type))
      moves.emplace_back(node, geometry::closest_point(scene.facet(candidates[i].segment), x[node.value]).point);
  }
  for (const auto& [node, target] : moves) x[node.value] = target;
  return tied;
}

}  // namespace gapcheck::contact
