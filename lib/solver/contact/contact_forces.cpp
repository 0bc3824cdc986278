#include "solver/contact/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/definition/active_time.hpp"
#include "contact/edge/edge_scene.hpp"
#include "contact/surface/erosion.hpp"
#include "solver/contact/edge_pass.hpp"
#include "solver/contact/search_margin.hpp"
#include "solver/contact/segment_pass.hpp"

namespace gapcheck::solver {
namespace {

bool has_offsets(const contact::ContactSide& side) {
  return !side.selection.segments.offset.empty() || !side.nodes.shift.empty();
}

using contact::NodeContact;

/// SOFT = 2 takes a new step where it has grown by more than this (contact rules, section 6.4).
constexpr double step_growth = 1.05;

NodeContact memory_of(const Penetration& record) {
  switch (record.outcome) {
    case Outcome::moved:
    case Outcome::forced: return {NodeContact::State::touching, 0};
    case Outcome::kept: return {NodeContact::State::touching, record.depth};
    case Outcome::released: return {NodeContact::State::released, 0};
    case Outcome::reported: return {};
  }
  return {};
}

}  // namespace

ContactForces::ContactForces(const model::Model& model, contact::SurfaceStore& surfaces,
                             const contact::InitialState& initial, std::vector<bool> movable)
    : model_(model),
      store_(surfaces),
      found_(initial.penetrations),
      moved_(initial.x != model.mesh.nodes.x),
      movable_(std::move(movable)),
      masses_(model),
      search_(contact::make_bucket_grid()),
      ties_(model),
      setting_{model, masses_, *search_, ties_, movable_} {
  for (const contact::JudgedNode& node : initial.judged)
    if (node.tied()) ties_.add(node.node, node.segment_part);
}

void ContactForces::remember(Interface& interface) const {
  // Records come contact by contact.
  const auto before = [](const Penetration& record, std::uint32_t contact) { return record.contact < contact; };
  auto record = std::lower_bound(found_.begin(), found_.end(), interface.contact, before);
  for (; record != found_.end() && record->contact == interface.contact; ++record)
    for (const auto& pass : interface.passes) pass->remember(*record, memory_of(*record));
}

void ContactForces::add_passes(Interface& interface, const std::vector<Vector>& x) {
  const contact::ContactSurfaces& surfaces = *interface.surfaces;
  const bool by_segments = surfaces.type.by_segments();
  const auto nodes_in_segments = [&](bool exchanged) {
    if (by_segments)
      interface.passes.push_back(std::make_unique<SegmentPass>(setting_, interface.contact, surfaces, exchanged, x));
    else
      interface.passes.push_back(std::make_unique<ContactPass>(setting_, interface.contact, surfaces, exchanged, x));
  };
  nodes_in_segments(false);
  if (choose_method(model_.contacts[interface.contact]).method == ContactMethod::tiebreak) return;
  if (surfaces.type.treatment == contact::Treatment::two_way || (by_segments && surfaces.two_sided()))
    nodes_in_segments(true);
  if (contact::looks_at_edges(model_.contacts[interface.contact], surfaces.type))
    interface.passes.push_back(std::make_unique<EdgePass>(setting_, interface.contact, surfaces, x));
}

void ContactForces::build(State& state) {
  SearchMargin margin;
  first_step_ = state.coming;
  interfaces_.reserve(model_.contacts.size());  // passes refer to the surfaces in them
  for (std::uint32_t c = 0; c < model_.contacts.size(); ++c) {
    const model::Contact& contact = model_.contacts[c];
    if (!calculates(contact)) continue;
    Interface& interface = interfaces_.emplace_back();
    interface.contact = c;
    if (contact.airbag_thickness > 0) interface.thickness = &model_.curves.at(contact.lcidab);
    const bool tiebreak = choose_method(contact).method == ContactMethod::tiebreak;
    const bool own = moved_ || interface.thickness != nullptr || tiebreak;
    if (own)
      interface.own = std::make_unique<contact::ContactSurfaces>(
          tiebreak ? store_.build(contact::after_failure(contact), state.x) : store_.build(c, state.x));
    interface.surfaces = own ? interface.own.get() : &store_.at(c);
    if (interface.surfaces->type.code == "22") {
      interface.own = std::make_unique<contact::ContactSurfaces>(
          contact::free_edge_surface(model_, c, *interface.surfaces, state.x));
      interface.surfaces = interface.own.get();
    }
    interface.searched_thickness = contact.airbag_thickness;
    const contact::ActiveTime time = contact::active_time(contact);
    interface.start = time.start;
    interface.end = time.end;
    const contact::ContactSurfaces& surfaces = *interface.surfaces;
    for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) margin.add(side->selection.segments, state.x);
    add_passes(interface, state.x);
    for (const auto& pass : interface.passes)
      pass->set_timestep(contact.dtstif > 0 ? contact.dtstif : state.coming);
    if (surfaces.type.by_segments()) {
      interface.step = contact.dtstif > 0 ? 0 : state.coming;
      interface.crossings = SegmentCrossings(contact.dtpchk);
    }
    remember(interface);
    if (contact.bsort > 0 && (sort_interval_ == 0 || contact.bsort < sort_interval_)) sort_interval_ = contact.bsort;
    // Offset mid-surfaces turn with their segments and come closer by more than any node moves.
    if (has_offsets(surfaces.a) || has_offsets(surfaces.b)) sort_interval_ = 1;
    ContactState& result = states_.emplace_back();
    result.contact = c;
    result.single_surface = surfaces.type.treatment == contact::Treatment::single_surface;
  }
  gather_nodes();
  limit_step();
  margin_ = margin.value();
  built_ = true;
}

