#include "solver/contact/contact_forces.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "contact/definition/repeated_contacts.hpp"
#include "contact/search/choose_search.hpp"
#include "contact/surface/erosion.hpp"
#include "solver/contact/curve_rule.hpp"

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

std::span<const Penetration> of_contact(std::span<const Penetration> found, ContactIndex contact) {
  return {std::ranges::lower_bound(found, contact.value, {}, &Penetration::contact),
          std::ranges::upper_bound(found, contact.value, {}, &Penetration::contact)};
}

/// Whether the initialisation has found the same in two contacts; `found`: sorted by contact.
bool same_found(std::span<const Penetration> found, ContactIndex a, ContactIndex b) {
  return std::ranges::equal(of_contact(found, a), of_contact(found, b), [](const Penetration& p, const Penetration& q) {
    return p.node == q.node && p.segment == q.segment && p.segment_number == q.segment_number &&
           p.element == q.element && p.depth == q.depth && p.outcome == q.outcome && p.kind == q.kind;
  });
}

/// Of both sides of all interfaces, ascending.
std::vector<std::uint32_t> nodes_in_contact(std::span<const ContactInterface> interfaces, std::size_t nodes) {
  std::vector<bool> in_contact(nodes, false);
  for (const ContactInterface& interface : interfaces)
    for (const contact::ContactSide* side : {&interface.surfaces().a, &interface.surfaces().b}) {
      for (const NodeIndex node : side->nodes.node) in_contact[node.value] = true;
      for (const auto& corners : side->selection.segments.nodes)
        for (const NodeIndex node : corners) in_contact[node.value] = true;
    }
  std::vector<std::uint32_t> list;
  for (std::uint32_t node = 0; node < in_contact.size(); ++node)
    if (in_contact[node]) list.push_back(node);
  return list;
}

/// What each pass of an interface has, one after the other; `list`: a member of the passes.
template <class Each>
std::vector<Each> of_passes(const ContactInterface& interface, std::vector<Each> (InterfacePass::*list)() const) {
  std::vector<Each> all;
  for (const auto& pass : interface.passes()) {
    const std::vector<Each> more = ((*pass).*list)();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::optional<double> stored_in(const ContactInterface& interface) {
  // What a curve stores does not follow from the state where unloading differs from loading.
  if (acts_by_curve(interface.card())) return std::nullopt;
  double sum = 0;
  for (const auto& pass : interface.passes()) sum += pass->stored();
  return sum;
}

/// Interfaces to which nothing has been near so far.
std::size_t count_waiting(std::span<const ContactInterface> interfaces) {
  const auto waits = [](const ContactInterface& interface) { return interface.passes().empty(); };
  return static_cast<std::size_t>(std::ranges::count_if(interfaces, waits));
}

/// For the springs of eroding types. `estimate` is made when it is needed.
double eroding_step(std::span<const ContactInterface> interfaces, const model::Model& model,
                    const ContactMasses& masses, std::unique_ptr<contact::TimestepEstimate>& estimate) {
  double step = std::numeric_limits<double>::infinity();
  if (model.controls.ecdt != 0) return step;
  for (const ContactInterface& interface : interfaces) {
    const contact::ContactSurfaces& surfaces = interface.surfaces();
    if (!contact::is_eroding(surfaces.type)) continue;
    if (!estimate) estimate = std::make_unique<contact::TimestepEstimate>(model, masses.sizes);
    const model::Contact& contact = interface.card();
    for (const auto& [side, scale] : {std::pair(&surfaces.a, contact.sfs), std::pair(&surfaces.b, contact.sfm)})
      step = std::min(step, estimate->side(side->selection.segments, model.controls.slsfac * scale).timestep);
  }
  return step;
}

void add_works(const ContactState& state, Absorbed& work) {
  work.contact_friction += state.friction;
  work.contact_damping += state.damping;
  work.contact_normal += state.energy_a + state.energy_b - state.friction - state.damping;
}

}  // namespace

ContactForces::ContactForces(const model::Model& model, contact::SurfaceStore& surfaces,
                             const contact::InitialState& initial, std::vector<bool> movable, SpringFormula formula)
    : model_(model),
      store_(surfaces),
      found_(initial.penetrations),
      moved_(initial.x != model.mesh.nodes.x),
      movable_(std::move(movable)),
      masses_(model, formula),
      search_(contact::make_repeated_search()),
      ties_(model),
      setting_{model, masses_, *search_, ties_, movable_, shared_} {
  for (const contact::JudgedNode& node : initial.judged)
    if (node.tied()) ties_.add(node.node, node.segment_part);
}

void ContactForces::build(const State& state) {
  SearchMargin margin;
  Building building{{}, contact::repeated_contacts(model_), {}};
  for (const ContactIndex first : building.first)
    if (first != none<ContactIndex>) building.last.try_emplace(first);
  const auto count =
      static_cast<std::size_t>(std::count_if(model_.contacts.begin(), model_.contacts.end(), calculates));
  interface_of_.reserve(count);
  states_.reserve(count);
  interfaces_.reserve(count);
  for (const ContactIndex c : positions<ContactIndex>(model_.contacts.size())) {
    const model::Contact& contact = model_.contact(c);
    if (!calculates(contact)) continue;
    add_interface(c, building, state);
    const ContactInterface& interface = interfaces_[interface_of_.back()];
    const contact::ContactSurfaces& surfaces = interface.surfaces();
    for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) margin.add(side->selection.segments, state.x);
    if (contact.bsort > 0 && (sort_interval_ == 0 || contact.bsort < sort_interval_)) sort_interval_ = contact.bsort;
    // Offset mid-surfaces rotate with their segments and may come closer by more than any node moves.
    if (interface.has_offsets()) sort_interval_ = 1;
    ContactState& result = states_.emplace_back();
    result.contact = c;
    result.single_surface = surfaces.type.treatment == contact::Treatment::single_surface;
  }
  follow_surfaces();
  margin_.set_margin(margin.value());
  built_ = true;
}

