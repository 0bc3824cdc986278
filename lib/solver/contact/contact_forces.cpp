#include "solver/contact/contact_forces.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "contact/surface/erosion.hpp"

namespace gapcheck::solver {
namespace {

/// Clears the sums of one cycle; energies and moves accumulate over the run.
void clear_sums(ContactState& result) {
  result.force_a.setZero();
  result.force_b.setZero();
  result.moment_a.setZero();
  result.moment_b.setZero();
  result.touching = result.released = 0;
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
      setting_{model, masses_, *search_, ties_, movable_, shared_} {
  for (const contact::JudgedNode& node : initial.judged)
    if (node.tied()) ties_.add(node.node, node.segment_part);
}

void ContactForces::build(const State& state) {
  SearchMargin margin;
  contact::SideCache sides;
  for (const ContactIndex c : positions<ContactIndex>(model_.contacts.size())) {
    const model::Contact& contact = model_.contact(c);
    if (!calculates(contact)) continue;
    ContactInterface& interface = interfaces_.emplace_back(setting_, store_, sides, c, moved_, state);
    interface.set_memories(found_);
    const contact::ContactSurfaces& surfaces = interface.surfaces();
    for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) margin.add(side->selection.segments, state.x);
    if (contact.bsort > 0 && (sort_interval_ == 0 || contact.bsort < sort_interval_)) sort_interval_ = contact.bsort;
    // Offset mid-surfaces rotate with their segments and may come closer by more than any node moves.
    if (interface.has_offsets()) sort_interval_ = 1;
    ContactState& result = states_.emplace_back();
    result.contact = c;
    result.single_surface = surfaces.type.treatment == contact::Treatment::single_surface;
  }
  gather_nodes();
  limit_step();
  margin_.set_margin(margin.value());
  built_ = true;
}

void ContactForces::gather_nodes() {
  std::vector<bool> in_contact(model_.mesh.nodes.size(), false);
  for (const ContactInterface& interface : interfaces_)
    for (const contact::ContactSide* side : {&interface.surfaces().a, &interface.surfaces().b}) {
      for (const NodeIndex node : side->nodes.node) in_contact[node.value] = true;
      for (const auto& corners : side->selection.segments.nodes)
        for (const NodeIndex node : corners) in_contact[node.value] = true;
    }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < in_contact.size(); ++node)
    if (in_contact[node]) nodes.push_back(node);
  margin_.set_nodes(std::move(nodes));
}

void ContactForces::limit_step() {
  stable_step_ = std::numeric_limits<double>::infinity();
  if (model_.controls.ecdt != 0) return;
  for (const ContactInterface& interface : interfaces_) {
    const contact::ContactSurfaces& surfaces = interface.surfaces();
    if (!contact::is_eroding(surfaces.type)) continue;
    if (!estimate_) estimate_ = std::make_unique<contact::TimestepEstimate>(model_, masses_.sizes);
    const model::Contact& contact = interface.card();
    for (const auto& [side, scale] : {std::pair(&surfaces.a, contact.sfs), std::pair(&surfaces.b, contact.sfm)})
      stable_step_ =
          std::min(stable_step_, estimate_->side(side->selection.segments, model_.controls.slsfac * scale).timestep);
  }
}

void ContactForces::erode(const State& state) {
  failures_ = state.failed.count;
  const contact::GoneElements gone{state.failed.shells, state.failed.solids};
  for (std::size_t i = 0; i < interfaces_.size(); ++i) interfaces_[i].erode(store_, gone, state, states_[i]);
  gather_nodes();
  limit_step();
}

bool ContactForces::search_is_due(const State& state) const {
  const auto interval = static_cast<std::uint64_t>(sort_interval_);
  return released_ || !(margin_.used() <= margin_.margin()) || (interval > 0 && state.cycle >= searched_ + interval);
}

void ContactForces::find_candidates(const State& state) {
  const Stopwatch watch(counters_.search_s);
  ++counters_.searches;
  margin_.reset(state);
  for (ContactInterface& interface : interfaces_) interface.find_candidates(margin_.margin(), counters_);
  used_at_search_.assign(interfaces_.size(), 0);
  searched_ = state.cycle;
  released_ = false;
}

void ContactForces::find_candidates_again(std::size_t i) {
  const Stopwatch watch(counters_.search_s);
  interfaces_[i].find_candidates(margin_.margin(), counters_);
  used_at_search_[i] = margin_.used();
}

double ContactForces::used_since_search(std::size_t i) const {
  const double before = used_at_search_[i], now = margin_.used();
  return before > 0 ? now * rounding_of_motion - before : now;
}

void ContactForces::release(NodeIndex node, PartIndex part) {
  ties_.remove(node, part);
  released_ = true;
}

void ContactForces::add(State& state, Forces& forces) {
  const bool first = !built_;
  if (first) build(state);
  if (interfaces_.empty()) return;
  if (!first) margin_.add_step(state);
  const bool eroded = state.failed.count != failures_;
  if (eroded) erode(state);
  if (first || eroded || search_is_due(state)) find_candidates(state);
  const Stopwatch watch(counters_.force_s);
  for (std::size_t i = 0; i < interfaces_.size(); ++i) advance_interface(i, state, forces);
}

void ContactForces::advance_interface(std::size_t i, State& state, Forces& forces) {
  ContactInterface& interface = interfaces_[i];
  ContactState& result = states_[i];
  clear_sums(result);
  if (!interface.acts_at(state.time)) {
    interface.deactivate(state, result);
    return;
  }
  interface.activate();
  if (auto event = interface.follow_step(state)) events_.push_back(std::move(*event));
  for (const auto& pass : interface.passes()) {
    // A node moved by a pass is nearer to something than the search knew; so is one that has become thicker. Only this
    // contact is searched again: if each of many contacts moves nodes, searching all would take the square of the time.
    double used = used_since_search(i) + interface.update_thickness(state.time);
    if (!(used <= margin_.margin())) {
      find_candidates_again(i);
      used = 0;
    }
    // It may be the node or a corner of the segment, or both.
    margin_.add(2 * pass->advance_state(state, used, counters_) * rounding_of_motion);
    pass->add_forces(state, forces, result);
    if (state.cycle == 0) result.lost -= pass->stored();
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
  for (const auto& pass : interfaces_[position].passes()) {
    const std::vector<ContactNode> more = pass->nodes();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::optional<double> ContactForces::stored(std::size_t position) const {
  double sum = 0;
  for (const auto& pass : interfaces_[position].passes()) sum += pass->stored();
  return sum;
}

void ContactForces::links(std::size_t position, std::vector<ContactLink>& links) const {
  for (const auto& pass : interfaces_[position].passes()) pass->add_links(links);
}

}  // namespace gapcheck::solver