void ContactForces::gather_nodes() {
  nodes_.clear();
  for (const Interface& interface : interfaces_)
    for (const contact::ContactSide* side : {&interface.surfaces->a, &interface.surfaces->b}) {
      for (const NodeIndex node : side->nodes.node) nodes_.push_back(node.value);
      for (const auto& corners : side->selection.segments.nodes)
        for (const NodeIndex node : corners) nodes_.push_back(node.value);
    }
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

void ContactForces::limit_step() {
  stable_step_ = std::numeric_limits<double>::infinity();
  if (model_.controls.ecdt != 0) return;
  for (const Interface& interface : interfaces_) {
    if (!contact::is_eroding(interface.surfaces->type)) continue;
    if (!estimate_) estimate_ = std::make_unique<contact::TimestepEstimate>(model_, masses_.sizes);
    const model::Contact& contact = model_.contacts[interface.contact];
    for (const auto& [side, scale] :
         {std::pair(&interface.surfaces->a, contact.sfs), std::pair(&interface.surfaces->b, contact.sfm)})
      stable_step_ = std::min(
          stable_step_, estimate_->side(side->selection.segments, model_.controls.slsfac * scale).timestep);
  }
}

void ContactForces::erode(const State& state) {
  failures_ = state.failed.count;
  const contact::GoneElements gone{state.failed.shells, state.failed.solids};
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    Interface& interface = interfaces_[i];
    const bool rims = interface.surfaces->type.code == "22";
    const contact::ContactSurfaces& now = rims ? store_.at(interface.contact) : *interface.surfaces;
    auto left = std::make_unique<contact::ContactSurfaces>(store_.erode(interface.contact, now, gone, state.x));
    if (rims) *left = contact::free_edge_surface(model_, interface.contact, *left, state.x);
    std::vector<std::unique_ptr<InterfacePass>> before;
    before.swap(interface.passes);
    std::swap(interface.own, left);  // the old passes still see the old ones
    interface.surfaces = interface.own.get();
    add_passes(interface, state.x);
    const double fixed = model_.contacts[interface.contact].dtstif;
    const double timestep = fixed > 0 ? fixed : interface.step > 0 ? interface.step : first_step_;
    for (std::size_t k = 0; k < interface.passes.size(); ++k) {
      interface.passes[k]->set_timestep(timestep);
      interface.passes[k]->carry_over(*before[k], state, states_[i]);
    }
  }
  gather_nodes();
  limit_step();
}

