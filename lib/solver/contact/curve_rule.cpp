#include "solver/contact/curve_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "contact/stiffness/segment_spring.hpp"

namespace gapcheck::solver {
namespace {

enum ForceMethod : std::int64_t { by_node_force = 2, by_node_pressure = 3 };

const model::Curve* law_curve(const model::Model& model, std::int64_t id) {
  const auto found = model.curves.find(id);
  return id == 0 || found == model.curves.end() ? nullptr : &found->second;
}

/// By tracked node: its share of the segments at it.
std::vector<double> node_areas(const contact::ContactSide& side, const std::vector<Vector>& x) {
  const std::vector<NodeIndex>& nodes = side.nodes.node;
  std::vector<double> areas(nodes.size(), 0);
  for (const model::SegmentNodes& n : side.selection.segments.nodes) {
    const std::size_t corners = contact::corner_count(n);
    const double share = quad_normal({x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}).norm() / 2 /
                         static_cast<double>(corners);
    for (std::size_t i = 0; i < corners; ++i) {
      const auto slot = std::lower_bound(nodes.begin(), nodes.end(), n[i]);
      if (slot != nodes.end() && *slot == n[i]) areas[static_cast<std::size_t>(slot - nodes.begin())] += share;
    }
  }
  return areas;
}

}  // namespace

double CurveForce::at(double depth, double deepest) const {
  const double loaded = loading->at(std::max(depth, deepest));
  if (depth >= deepest || unloading_stiffness == 0) return loading->at(depth);
  const double floor = unloading != nullptr ? std::max(0.0, unloading->at(depth)) : 0;
  return std::clamp(loaded - unloading_stiffness * (deepest - depth), std::min(floor, loaded), loaded);
}

double CurveForce::damping_at(double closing) const {
  return damping == nullptr ? 0 : std::max(0.0, damping_scale * damping->at(std::abs(closing)));
}

CurveRule::CurveRule(const ContactSetting& setting, const TrackedPairs& pairs) {
  const model::RigidForce& card = pairs.scene().contact.rigid;
  force_ = {law_curve(setting.model, card.curve), law_curve(setting.model, card.unloading_curve),
            law_curve(setting.model, card.damping_curve), card.unloading, card.damping_scale};
  deepest_.assign(pairs.size(), 0);
  if (card.method == by_node_pressure)
    area_ = node_areas(pairs.side().tracked(), pairs.scene().x);
  else
    area_.assign(pairs.size(), 1);
}

void CurveRule::bend(SlotIndex slot, double depth, double closing, LinkSpring& law) {
  double& deepest = deepest_[slot.value];
  const double force = area_[slot.value] * force_.at(depth, deepest);
  deepest = std::max(deepest, depth);
  law.stiffness = depth > 0 ? force / depth : 0;
  law.damping = area_[slot.value] * force_.damping_at(closing);
}

void CurveRule::continue_from(const NodeRule& before) {
  const auto* const old = dynamic_cast<const CurveRule*>(&before);
  if (old != nullptr && old->deepest_.size() == deepest_.size()) deepest_ = old->deepest_;
}

bool acts_by_curve(const model::Contact& contact) {
  return contact.kind != nullptr && contact.kind->cards == model::TypeCards::rigid;
}

std::string_view curve_not_calculated(const model::Contact& contact) {
  if (contact.rigid.method != by_node_force && contact.rigid.method != by_node_pressure)
    return "of rigid contacts FCM = 2 (force on each node) and 3 (pressure) alone are calculated";
  if (contact.rigid.method == by_node_pressure && contact.kind->code == model::ContactCode::rigid_nodes)
    return "FCM = 3 needs segments on side A, which RIGID_NODES_TO_RIGID_BODY has not; use FCM = 2";
  return {};
}

SolverStatus check_curve_contact(const model::Model& model, const model::Contact& contact) {
  const auto fail = [&](const std::string& text) {
    return Failure{Failure::Kind::contradiction,
                   fmt::format("contact {} (*{}): {}", contact.id.value, contact.written, text), contact.place};
  };
  const model::RigidForce& card = contact.rigid;
  if (!(card.unloading >= 0) || !std::isfinite(card.unloading) || !std::isfinite(card.damping_scale))
    return fail("US must be 0 or more, and DSF a number");
  if (card.unloading_curve != 0 && card.unloading == 0) return fail("UNLCID needs an unloading stiffness (US)");
  constexpr std::string_view names[] = {"LCID", "UNLCID", "LCDC"};
  const std::int64_t ids[] = {card.curve, card.unloading_curve, card.damping_curve};
  for (std::size_t i = 0; i < std::size(ids); ++i) {
    if (ids[i] == 0 && i > 0) continue;
    const model::Curve* const curve = law_curve(model, ids[i]);
    if (curve == nullptr || curve->points.empty())
      return fail(fmt::format("there is no curve {} ({}), or it has no points; define it with *DEFINE_CURVE", ids[i],
                              names[i]));
    for (const auto& [abscissa, ordinate] : curve->points)
      if (!std::isfinite(abscissa) || !std::isfinite(ordinate) || ordinate < 0)
        return fail(fmt::format("curve {} ({}) has the value {:g}; use values from 0 up", ids[i], names[i], ordinate));
  }
  return {};
}

}  // namespace gapcheck::solver
