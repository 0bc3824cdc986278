#include "solver/constraint/constraint_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "contact/definition/active_time.hpp"
#include "contact/surface/erosion.hpp"
#include "solver/contact/search_margin.hpp"

namespace gapcheck::solver {
namespace {

/// Reactions push segments, which may so meet further nodes; what then still is behind is met in the next cycle.
constexpr int most_reaction_rounds = 5;

}  // namespace

ConstraintContact::ConstraintContact(const model::Model& model, contact::SurfaceStore& surfaces,
                                     const contact::InitialState& initial, const Structure& structure,
                                     std::vector<bool> movable)
    : model_(model),
      store_(surfaces),
      moved_(initial.x != model.mesh.nodes.x),
      movable_(std::move(movable)),
      held_(structure.constraints),
      search_(contact::make_bucket_grid()),
      ties_(model) {
  held_.finish();
  for (const contact::JudgedNode& node : initial.judged)
    if (node.tied()) ties_.add(node.node, node.segment_part);
  for (std::uint32_t c = 0; c < model.contacts.size(); ++c) {
    if (!calculates(model.contacts[c])) continue;
    Interface& interface = interfaces_.emplace_back();
    interface.contact = c;
    const contact::ActiveTime time = contact::active_time(model.contacts[c]);
    interface.start = time.start;
    interface.end = time.end;
    states_.emplace_back().contact = c;
    for (const contact::ContactSide* side : {&surfaces.at(c).a, &surfaces.at(c).b}) {
      for (const NodeIndex node : side->nodes.node) nodes_.push_back(node.value);
      for (const auto& corners : side->selection.segments.nodes)
        for (const NodeIndex node : corners) nodes_.push_back(node.value);
    }
  }
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

std::variant<std::unique_ptr<ConstraintContact>, Failure> ConstraintContact::create(
    const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
    const Structure& structure, std::vector<bool> movable) {
  if (std::none_of(model.contacts.begin(), model.contacts.end(), calculates)) return nullptr;
  std::unique_ptr<ConstraintContact> contact(
      new ConstraintContact(model, surfaces, initial, structure, std::move(movable)));
  if (auto failure = contact->rigid_nodes(structure)) return std::move(*failure);
  return contact;
}

std::optional<Failure> ConstraintContact::rigid_nodes(const Structure& structure) const {
  for (const std::uint32_t node : nodes_)
    if (structure.rigid.holds(node))
      return Failure{Failure::Kind::not_calculated,
                     fmt::format("a contact of type 17 or 18 (*CONTACT_CONSTRAINT_...) has node {} of a rigid body or "
                                 "weld, which constraints cannot move; use a penalty type",
                                 model_.mesh.nodes.id[node])};
  return std::nullopt;
}

void ConstraintContact::build(const std::vector<Vector>& x) {
  at_ = way_ = x;
  response_.give.assign(x.size(), Vector::Zero());
  response_.moved.assign(x.size(), Vector::Zero());
  SearchMargin margin;
  for (Interface& interface : interfaces_) {
    if (moved_) interface.own = std::make_unique<contact::ContactSurfaces>(store_.build(interface.contact, x));
    interface.surfaces = moved_ ? interface.own.get() : &store_.at(interface.contact);
    add_passes(interface);
    for (const contact::ContactSide* side : {&interface.surfaces->a, &interface.surfaces->b})
      margin.add(side->selection.segments, x);
  }
  margin_ = margin.value();
  built_ = true;
}

void ConstraintContact::add_passes(Interface& interface) {
  const bool both = interface.surfaces->type.treatment == contact::Treatment::two_way;
  for (const bool exchanged : {false, true})
    if (!exchanged || both)
      interface.passes.push_back(std::make_unique<ConstraintPass>(model_, interface.contact, *interface.surfaces,
                                                                  exchanged, *search_, ties_, movable_, at_));
}

void ConstraintContact::erode(const State& state) {
  failures_ = state.failed.count;
  at_ = state.x;  // also of nodes inside the solids, for their volumes
  const contact::GoneElements gone{state.failed.shells, state.failed.solids};
  for (Interface& interface : interfaces_) {
    auto left =
        std::make_unique<contact::ContactSurfaces>(store_.erode(interface.contact, *interface.surfaces, gone, state.x));
    std::vector<std::unique_ptr<ConstraintPass>> before;
    before.swap(interface.passes);
    std::swap(interface.own, left);  // the old passes still see the old ones
    interface.surfaces = interface.own.get();
    add_passes(interface);
    for (std::size_t k = 0; k < before.size(); ++k) interface.passes[k]->carry_over(*before[k]);
  }
  searched_.clear();
}

void ConstraintContact::follow() {
  contact::Bounds ways;
  for (std::size_t i = 0; i < searched_.size(); ++i) ways.add(at_[nodes_[i]] - searched_[i]);
  const Vector drift = (ways.low + ways.high) / 2;  // moving together brings nothing closer
  double squared = 0;
  for (std::size_t i = 0; i < searched_.size(); ++i)
    squared = std::max(squared, (at_[nodes_[i]] - searched_[i] - drift).squaredNorm());
  if (!searched_.empty() && 2 * std::sqrt(squared) * rounding_of_motion <= margin_) return;
  searched_.clear();
  for (const std::uint32_t node : nodes_) searched_.push_back(at_[node]);
  for (Interface& interface : interfaces_)
    for (const auto& pass : interface.passes) pass->search(margin_);
}

void ConstraintContact::add(State& state, Forces& /*forces*/) {
  if (!built_) build(state.x);
  for (const std::uint32_t node : nodes_) at_[node] = state.x[node];
  if (state.failed.count != failures_) erode(state);
  follow();
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    Interface& interface = interfaces_[i];
    interface.active = state.time >= interface.start && state.time < interface.end;
    for (const auto& pass : interface.passes) {
      if (!interface.active) {
        pass->rest();
        continue;
      }
      for (const ConstraintPass::Move& move : pass->inside()) {
        at_[move.node.value] += move.way;
        state.x[move.node.value] += move.way;
        ++states_[i].moved;
      }
      follow();
    }
  }
}

void ConstraintContact::predict(const State& state, double mean, double next, const Forces& net) {
  parallel_for(nodes_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t n = nodes_[i];
      const double mass = state.mass[n], give = mass > 0 ? mean * next / mass : 0;
      response_.give[n].setConstant(give);
      response_.moved[n].setZero();
      way_[n] = next * state.v[n] + give * net.force[n];
      const unsigned mask = held_.mask(n, state.time, next);
      for (int axis = 0; axis < 3; ++axis) {
        if ((mask >> axis & 1u) == 0) continue;
        response_.give[n][axis] = 0;
        way_[n][axis] = next * held_.velocity(n, static_cast<std::size_t>(axis), state.time, next);
      }
      at_[n] = state.x[n] + way_[n];
    }
  });
}

