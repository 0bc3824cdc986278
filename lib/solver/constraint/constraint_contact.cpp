#include "solver/constraint/constraint_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "contact/definition/active_time.hpp"
#include "contact/search/choose_search.hpp"
#include "contact/surface/erosion.hpp"

namespace gapcheck::solver {
namespace {

/// Reactions push segments, which may thus meet further nodes; nodes still behind are handled in the next cycle.
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
      search_(contact::make_repeated_search()),
      ties_(model) {
  held_.finish();
  for (const contact::JudgedNode& node : initial.judged)
    if (node.tied()) ties_.add(node.node, node.segment_part);
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size())) {
    if (!calculates(model.contact(c))) continue;
    Interface& interface = interfaces_.emplace_back();
    interface.contact = c;
    const contact::ActiveTime time = contact::active_time(model.contact(c));
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
  if (const SolverStatus status = contact->check_rigid_nodes(structure); !status.ok()) return status.error();
  return contact;
}

SolverStatus ConstraintContact::check_rigid_nodes(const Structure& structure) const {
  for (const std::uint32_t node : nodes_)
    if (structure.rigid.holds(node))
      return Failure{Failure::Kind::not_calculated,
                     fmt::format("a contact of type 17 or 18 has node {} of a rigid body or weld, which constraints "
                                 "cannot move; use a penalty type",
                                 model_.mesh.nodes.id[node])};
  return {};
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
  searched_.set_margin(margin.value());
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
  const contact::GoneElements gone{state.failed.shells, state.failed.solids, state.failed.beams};
  for (Interface& interface : interfaces_) {
    auto left =
        std::make_unique<contact::ContactSurfaces>(store_.erode(interface.contact, *interface.surfaces, gone, state.x));
    std::vector<std::unique_ptr<ConstraintPass>> before;
    before.swap(interface.passes);
    std::swap(interface.own, left);  // the old passes still use the old ones
    interface.surfaces = interface.own.get();
    add_passes(interface);
    for (std::size_t k = 0; k < before.size(); ++k) interface.passes[k]->continue_from(*before[k]);
  }
  searched_.forget();
}

void ConstraintContact::renew_candidates() {
  if (searched_.valid(nodes_, at_)) return;
  searched_.set(nodes_, at_);
  for (Interface& interface : interfaces_)
    for (const auto& pass : interface.passes) pass->find_candidates(searched_.margin());
}

void ConstraintContact::add(State& state, Forces& /*forces*/) {
  if (!built_) build(state.x);
  for (const std::uint32_t node : nodes_) at_[node] = state.x[node];
  if (state.failed.count != failures_) erode(state);
  renew_candidates();
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    Interface& interface = interfaces_[i];
    interface.active = state.time >= interface.start && state.time < interface.end;
    for (const auto& pass : interface.passes) {
      if (!interface.active) {
        pass->deactivate();
        continue;
      }
      for (const ConstraintPass::Move& move : pass->find_moves()) {
        at_[move.node.value] += move.way;
        state.x[move.node.value] += move.way;
        ++states_[i].moved;
      }
      renew_candidates();
    }
  }
}

void ConstraintContact::predict_motion(const State& state, double mean, double next, const Forces& net) {
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

std::optional<SurfaceConstraint> ConstraintContact::constraint_of(const ConstraintPass::Hit& hit) const {
  SurfaceConstraint c = hit.constraint;
  const auto relative = [&](const std::vector<Vector>& way) { return Vector(way[c.node.value] - c.segment.of(way)); };
  const Vector moved = relative(response_.moved);
  c.slip = relative(way_);
  // Nodes that were behind are not thrown out: reactions only cancel the advance into the surface.
  const double approach = -c.normal.dot(c.slip + moved);
  c.depth = std::min(hit.depth, approach) + c.normal.dot(moved);
  const Vector sliding = c.slip - c.slip.dot(c.normal) * c.normal;
  c.friction = contact::friction_coefficient(hit.friction, step_ > 0 ? sliding.norm() / step_ : 0);
  if (hit.friction.vc > 0) c.greatest_shear = hit.friction.vc * hit.area;
  if (!(approach > 0)) return std::nullopt;
  return c;
}

bool ConstraintContact::add_constraints() {
  const std::vector<ConstraintOrigin> known = constraints_.sorted_origins();
  const std::size_t before = constraints_.size();
  for (std::uint32_t i = 0; i < interfaces_.size(); ++i) {
    if (!interfaces_[i].active) continue;
    for (std::uint32_t p = 0; p < interfaces_[i].passes.size(); ++p)
      for (const ConstraintPass::Hit& hit : interfaces_[i].passes[p]->find_hits()) {
        const ConstraintOrigin origin{i, p, hit.slot, hit.area};
        if (std::binary_search(known.begin(), known.end(), origin, ConstraintOrigin::before)) continue;
        if (const auto constraint = constraint_of(hit)) constraints_.add(*constraint, origin);
      }
  }
  return constraints_.size() > before;
}

void ConstraintContact::react(const State& state, double mean, double next, Forces& net, Forces& external) {
  constraints_.add_work(state, states_);
  constraints_.clear();
  step_ = next;
  predict_motion(state, mean, next, net);
  for (int round = 0; round < most_reaction_rounds; ++round) {
    renew_candidates();
    if (!add_constraints()) break;
    solution_ = solve_constraints(constraints_.constraints(), response_);
    for (const std::uint32_t n : nodes_) at_[n] = state.x[n] + way_[n] + response_.moved[n];
  }
  // Without a push there is no force and no contact.
  constraints_.remove_idle();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    ContactState& result = states_[i];
    for (Vector* sum : {&result.force_a, &result.force_b, &result.moment_a, &result.moment_b}) sum->setZero();
    result.touching = result.released = 0;
    for (const auto& pass : interfaces_[i].passes) result.released += pass->released();
  }
  for (const std::uint32_t n : nodes_) at_[n] = state.x[n];
  constraints_.add_forces(at_, net, external, states_);
  constraints_.add_work(state, states_);
}

void ConstraintContact::absorbed(Absorbed& work) const {
  for (const ContactState& state : states_) {
    work.contact_friction += state.friction;
    work.contact_normal += state.energy_a + state.energy_b - state.friction;
  }
}

std::vector<ContactNode> ConstraintContact::nodes(std::size_t position) const {
  std::vector<ContactNode> all;
  constraints_.add_nodes(position, all);
  for (const auto& pass : interfaces_[position].passes) pass->add_released(all);
  return all;
}

void ConstraintContact::links(std::size_t position, std::vector<ContactLink>& links) const {
  constraints_.add_links(position, links);
}

}  // namespace gapcheck::solver