void ContactForces::add_interface(ContactIndex contact, Building& building, const State& state) {
  const auto position = static_cast<std::uint32_t>(interface_of_.size());
  const ContactIndex first = building.first[contact.value];
  const auto last = building.last.find(first == none<ContactIndex> ? contact : first);
  if (first != none<ContactIndex> && last != building.last.end()) {
    const std::uint32_t number = interface_of_[last->second];
    ContactInterface& known = interfaces_[number];
    known.begin_passes();
    if (known.can_be_shared() && same_found(found_, known.contact(), contact)) {
      interface_of_.push_back(number);
      std::vector<std::uint32_t>& positions = sharing_[number].positions;
      if (positions.empty()) positions.push_back(last->second);
      return positions.push_back(position);
    }
  }
  interface_of_.push_back(static_cast<std::uint32_t>(interfaces_.size()));
  interfaces_.emplace_back(setting_, store_, building.sides, contact, moved_, state).set_memories(found_);
  if (last != building.last.end()) last->second = position;
}

void ContactForces::follow_surfaces() {
  margin_.set_nodes(nodes_in_contact(interfaces_, model_.mesh.nodes.size()));
  stable_step_ = eroding_step(interfaces_, model_, masses_, estimate_);
}

void ContactForces::erode(const State& state) {
  failures_ = state.failed.count;
  const contact::GoneElements gone{state.failed.shells, state.failed.solids, state.failed.beams};
  std::vector<bool> done(interfaces_.size(), false);
  for (std::size_t i = 0; i < interface_of_.size(); ++i) {
    const std::uint32_t interface = interface_of_[i];
    if (done[interface])
      repeat_state(i);
    else
      interfaces_[interface].erode(store_, gone, state, states_[i]);
    done[interface] = true;
  }
  follow_surfaces();
}

