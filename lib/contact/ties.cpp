#include "contact/ties.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <tuple>

#include "contact/closest_segment.hpp"

namespace gapcheck::contact {
namespace {

constexpr double thickness_share = 0.6, diagonal_share = 0.05;  // [workshop]
/// PARMAX of tied contacts (MPP default).
constexpr double default_parmax = 1.035;
/// Nodes of parts are taken as meant to tie within this multiple of the tie distance.
constexpr double meant_to_tie = 2;

struct Candidate {
  std::uint32_t slot, segment;
  double distance, allowed;
  bool on_segment;  // the projection falls in the segment
  [[nodiscard]] bool ties() const { return on_segment && distance <= allowed * (1 + 1e-12); }
};

double min_diagonal(const geometry::Facet& f) {
  return std::sqrt(std::min((f.x[2] - f.x[0]).squaredNorm(), (f.x[3] - f.x[1]).squaredNorm()));
}

double max_diagonal(const geometry::Facet& f) {
  return std::sqrt(std::max((f.x[2] - f.x[0]).squaredNorm(), (f.x[3] - f.x[1]).squaredNorm()));
}

bool moves_node(const ContactType& type) { return type.code == "2" || type.code == "6" || type.code == "7"; }

bool solid(const Segments& s, std::uint32_t i) {
  return s.element_kind[i] == model::ElementKind::solid || s.element_kind[i] == model::ElementKind::thick_shell;
}

/// One tied contact on its way.
class Tying {
 public:
  Tying(const model::Model& model, const model::Contact& contact, const ContactSurfaces& surfaces,
        std::vector<Vector>& x, Ties& ties)
      : model_(model),
        contact_(contact),
        type_(surfaces.type),
        settings_(surfaces.settings),
        x_(x),
        ties_(ties),
        segments_(surfaces.b.selection.segments),
        nodes_(surfaces.a.nodes),
        by_node_set_(surfaces.a.nodes_only) {}

  TieResult run(const CandidateSearch& search) {
    if (segments_.size() == 0) return {};
    if (ties_by_constraint(type_)) rigid_ = rigid_nodes(model_);
    find_candidates(search);
    return decide();
  }

 private:
  void find_candidates(const CandidateSearch& search) {
    const Neighbours neighbours(segments_, model_.mesh);
    const PairScene scene{model_, contact_, type_, settings_, x_, segments_, nodes_, neighbours, contact_.b.type, {}, {}};
    const double parmax = contact_.parmax > 0 ? contact_.parmax : contact_.maxpar > 0 ? contact_.maxpar : default_parmax;
    const bool negative = contact_.sst < 0 || contact_.mst < 0;
    const double largest_half = nodes_.half.empty() ? 0 : *std::max_element(nodes_.half.begin(), nodes_.half.end());
    const auto limit = [&](double node_half, std::uint32_t s) {
      return tie_distance(2 * node_half, 2 * segments_.half[s], min_diagonal(scene.facet(s)), solid(segments_, s), negative);
    };
    // Nodes of a node set are looked for a segment's length away, to tell "too far" from "on no segment".
    const auto reach = [&](std::uint32_t s) {
      const double near = meant_to_tie * limit(largest_half, s);
      return by_node_set_ ? std::max(near, max_diagonal(scene.facet(s))) : near;
    };
    std::mutex mutex;
    SweepCounters sweep;
    for_each_candidate(scene, search, reach, sweep, [&](std::uint32_t segment, std::span<const std::uint32_t> slots) {
      if (scene.line(segment)) return;
      const geometry::Facet facet = scene.facet(segment);
      for (const std::uint32_t slot : slots) {
        const auto closest = geometry::closest_point(facet, scene.position(slot), parmax - 1);
        const double distance = std::sqrt(closest.squared_distance), allowed = limit(nodes_.half[slot], segment);
        if (!by_node_set_ && distance > meant_to_tie * allowed) continue;
        const std::lock_guard lock(mutex);
        candidates_.push_back({slot, segment, distance, allowed, closest.in_band});
      }
    });
    // Candidates that tie first, then those that hold the node's projection, then the nearest.
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& l, const Candidate& r) {
      return std::tuple(l.slot, !l.ties(), !l.on_segment, l.distance, l.segment) <
             std::tuple(r.slot, !r.ties(), !r.on_segment, r.distance, r.segment);
    });
  }

  TieResult decide() {
    TieResult result;
    result.nodes = nodes_.size();
    result.segments = segments_.size();
    std::size_t next = 0;
    for (std::uint32_t slot = 0; slot < nodes_.size(); ++slot) {
      const std::size_t first = next;
      while (next < candidates_.size() && candidates_[next].slot == slot) ++next;
      if (first == next && !by_node_set_) continue;
      ++result.judged;
      decide_node(slot, first == next ? nullptr : &candidates_[first], result);
    }
    // Moved only now: no node may move before its neighbours have been measured.
    for (const auto& [node, target] : moves_) x_[node.value] = target;
    result.moved = moves_.size();
    return result;
  }