double ContactForces::approach(const State& state) const {
  constexpr std::size_t block = 4096;
  const std::size_t blocks = (nodes_.size() + block - 1) / block;
  std::vector<double> fastest(blocks, 0);
  parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
      for (std::size_t i = b * block; i < std::min(nodes_.size(), (b + 1) * block); ++i)
        fastest[b] = std::max(fastest[b], (state.v[nodes_[i]] - drift_).squaredNorm());
  });
  double squared = 0;
  for (const double of_block : fastest) squared = std::max(squared, of_block);
  return 2 * std::sqrt(squared) * state.dt * rounding_of_motion;
}

void ContactForces::follow(Interface& interface, const State& state) {
  if (interface.step > 0 && std::isfinite(state.coming) && state.coming > step_growth * interface.step) {
    interface.step = state.coming;
    for (const auto& pass : interface.passes) pass->set_timestep(interface.step);
  }
  if (auto event = interface.crossings.look(model_, interface.contact, *interface.surfaces, state))
    events_.push_back(std::move(*event));
}

void ContactForces::search(const State& state) {
  const Stopwatch watch(counters_.search_s);
  ++counters_.searches;
  contact::Bounds velocities;
  for (const std::uint32_t node : nodes_) velocities.add(state.v[node]);
  drift_ = (velocities.low + velocities.high) / 2;
  for (Interface& interface : interfaces_)
    for (const auto& pass : interface.passes) pass->search(margin_, counters_);
  for (Interface& interface : interfaces_)
    if (interface.thickness != nullptr) interface.searched_thickness = interface.present_thickness;
  used_ = 0;
  searched_ = state.cycle;
  released_ = false;
}

void ContactForces::release(NodeIndex node, PartIndex part) {
  ties_.remove(node, part);
  released_ = true;
}

double ContactForces::grow(Interface& interface, double time) {
  if (interface.thickness == nullptr) return 0;
  interface.present_thickness = interface.thickness->at(time);
  contact::ContactSide& side = interface.own->a;
  std::fill(side.nodes.half.begin(), side.nodes.half.end(), interface.present_thickness / 2);
  contact::Segments& segments = side.selection.segments;
  std::fill(segments.half.begin(), segments.half.end(), interface.present_thickness / 2);
  return interface.present_thickness - interface.searched_thickness;
}

void ContactForces::add(State& state, Forces& forces) {
  const bool first = !built_;
  if (first) build(state);
  if (interfaces_.empty()) return;
  if (!first) used_ += approach(state);
  const bool eroded = state.failed.count != failures_;
  if (eroded) erode(state);
  const auto due = static_cast<std::uint64_t>(sort_interval_);
  if (first || eroded || released_ || !(used_ <= margin_) || (due > 0 && state.cycle >= searched_ + due)) search(state);
  const Stopwatch watch(counters_.force_s);
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    Interface& interface = interfaces_[i];
    ContactState& result = states_[i];
    result.force_a.setZero();
    result.force_b.setZero();
    result.moment_a.setZero();
    result.moment_b.setZero();
    result.touching = result.released = 0;
    const bool active = state.time >= interface.start && state.time < interface.end;
    if (active) follow(interface, state);
    for (const auto& pass : interface.passes) {
      if (!active) {
        if (interface.active) pass->rest(state, result);
        continue;
      }
      // A node that one pass has moved is nearer to something than the search knew; so is one that has grown thicker.
      double growth = grow(interface, state.time);
      if (!(used_ + growth <= margin_)) {
        search(state);
        growth = 0;
      }
      // It may be the node or a corner of the segment, or both.
      used_ += 2 * pass->update(state, used_ + growth, counters_) * rounding_of_motion;
      pass->apply(state, forces, result);
    }
    interface.active = active;
  }
}

void ContactForces::absorbed(Absorbed& work) const {
  for (const ContactState& state : states_) {
    work.contact_friction += state.friction;
    work.contact_damping += state.damping;
    work.contact_normal += state.energy_a + state.energy_b - state.friction - state.damping;
  }
}

std::vector<ContactNode> ContactForces::nodes(std::size_t position) const {
  std::vector<ContactNode> all;
  for (const auto& pass : interfaces_[position].passes) {
    const std::vector<ContactNode> more = pass->nodes();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

void ContactForces::links(std::size_t position, std::vector<ContactLink>& links) const {
  for (const auto& pass : interfaces_[position].passes) pass->links(links);
}

}  // namespace gapcheck::solver
