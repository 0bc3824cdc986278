#include "reference/tie_pass.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace gapcheck::reference {
namespace {

using model::TieOffset;

constexpr double relative = 3e-9;          ///< the tolerance of 9.1, three times: what is nearer to a limit is left out
constexpr double separation_share = 0.01;  ///< 9.3: of the shorter diagonal

/// How far a projection lies from the middle, as MAXPAR counts: 1 on the border.
double reach(const Facet& facet, const Closest& c) {
  return facet.triangle ? 1 - 2 * (-0.25 - c.beyond_band) : c.beyond_band + 1.5;
}

double parametric_limit(const Contact& c) {
  if (c.mpp) return c.parmax > 0 ? c.parmax : 1.035;
  return c.maxpar > 0 ? c.maxpar : 1.07;
}

class Judge {
 public:
  Judge(const Scene& scene, const Rules& rules, const TieState& state, const Positions& x)
      : scene_(scene),
        rules_(rules),
        state_(state),
        x_(x),
        tracked_(make_side(scene, rules, Which::a, x)),
        reference_(make_side(scene, rules, Which::b, x)) {}

  std::vector<TieOutcome> all() const {
    std::vector<TieOutcome> outcomes;
    if (reference_.facets.empty()) return outcomes;
    for (const auto& [node, half] : tracked_.nodes) outcomes.push_back(judge(node, half));
    return outcomes;
  }

 private:
  /// 9.1
  double limit(const Facet& facet, double node_half) const {
    const Contact& c = rules_.contact;
    const double node = c.sst < 0 ? -c.sst : 2 * node_half;
    const double segment = c.mst < 0 ? -c.mst : facet.thickness;
    const double d1 = 0.6 * (node + segment), d2 = 0.05 * shorter_diagonal(facet, x_);
    if (c.sst < 0 || c.mst < 0) return d1;
    return facet.solid ? d2 : std::max(d1, d2);
  }

  /// In the box around the segment, grown by its longer diagonal or twice the largest tie distance of the nodes.
  bool within(const Facet& facet, const Vector& query, double allowed) const {
    const Corners c = corners(facet.nodes, x_);
    Vector low = c[0], high = c[0];
    for (const Vector& corner : c) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    double largest = 0;
    for (const auto& [node, half] : tracked_.nodes) largest = std::max(largest, half);
    const double grown =
        std::max(2 * std::max(allowed, limit(facet, largest)), std::max((c[2] - c[0]).norm(), (c[3] - c[1]).norm()));
    return (query.array() >= low.array() - grown).all() && (query.array() <= high.array() + grown).all();
  }

  TieOutcome judge(std::int64_t node, double half) const {
    TieOutcome out;
    out.node = node;
    if (std::any_of(reference_.facets.begin(), reference_.facets.end(), [&](const Facet& f) { return f.has(node); }))
      return out;  // joined by the mesh
    const Vector& query = x_[static_cast<std::size_t>(node)];
    const bool meant = rules_.contact.a.type == 4;
    const Facet* best = nullptr;
    Closest place;
    bool on_any = false, in_reach = false, open = false;
    for (const Facet& facet : reference_.facets) {
      if (facet.line) continue;
      const Closest c = closest(corners(facet.nodes, x_), facet.triangle, query);
      const double allowed = limit(facet, half), parametric = reach(facet, c);
      const double size = shorter_diagonal(facet, x_);
      const bool near = c.distance < 2.1 * allowed + 1e-9;
      if (std::abs(c.distance - 2 * allowed) < relative * allowed) out.doubt = "at twice the tie distance";
      // 9.3: how far away a projection is looked for.
      if (meant ? !within(facet, query, allowed) : c.distance > 2 * allowed) continue;
      if (near && !c.certain) out.doubt = "no certain projection";
      if (std::abs(parametric - parametric_limit(rules_.contact)) < 1e-7) out.doubt = "on the border";
      if (std::abs(c.distance - allowed) < relative * allowed + 1e-12 * size) out.doubt = "at the tie distance";
      in_reach = true;
      open = open || !c.certain;
      if (parametric > parametric_limit(rules_.contact)) continue;
      on_any = true;
      if (c.distance > allowed) continue;
      if (best != nullptr && std::abs(c.distance - place.distance) <= 1e-9 * c.distance) {
        const bool alike = best->part == facet.part && best->solid == facet.solid;
        if (!alike || std::abs(shorter_diagonal(*best, x_) - size) > 0.2 * size)
          out.doubt = "two segments equally near";
        continue;
      }
      if (best == nullptr || c.distance < place.distance) best = &facet, place = c;
    }
    out.judged = meant || in_reach;
    out.out_of_reach = !out.judged;
    if (!out.judged) return out;
    if (best == nullptr) {
      if (open) out.doubt = "no certain projection";
      out.reason = on_any ? TieReason::too_far : TieReason::not_found;
      return out;
    }
    tie(out, *best, place);
    return out;
  }

  /// 9.2, 9.3: how it ties, or why it does not.
  void tie(TieOutcome& out, const Facet& segment, const Closest& place) const {
    const bool breaks = rules_.kind.breaks();
    const TieOffset offset = rules_.kind.offset;
    bool constraint = !breaks && (offset == TieOffset::none || offset == TieOffset::constrained);
    out.distance = place.distance;
    out.part = segment.part;
    if (constraint) {
      std::optional<TieReason> refused;
      if (state_.rigid.contains(out.node)) {
        refused = TieReason::rigslav;
      } else if (std::any_of(segment.nodes.begin(), segment.nodes.end(),
                             [&](std::int64_t n) { return state_.rigid.contains(n); })) {
        refused = TieReason::rigmast;
      } else if (state_.constrained.contains(out.node)) {
        refused = TieReason::conflict;
      }
      if (refused && rules_.contact.ipback != 1) {
        out.reason = refused;
        return;
      }
      if (refused) constraint = false;  // by penalty, where it is
    }
    out.tied = true;
    out.constrained = constraint;
    out.moved = constraint && offset == TieOffset::none && rules_.controls.tiedprj != 1;
    out.target = place.point;
    if (out.moved) beams(out);
    const double separation = separation_share * shorter_diagonal(segment, x_);
    if (std::abs(place.distance - separation) < 1e-9 * separation) out.doubt = "at the separation that counts";
    if (place.distance <= separation) return;
    if (out.moved)
      out.reason = TieReason::sep;
    else if (!breaks && offset != TieOffset::beam && (offset != TieOffset::constrained || !constraint))
      out.reason = TieReason::offset;
  }

  /// Where moving might make a beam too short, the reference says nothing.
  void beams(TieOutcome& out) const {
    for (const Element& e : scene_.elements) {
      if (e.kind != Kind::beam || std::find(e.nodes.begin(), e.nodes.end(), out.node) == e.nodes.end()) continue;
      const auto at = [&](std::size_t i) { return x_[static_cast<std::size_t>(e.nodes[i])]; };
      if (2 * out.distance > 0.4 * (at(1) - at(0)).norm()) out.doubt = "a beam may become too short";
    }
  }

  const Scene& scene_;
  const Rules& rules_;
  const TieState& state_;
  const Positions& x_;
  Side tracked_, reference_;
};

}  // namespace

std::vector<TieOutcome> judge_ties(const Scene& scene, const Rules& rules, const TieState& state, const Positions& x) {
  return Judge(scene, rules, state, x).all();
}

}  // namespace gapcheck::reference
