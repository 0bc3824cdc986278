#include "solver/contact/transducers.hpp"

#include <algorithm>

#include "contact/tie/transducers.hpp"
#include "solver/contact/contact_method.hpp"

namespace gapcheck::solver {
namespace {

std::vector<bool> marked(const contact::ContactSide& side, std::size_t nodes) {
  std::vector<bool> marks(nodes, false);
  for (const NodeIndex node : side.selection.nodes) marks[node.value] = true;
  for (const auto& corners : side.selection.segments.nodes)
    for (const NodeIndex node : corners) marks[node.value] = true;
  return marks;
}

bool lies_on(const ContactPoint& point, const std::vector<bool>& marks) {
  for (std::size_t i = 0; i < 4; ++i)
    if (point.weights[i] != 0 && !marks[point.nodes[i].value]) return false;
  return true;
}

/// Adds the share of `force` at a point that acts on marked nodes.
void add_nodes(const ContactPoint& point, const Vector& force, const std::vector<bool>& marks, const State& state,
               ContactState& sum) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t node = point.nodes[i].value;
    if (point.weights[i] == 0 || !marks[node]) continue;
    const Vector share = point.weights[i] * force;
    sum.force_a += share;
    sum.moment_a += state.x[node].cross(share);
  }
}

}  // namespace

Transducers::Transducers(const model::Model& model, contact::SurfaceStore& surfaces) : model_(model) {
  const std::size_t nodes = model.mesh.nodes.size();
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(c);
    if (choose_method(contact).method != ContactMethod::transducer) continue;
    const contact::ContactSurfaces& sides = surfaces.at(c);
    Transducer& transducer = transducers_.emplace_back();
    transducer.contact = c;
    transducer.between = contact::measures_between(contact);
    transducer.a = marked(sides.a, nodes);
    if (transducer.between) transducer.b = marked(sides.b, nodes);
  }
}

bool Transducers::add(const Transducer& transducer, const ContactLink& link, const State& state, ContactState& sum) {
  if (!transducer.between) {
    add_nodes(link.tracked, link.force, transducer.a, state, sum);
    add_nodes(link.reference, -link.force, transducer.a, state, sum);
    return false;
  }
  const bool straight = lies_on(link.tracked, transducer.a) && lies_on(link.reference, transducer.b);
  if (!straight && !(lies_on(link.reference, transducer.a) && lies_on(link.tracked, transducer.b))) return false;
  const Vector on_a = straight ? link.force : Vector(-link.force);
  const Vector at_a = (straight ? link.tracked : link.reference).of(state.x);
  const Vector at_b = (straight ? link.reference : link.tracked).of(state.x);
  sum.force_a += on_a;
  sum.force_b -= on_a;
  sum.moment_a += at_a.cross(on_a);
  sum.moment_b -= at_b.cross(on_a);
  return true;
}

std::vector<ContactState> Transducers::measure(std::span<const ContactView> contacts, const State& state) const {
  std::vector<ContactState> sums(transducers_.size());
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i].contact = transducers_[i].contact;
  if (sums.empty()) return sums;
  std::vector<ContactLink> links;
  for (const ContactView& view : contacts) {
    const model::Contact& contact = model_.contact(view.state().contact);
    links.clear();
    view.source->links(view.position, links);
    for (const ContactLink& link : links) {
      bool used = false;
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const Transducer& transducer = transducers_[i];
        if (!contact::measures(model_.contact(transducer.contact), contact)) continue;
        if (transducer.between && ((used && model_.controls.ftall != 1) || !contact::tells_surfaces(contact))) continue;
        used = add(transducer, link, state, sums[i]) || used;
      }
    }
  }
  return sums;
}

}  // namespace gapcheck::solver
