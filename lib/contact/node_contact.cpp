#include "contact/node_contact.hpp"

#include <algorithm>

#include "contact/outcome.hpp"

namespace gapcheck::contact {
namespace {

NodeAction first_penetration(NodeContact& node, const ContactSettings& settings, const NodeEncounter& encounter) {
  node.state = NodeContact::State::touching;
  switch (outcome(settings)) {
    case Outcome::kept: node.forgiven = encounter.penetration; return NodeAction::force;
    case Outcome::moved: return encounter.movable ? NodeAction::move : NodeAction::force;
    default: return NodeAction::force;
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
  if (node.state == State::apart) return first_penetration(node, settings, encounter);
  node.forgiven = std::min(node.forgiven, encounter.penetration);
  return NodeAction::force;
}

}  // namespace gapcheck::contact
