#include "contact/tie/ties.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::contact {
namespace {

/// How far projections may lie beyond a segment if the contact does not say: MAXPAR as R14 (SMP) prints it for type 2
/// without card A, PARMAX of the manual where the keyword has the MPP card (contact rules, section 9.1).
constexpr double default_maxpar = 1.07, default_parmax = 1.035;

double parmax(const model::Contact& contact) {
  const double given = contact.parmax > 0 ? contact.parmax : contact.maxpar;
  if (given > 0) return std::max(1.0, given);
  return contact.options.mpp ? default_parmax : default_maxpar;
}

/// One tied contact being processed.
class Tying {
 public:
  Tying(const TieScene& scene, ContactIndex contact, const ContactSurfaces& surfaces, std::vector<Vector>& x,
        TiedPairs& ties)
      : scene_(scene),
        model_(scene.model),
        contact_(contact),
        card_(model_.contact(contact)),
        surfaces_(surfaces),
        type_(surfaces.type),
        segments_((surfaces.two_sided() ? surfaces.b : surfaces.a).selection.segments),
        nodes_(surfaces.a.nodes),
        x_(x),
        ties_(ties),
        constraint_(ties_by_constraint(type_)),
        moves_(moves_tied_nodes(type_) && model_.controls.tiedprj == 0) {}

  TieResult run() {
    if (segments_.size() == 0) return {};
    judge();
    if (moves_) keep_beams_long();
    commit();
    return std::move(result_);
  }

 private:
  void judge() {
    const bool by_node_set = surfaces_.a.names_nodes, single = !surfaces_.two_sided();
    const Neighbours neighbours(segments_, model_.mesh, single);
    const PairScene pairs{model_, card_, type_, surfaces_.settings, x_, segments_, nodes_, neighbours, card_.b.type,
                          {},     {},    -1,    scene_.mode};
    const bool negative = card_.sst < 0 || card_.mst < 0;
    const auto candidates = tie_candidates(pairs, scene_.search, {parmax(card_), negative, by_node_set, single},
                                           scene_.sweep, scene_.decisions);
    result_.nodes = nodes_.size();
    result_.segments = segments_.size();
    for (const SlotIndex slot : positions<SlotIndex>(nodes_.size())) {
      const TieCandidate& candidate = candidates[slot.value];
      if (single ? !candidate.ties : !neighbours.at(nodes_.node[slot.value]).empty()) continue;
      if (candidate.segment == none<SegmentIndex> && !by_node_set) {
        result_.out_of_reach.push_back(nodes_.node[slot.value]);
        continue;
      }
      result_.judged.push_back(judged(slot, candidate, negative));
    }
  }

  [[nodiscard]] JudgedNode judged(SlotIndex slot, const TieCandidate& candidate, bool negative) {
    JudgedNode node;
    node.contact = contact_;
    node.node = nodes_.node[slot.value];
    node.part = nodes_.part[slot.value];
    node.by_node_set = surfaces_.a.names_nodes;
    node.node_thickness = 2 * nodes_.half[slot.value];
    if (!candidate.on_segment) {
      node.reason = TieReason::not_found;
      return node;
    }
    const SegmentIndex s = candidate.segment;
    const auto kind = segments_.element_kind[s.value];
    node.segment = s;
    node.segment_part = part_of(model_.mesh, segments_, s.value);
    node.distance = candidate.distance;
    node.diagonal = candidate.diagonal;
    node.segment_thickness = 2 * segments_.half[s.value];
    node.allowed = tie_distance(node.node_thickness, node.segment_thickness, node.diagonal,
                                kind == model::ElementKind::solid || kind == model::ElementKind::thick_shell, negative);
    if (!candidate.ties)
      node.reason = TieReason::too_far;
    else if (constraint_)
      constrain(node);
    if (node.tied()) separate(node);
    return node;
  }