bool ContactForces::search_is_due(const State& state) const {
  const auto interval = static_cast<std::uint64_t>(sort_interval_);
  return released_ || state.cycle < searched_ || !(margin_.used() <= margin_.margin()) ||
         (interval > 0 && state.cycle >= searched_ + interval);
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

void ContactForces::find_candidates_again(std::uint32_t i) {
  const Stopwatch watch(counters_.search_s);
  interfaces_[i].find_candidates(margin_.margin(), counters_);
  used_at_search_[i] = margin_.used();
}

double ContactForces::used_since_search(std::uint32_t i) const {
  const double before = used_at_search_[i], now = margin_.used();
  return before > 0 ? now * rounding_of_motion - before : now;
}

std::vector<Touch> ContactForces::touches(ContactIndex contact) const {
  const auto at = std::ranges::find(states_, contact, &ContactState::contact);
  if (at == states_.end()) return {};
  const auto position = static_cast<std::size_t>(at - states_.begin());
  return of_passes(interfaces_[interface_of_[position]], &InterfacePass::touches);
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
  for (std::size_t i = 0; i < interface_of_.size(); ++i) advance_contact(i, state, forces);
}

void ContactForces::advance_contact(std::size_t i, State& state, Forces& forces) {
  const auto found = sharing_.empty() ? sharing_.end() : sharing_.find(interface_of_[i]);
  if (found == sharing_.end()) return advance_interface(i, state, forces);
  Shared& shared = found->second;
  if (shared.positions.front() == i) {
    shared.before = interfaces_[found->first].memory();
    shared.moves = moves_;
    return advance_interface(i, state, forces);
  }
  if (shared.moves == moves_) return repeat_interface(i, state, forces);
  part_interface(i);
  advance_contact(i, state, forces);
}

void ContactForces::repeat_interface(std::size_t i, const State& state, Forces& forces) {
  const ContactInterface& interface = interfaces_[interface_of_[i]];
  ContactState unused;
  unused.single_surface = true;
  if (interface.acts_now(state))
    for (const auto& pass : interface.passes()) pass->add_forces(state, forces, unused);
  repeat_state(i);
}

void ContactForces::repeat_state(std::size_t i) {
  const ContactState own = std::exchange(states_[i], states_[sharing_.at(interface_of_[i]).positions.front()]);
  states_[i].contact = own.contact;
}

void ContactForces::part_interface(std::size_t i) {
  const std::uint32_t from = interface_of_[i], to = static_cast<std::uint32_t>(interfaces_.size());
  std::vector<std::uint32_t>& positions = sharing_.at(from).positions;
  const auto at = std::find(positions.begin(), positions.end(), i);
  std::vector<std::uint32_t> later(at, positions.end());
  positions.erase(at, positions.end());
  for (const std::uint32_t position : later) interface_of_[position] = to;
  interfaces_.push_back(ContactInterface(interfaces_[from], states_[i].contact, sharing_.at(from).before));
  used_at_search_.push_back(used_at_search_[from]);
  if (positions.size() == 1) sharing_.erase(from);
  if (later.size() > 1) sharing_[to].positions = std::move(later);
}

void ContactForces::advance_interface(std::size_t i, State& state, Forces& forces) {
  const std::uint32_t number = interface_of_[i];
  ContactInterface& interface = interfaces_[number];
  ContactState& result = states_[i];
  const std::uint64_t moved = result.moved;
  clear_sums(result);
  if (!interface.acts_now(state)) {
    interface.deactivate(state, result);
    return;
  }
  if (interface.passes().empty() && !(used_since_search(number) <= margin_.margin())) find_candidates_again(number);
  interface.activate();
  if (auto event = interface.follow_step(state)) events_.push_back(std::move(*event));
  for (const auto& pass : interface.passes()) {
    // A node moved by a pass is nearer to something than the search knew; so is one that has become thicker. Only this
    // contact is searched again: if each of many contacts moves nodes, searching all would take the square of the time.
    double used = used_since_search(number) + interface.update_thickness(state.time);
    if (!(used <= margin_.margin())) {
      find_candidates_again(number);
      used = 0;
    }
    // It may be the node or a corner of the segment, or both.
    margin_.add(2 * pass->advance_state(state, used, counters_) * rounding_of_motion);
    pass->add_forces(state, forces, result);
    if (state.cycle == 0 && !state.relaxed) result.lost -= pass->stored();
  }
  moves_ += result.moved - moved;
}

void ContactForces::absorbed(Absorbed& work) const {
  for (const ContactState& state : states_) add_works(state, work);
}

std::size_t ContactForces::waiting() const { return count_waiting(interfaces_); }

std::vector<ContactNode> ContactForces::nodes(std::size_t position) const {
  return of_passes(interfaces_[interface_of_[position]], &InterfacePass::nodes);
}

std::optional<double> ContactForces::stored(std::size_t position) const {
  return stored_in(interfaces_[interface_of_[position]]);
}

void ContactForces::links(std::size_t position, std::vector<ContactLink>& links) const {
  for (const auto& pass : interfaces_[interface_of_[position]].passes()) pass->add_links(links);
}

}  // namespace gapcheck::solver