bool ConstraintContact::add_constraints() {
  const auto place = [](const Origin& o) { return std::tuple(o.interface, o.pass, o.slot); };
  std::vector<Origin> known = origins_;
  std::sort(known.begin(), known.end(), [&](const Origin& a, const Origin& b) { return place(a) < place(b); });
  const std::size_t before = constraints_.size();
  for (std::uint32_t i = 0; i < interfaces_.size(); ++i) {
    if (!interfaces_[i].active) continue;
    for (std::uint32_t p = 0; p < interfaces_[i].passes.size(); ++p)
      for (const ConstraintPass::Hit& hit : interfaces_[i].passes[p]->hits()) {
        const Origin origin{i, p, hit.slot, hit.area};
        const bool there = std::binary_search(known.begin(), known.end(), origin,
                                              [&](const Origin& a, const Origin& b) { return place(a) < place(b); });
        if (there) continue;
        SurfaceConstraint c = hit.constraint;
        const auto relative = [&](const std::vector<Vector>& way) {
          return Vector(way[c.node.value] - c.segment.of(way));
        };
        const Vector moved = relative(response_.moved);
        c.slip = relative(way_);
        // What has been behind is not thrown out: reactions take no more than the way into the surface.
        const double approach = -c.normal.dot(c.slip + moved);
        c.depth = std::min(hit.depth, approach) + c.normal.dot(moved);
        const Vector sliding = c.slip - c.slip.dot(c.normal) * c.normal;
        c.friction = contact::friction_coefficient(hit.friction, step_ > 0 ? sliding.norm() / step_ : 0);
        if (hit.friction.vc > 0) c.greatest_shear = hit.friction.vc * hit.area;
        if (approach > 0) {
          constraints_.push_back(c);
          origins_.push_back(origin);
        }
      }
  }
  return constraints_.size() > before;
}