  void decide_node(std::uint32_t slot, const Candidate* best, TieResult& result) {
    const NodeIndex node = nodes_.node[slot];
    const bool found = best != nullptr && best->on_segment;
    const bool near = found && best->ties();
    if (near && ties_by_constraint(type_)) {
      if (rigid_[node.value]) return fail(slot, best, TieReason::rigslav, result);
      const auto& corners = segments_.nodes[best->segment];
      if (std::any_of(corners.begin(), corners.end(), [&](NodeIndex n) { return rigid_[n.value]; }))
        return fail(slot, best, TieReason::rigmast, result);
      if (ties_.constrained(node)) return fail(slot, best, TieReason::conflict, result);
    }
    if (!near) return fail(slot, found ? best : nullptr, found ? TieReason::too_far : TieReason::not_found, result);
    ties_.add(node, part_of(model_.mesh, segments_, best->segment), ties_by_constraint(type_));
    ++result.tied;
    result.largest_separation = std::max(result.largest_separation, best->distance);
    if (!moves_node(type_)) return;
    const auto& n = segments_.nodes[best->segment];
    const geometry::Facet facet{{x_[n[0].value], x_[n[1].value], x_[n[2].value], x_[n[3].value]}, n[2] == n[3]};
    moves_.emplace_back(node, geometry::closest_point(facet, x_[node.value]).point);
  }

  void fail(std::uint32_t slot, const Candidate* best, TieReason reason, TieResult& result) const {
    TieFailure failure;
    failure.node = model_.mesh.nodes.id[nodes_.node[slot].value];
    if (nodes_.part[slot] != none<PartIndex>) failure.part = model_.part(nodes_.part[slot]).id.value;
    if (best != nullptr) {
      failure.segment_number = best->segment + 1;
      failure.distance = best->distance;
    }
    failure.reason = reason;
    failure.by_node_set = by_node_set_;
    result.untied.push_back(failure);
  }

  const model::Model& model_;
  const model::Contact& contact_;
  const ContactType& type_;
  const ContactSettings& settings_;
  std::vector<Vector>& x_;
  Ties& ties_;
  const Segments& segments_;
  const TrackedNodes& nodes_;
  const bool by_node_set_;
  std::vector<bool> rigid_;
  std::vector<Candidate> candidates_;
  std::vector<std::pair<NodeIndex, Vector>> moves_;
};

}  // namespace

double tie_distance(double node_thickness, double segment_thickness, double diagonal, bool solid_segment,
                    bool negative_thickness) {
  const double d1 = thickness_share * (node_thickness + segment_thickness);
  const double d2 = diagonal_share * diagonal;
  if (negative_thickness) return d1;
  return solid_segment ? d2 : std::max(d1, d2);
}

bool ties_by_constraint(const ContactType& type) {
  const char form = type.code.front();
  return type.family == Family::tied && form != 'o' && form != 'b' && type.code != "8" && type.code != "9";
}

std::vector<bool> rigid_nodes(const model::Model& model) {
  std::vector<bool> rigid(model.mesh.nodes.size(), false);
  const auto mark_elements = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (elements.part[e] != none<PartIndex> && model.rigid(elements.part[e]))
        for (const NodeIndex n : elements.nodes[e]) rigid[n.value] = true;
  };
  mark_elements(model.mesh.shells);
  mark_elements(model.mesh.solids);
  mark_elements(model.mesh.thick_shells);
  mark_elements(model.mesh.beams);
  for (const model::RigidGroup& group : model.rigid_groups)
    for (const NodeIndex n : group.nodes) rigid[n.value] = true;
  return rigid;
}

void Ties::add(NodeIndex node, PartIndex part, bool constraint) {
  Tied& tied = nodes_[node.value];
  tied.parts.push_back(part);
  tied.constraint = tied.constraint || constraint;
}

bool Ties::tied(NodeIndex node, PartIndex part) const {
  const auto found = nodes_.find(node.value);
  if (found == nodes_.end()) return false;
  const auto& parts = found->second.parts;
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

bool Ties::constrained(NodeIndex node) const {
  const auto found = nodes_.find(node.value);
  return found != nodes_.end() && found->second.constraint;
}

TieResult apply_ties(const model::Model& model, const model::Contact& contact, const ContactSurfaces& surfaces,
                     const CandidateSearch& search, std::vector<Vector>& x, Ties& ties) {
  return Tying(model, contact, surfaces, x, ties).run(search);
}

}  // namespace gapcheck::contact