  /// The obstacle to a constraint becomes the node's reason; IPBACK ties such nodes by penalty.
  void constrain(JudgedNode& node) {
    const RigidNodes& rigid = ties_.rigid();
    std::optional<TieReason> reason;
    if ((node.rigid = rigid.owner(node.node))) {
      reason = TieReason::rigslav;
    } else {
      for (const NodeIndex corner : segments_.nodes[node.segment.value])
        if (!node.rigid) node.rigid = rigid.owner(corner);
      if (node.rigid) reason = TieReason::rigmast;
    }
    if (const auto holder = ties_.constrained_by(node.node); !reason && holder) {
      node.holder = *holder;
      reason = TieReason::conflict;
    }
    node.penalty = reason && card_.ipback != 0;
    if (!node.penalty) node.reason = reason;
  }

  /// Separations that are closed or make the tie wrong. The b and c forms carry them; tiebreaks keep the surfaces
  /// apart.
  void separate(JudgedNode& node) const {
    const bool told = type_.offset == TieOffset::penalty || moves_tied_nodes(type_) || node.penalty;
    if (told && node.distance > visible_separation * node.diagonal)
      node.reason = moves(node) ? TieReason::sep : TieReason::offset;
  }

  [[nodiscard]] bool moves(const JudgedNode& node) const { return moves_ && !node.penalty && node.tied(); }

  [[nodiscard]] JudgedNode* find(NodeIndex node) {
    auto& all = result_.judged;
    const auto at =
        std::lower_bound(all.begin(), all.end(), node, [](const JudgedNode& j, NodeIndex n) { return j.node < n; });
    return at != all.end() && at->node == node ? &*at : nullptr;
  }

  /// The node's position after this contact has tied it.
  [[nodiscard]] Vector target(const JudgedNode& node) const {
    const auto& n = segments_.nodes[node.segment.value];
    const geometry::Facet facet{{x_[n[0].value], x_[n[1].value], x_[n[2].value], x_[n[3].value]}, n[2] == n[3]};
    return geometry::closest_point(facet, x_[node.node.value]).point;
  }

  /// If tying would shorten a beam too much, the end that moves farther stays untied.
  void keep_beams_long() {
    if (model_.mesh.beams.size() == 0) return;
    for (JudgedNode& node : result_.judged) {
      for (const auto& [end, other_end] : ties_.beams_at(node.node)) {
        JudgedNode* const other = find(other_end);
        const double before = (x_[end.value] - x_[other_end.value]).norm();
        while (moves(node)) {
          const bool both = other != nullptr && moves(*other);
          const Vector far_end = both ? target(*other) : x_[other_end.value];
          if (!((target(node) - far_end).norm() < shortest_beam * before)) break;
          (both && other->distance > node.distance ? *other : node).reason = TieReason::too_short;
        }
      }
    }
  }

  void commit() {
    std::vector<std::pair<NodeIndex, Vector>> targets;
    for (const JudgedNode& node : result_.judged) {
      if (!node.tied()) continue;
      ++result_.tied;
      ties_.add(node.node, node.segment_part);
      if (constraint_ && !node.penalty) ties_.constrain(node.node, contact_);
      if (moves(node)) targets.emplace_back(node.node, target(node));
    }
    // Moved only now: no node may move before its neighbours have been measured.
    for (const auto& [node, to] : targets) x_[node.value] = to;
    result_.moved = targets.size();
  }

  const TieScene& scene_;
  const model::Model& model_;
  const ContactIndex contact_;
  const model::Contact& card_;
  const ContactSurfaces& surfaces_;
  const ContactType& type_;
  const Segments& segments_;
  const TrackedNodes& nodes_;
  std::vector<Vector>& x_;
  TiedPairs& ties_;
  const bool constraint_, moves_;
  TieResult result_;
};

}  // namespace

TieResult apply_ties(const TieScene& scene, ContactIndex contact, const ContactSurfaces& surfaces,
                     std::vector<Vector>& x, TiedPairs& ties) {
  return Tying(scene, contact, surfaces, x, ties).run();
}

}  // namespace gapcheck::contact