/// Half of the work of the present reactions over the last step: added once when they are new, once when they are old.
void ConstraintContact::add_work(const State& state) {
  const double half = state.dt / 2;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const SurfaceConstraint& c = constraints_[i];
    ContactState& result = states_[origins_[i].interface];
    const Vector force = c.force(), foot = c.segment.of(state.v), &node = state.v[c.node.value];
    const bool exchanged = origins_[i].pass == 1;
    (exchanged ? result.energy_b : result.energy_a) -= half * force.dot(node);
    (exchanged ? result.energy_a : result.energy_b) += half * force.dot(foot);
    result.friction -= half * c.shear.dot(node - foot);
  }
}

void ConstraintContact::apply(Forces& net, Forces& external) {
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const SurfaceConstraint& c = constraints_[i];
    const Vector force = c.force();
    for (Forces* forces : {&net, &external}) {
      forces->force[c.node.value] += force;
      for (std::size_t k = 0; k < 4; ++k)
        if (c.segment.weights[k] != 0) forces->force[c.segment.nodes[k].value] -= c.segment.weights[k] * force;
    }
    ContactState& result = states_[origins_[i].interface];
    const bool exchanged = origins_[i].pass == 1;
    ++result.touching;
    (exchanged ? result.force_b : result.force_a) += force;
    (exchanged ? result.force_a : result.force_b) -= force;
    (exchanged ? result.moment_b : result.moment_a) += at_[c.node.value].cross(force);
    (exchanged ? result.moment_a : result.moment_b) -= c.segment.of(at_).cross(force);
  }
}

void ConstraintContact::react(const State& state, double mean, double next, Forces& net, Forces& external) {
  add_work(state);
  constraints_.clear();
  origins_.clear();
  step_ = next;
  predict(state, mean, next, net);
  for (int round = 0; round < most_reaction_rounds; ++round) {
    follow();
    if (!add_constraints()) break;
    solution_ = solve_constraints(constraints_, response_);
    for (const std::uint32_t n : nodes_) at_[n] = state.x[n] + way_[n] + response_.moved[n];
  }
  // What does not push has no force and is no contact.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    if (!(constraints_[i].push > 0)) continue;
    constraints_[kept] = constraints_[i];
    origins_[kept++] = origins_[i];
  }
  constraints_.resize(kept);
  origins_.resize(kept);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    ContactState& result = states_[i];
    for (Vector* sum : {&result.force_a, &result.force_b, &result.moment_a, &result.moment_b}) sum->setZero();
    result.touching = result.released = 0;
    for (const auto& pass : interfaces_[i].passes) result.released += pass->released();
  }
  for (const std::uint32_t n : nodes_) at_[n] = state.x[n];
  apply(net, external);
  add_work(state);
}

void ConstraintContact::absorbed(Absorbed& work) const {
  for (const ContactState& state : states_) {
    work.contact_friction += state.friction;
    work.contact_normal += state.energy_a + state.energy_b - state.friction;
  }
}

std::vector<ContactNode> ConstraintContact::nodes(std::size_t position) const {
  std::vector<ContactNode> all;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    if (origins_[i].interface != position) continue;
    const SurfaceConstraint& c = constraints_[i];
    ContactNode& node = all.emplace_back();
    node.node = c.node;
    node.segment = c.segment.nodes;
    node.force = c.force();
    node.pressure = origins_[i].area > 0 ? c.push / origins_[i].area : 0;
  }
  for (const auto& pass : interfaces_[position].passes) pass->add_released(all);
  return all;
}

void ConstraintContact::links(std::size_t position, std::vector<ContactLink>& links) const {
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    if (origins_[i].interface != position) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{constraints_[i].node}, {1}};
    link.reference = constraints_[i].segment;
    link.exchanged = origins_[i].pass == 1;
    link.force = constraints_[i].force();
  }
}

}  // namespace gapcheck::solver
