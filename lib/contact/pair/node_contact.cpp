#include "contact/pair/node_contact.hpp"

#include <algorithm>
#include <cmath>

#include "contact/definition/outcome.hpp"

namespace gapcheck::contact {
namespace {

NodeAction first_penetration(NodeContact& node, const ContactSettings& settings, const NodeEncounter& encounter) {
  node.state = NodeContact::State::touching;
  switch (outcome(settings)) {
    case Outcome::kept:
      node.forgiven = encounter.penetration;
      return NodeAction::force;
    case Outcome::moved:
      return encounter.movable ? NodeAction::move : NodeAction::force;
    default:
      return NodeAction::force;
  }
}

}  // namespace

NodeAction advance(NodeContact& node, const ContactSettings& settings, const NodeEncounter& encounter) {
  using State = NodeContact::State;
  if (node.state == State::released && encounter.in_zone) return NodeAction::none;
  if (!encounter.penetrates) {
    node = {};
    return NodeAction::none;
  }
  if (encounter.penetration > encounter.release_depth) {
    node = {State::released, 0};
    return NodeAction::none;
  }
  if (node.state == State::apart && !encounter.followed) return first_penetration(node, settings, encounter);
  node.state = State::touching;
  node.forgiven = std::min(node.forgiven, encounter.penetration);
  return NodeAction::force;
}

NodeAction advance_interference(NodeContact& node, const NodeEncounter& encounter) {
  ContactSettings at_once;
  at_once.snlog = 1;
  return advance(node, at_once, encounter);
}

NodeAction advance_from_baseline(NodeContact& node, const NodeEncounter& encounter, double reduction) {
  if (!encounter.penetrates) {
    node = {};
    return NodeAction::none;
  }
  if (node.state == NodeContact::State::apart)
    node = {NodeContact::State::touching, encounter.followed ? 0 : encounter.penetration};
  else
    node.forgiven = std::min(node.forgiven, encounter.penetration) * (1 - reduction);
  return NodeAction::force;
}

double baseline_reduction(const model::Model& model, const model::Contact& contact, double time) {
  double factor = contact.dprfac;
  if (factor < 0) {
    const auto curve = model.curves.find(static_cast<std::int64_t>(std::llround(-std::max(factor, -1e15))));
    factor = curve == model.curves.end() ? 0 : curve->second.at(time);
  }
  return factor > 0 ? std::min(factor, 1.0) : 0;
}

}  // namespace gapcheck::contact
