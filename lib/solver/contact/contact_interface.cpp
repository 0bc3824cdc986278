#include "solver/contact/contact_interface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/edge/edge_scene.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/contact/contact_pass.hpp"
#include "solver/contact/curve_rule.hpp"
#include "solver/contact/edge_pass.hpp"
#include "solver/mortar/mortar_pass.hpp"

namespace gapcheck::solver {

using contact::NodeContact;

namespace {

/// SOFT = 2 updates the step if it has grown by more than this (contact rules, section 6.4).
constexpr double step_growth = 1.05;

NodeContact memory_of(const Penetration& record) {
  switch (record.outcome) {
    case Outcome::moved:
    case Outcome::forced:
      return {NodeContact::State::touching, 0};
    case Outcome::kept:
      return {NodeContact::State::touching, record.depth};
    case Outcome::released:
      return {NodeContact::State::released, 0};
    case Outcome::reported:
      return {};
  }
  return {};
}

bool is_shifted(const contact::ContactSide& side) {
  return !side.selection.segments.offset.empty() || !side.nodes.shift.empty();
}

/// DTSTIF; 0: not given. Mortar contacts have MPAR2 in its place.
double fixed_step(const model::Contact& contact) { return contact.options.mortar ? 0 : std::max(0.0, contact.dtstif); }

bool is_tiebreak(const model::Contact& contact) { return choose_method(contact).method == ContactMethod::tiebreak; }

}  // namespace

ContactInterface::ContactInterface(const ContactSetting& setting, contact::SurfaceStore& store,
                                   contact::SideCache& sides, ContactIndex contact, bool moved, const State& state)
    : setting_(setting),
      x_(state.x),
      contact_(contact),
      times_(setting.model, setting.model.contact(contact)),
      first_step_(state.manual_step) {
  if (card().airbag_thickness > 0) thickness_ = &setting.model.curves.at(card().lcidab);
  searched_thickness_ = card().airbag_thickness;
  build_surfaces(store, sides, moved, state.x);
  if (!may_wait()) begin_passes();
  if (!surfaces_->type.by_segments()) return;
  step_ = fixed_step(card()) > 0 ? 0 : first_step_;
  crossings_ = std::make_unique<SegmentCrossings>(card().dtpchk);
}

ContactInterface::ContactInterface(const ContactInterface& other, ContactIndex contact, const InterfaceMemory& memory)
    : setting_(other.setting_),
      x_(other.x_),
      contact_(contact),
      own_(std::make_unique<contact::ContactSurfaces>(*other.surfaces_)),
      times_(other.times_),
      active_(memory.active),
      first_step_(other.first_step_) {
  surfaces_ = own_.get();
  begin_passes();
  for (std::size_t k = 0; k < passes_.size(); ++k) passes_[k]->continue_as(*other.passes_[k], *memory.passes[k]);
}

bool ContactInterface::can_be_shared() const {
  return thickness_ == nullptr && !is_tiebreak(card()) &&
         std::all_of(passes_.begin(), passes_.end(), [](const auto& pass) { return pass->memory() != nullptr; });
}

InterfaceMemory ContactInterface::memory() const {
  InterfaceMemory memory;
  memory.active = active_;
  for (const auto& pass : passes_) memory.passes.push_back(pass->memory());
  return memory;
}

void ContactInterface::build_surfaces(contact::SurfaceStore& store, contact::SideCache& sides, bool moved,
                                      const std::vector<Vector>& x) {
  if (is_tiebreak(card()))
    set_own_surfaces(store.build(contact::after_failure(card()), x, &sides));
  else if (acts_by_curve(card()))
    set_own_surfaces(store.build(contact::as_oriented_type(card()), x, &sides));
  else if (moved || thickness_ != nullptr)
    set_own_surfaces(store.build(contact_, x, &sides));
  else
    surfaces_ = &store.at(contact_);
  if (surfaces_->type.code == contact::ContactCode::single_edge)
    set_own_surfaces(contact::free_edge_surface(setting_.model, contact_, *surfaces_, x));
}

void ContactInterface::set_own_surfaces(const contact::ContactSurfaces& surfaces) {
  if (thickness_ != nullptr) inflated_ = std::make_shared<contact::ContactSide>(surfaces.a);
  own_ = std::make_unique<contact::ContactSurfaces>(thickness_ != nullptr ? surfaces.with_a(inflated_) : surfaces);
  surfaces_ = own_.get();
}

bool ContactInterface::may_wait() const {
  const contact::ContactType& type = surfaces_->type;
  const bool oriented = type.family == contact::Family::old || type.family == contact::Family::forming;
  if (thickness_ != nullptr || is_tiebreak(card()) || oriented || !surfaces_->two_sided() || type.by_segments() ||
      contact::looks_at_edges(card(), type) || has_offsets())
    return false;
  const auto of_shells = [](const contact::ContactSide& side) {
    const std::vector<contact::SegmentKind>& kinds = side.selection.segments.kind;
    return std::all_of(kinds.begin(), kinds.end(),
                       [](contact::SegmentKind kind) { return kind == contact::SegmentKind::shell; });
  };
  return of_shells(surfaces_->a) && of_shells(surfaces_->b);
}

bool ContactInterface::sides_are_near(double margin) const {
  // More than rounding, and than the tolerance of a penetration.
  constexpr double slack = 1 + 1e-6;
  std::array<contact::Bounds, 2> box;
  double reach = margin;
  for (const bool second : {false, true}) {
    const contact::ContactSide& side = second ? surfaces_->b : surfaces_->a;
    double half = 0;
    for (const auto* const halves : {&side.nodes.half, &side.selection.segments.half})
      for (const double of_one : *halves) half = std::max(half, of_one);
    reach += half;
    for (const NodeIndex node : side.nodes.node) box[second].add(x_[node.value]);
    for (const model::SegmentNodes& corners : side.selection.segments.nodes)
      for (const NodeIndex node : corners) box[second].add(x_[node.value]);
  }
  const Vector gap = (box[0].low - box[1].high).cwiseMax(box[1].low - box[0].high);
  return !(gap.maxCoeff() > reach * slack);
}

void ContactInterface::begin_passes() {
  if (!passes_.empty()) return;
  add_passes();
  set_timestep(stiffness_step());
  for (const auto& pass : passes_)
    if (active_) pass->set_followed();
}

double ContactInterface::stiffness_step() const {
  const double fixed = fixed_step(card());
  return fixed > 0 ? fixed : step_ > 0 ? step_ : first_step_;
}

std::vector<const ContactPass*> ContactInterface::node_passes() const {
  std::vector<const ContactPass*> list;
  for (const auto& pass : passes_)
    if (const auto* const nodes = dynamic_cast<const ContactPass*>(pass.get())) list.push_back(nodes);
  return list;
}

void ContactInterface::add_passes() {
  const contact::ContactSurfaces& surfaces = *surfaces_;
  if (surfaces.type.pairing == contact::Pairing::mortar) {
    passes_.push_back(std::make_unique<MortarPass>(setting_, contact_, surfaces, x_));
    return;
  }
  const auto add_nodes_in_segments = [&](bool exchanged) {
    passes_.push_back(std::make_unique<ContactPass>(setting_, contact_, surfaces, exchanged, x_));
  };
  if (!surfaces.type.only_edges()) add_nodes_in_segments(false);
  if (is_tiebreak(card())) return;
  if (surfaces.type.treatment == contact::Treatment::two_way || (surfaces.type.by_segments() && surfaces.two_sided()))
    add_nodes_in_segments(true);
  if (contact::looks_at_edges(card(), surfaces.type))
    passes_.push_back(std::make_unique<EdgePass>(setting_, contact_, surfaces, x_));
}

bool ContactInterface::has_offsets() const { return is_shifted(surfaces_->a) || is_shifted(surfaces_->b); }

void ContactInterface::set_memories(std::span<const Penetration> found) {
  const auto before = [](const Penetration& record, ContactIndex contact) { return record.contact < contact.value; };
  auto record = std::lower_bound(found.begin(), found.end(), contact_, before);
  if (record != found.end() && record->contact == contact_.value) begin_passes();
  for (; record != found.end() && record->contact == contact_.value; ++record)
    for (const auto& pass : passes_) pass->set_memory(*record, memory_of(*record));
}

void ContactInterface::set_timestep(double timestep) {
  for (const auto& pass : passes_) pass->set_timestep(timestep);
}

void ContactInterface::erode(contact::SurfaceStore& store, const contact::GoneElements& gone, const State& state,
                             ContactState& result) {
  const bool rims = surfaces_->type.code == contact::ContactCode::single_edge;
  const contact::ContactSurfaces& now = rims ? store.at(contact_) : *surfaces_;
  const contact::ContactSurfaces left = store.erode(contact_, now, gone, state.x);
  const std::unique_ptr<contact::ContactSurfaces> old = std::move(own_);  // the old passes still use it
  const std::vector<std::unique_ptr<InterfacePass>> before = std::exchange(passes_, {});
  set_own_surfaces(rims ? contact::free_edge_surface(setting_.model, contact_, left, state.x) : left);
  if (before.empty()) return;
  add_passes();
  set_timestep(stiffness_step());
  for (std::size_t k = 0; k < passes_.size(); ++k) passes_[k]->continue_from(*before[k], state, result);
}

void ContactInterface::find_candidates(double margin, ContactCounters& counters) {
  if (passes_.empty() && sides_are_near(margin)) begin_passes();
  for (const auto& pass : passes_) pass->find_candidates(margin, counters);
  if (thickness_ != nullptr) searched_thickness_ = present_thickness_;
}

double ContactInterface::update_thickness(double time) {
  if (thickness_ == nullptr) return 0;
  present_thickness_ = thickness_->at(time);
  std::fill(inflated_->nodes.half.begin(), inflated_->nodes.half.end(), present_thickness_ / 2);
  contact::Segments& segments = inflated_->selection.segments;
  std::fill(segments.half.begin(), segments.half.end(), present_thickness_ / 2);
  return present_thickness_ - searched_thickness_;
}

std::optional<ContactEvent> ContactInterface::follow_step(const State& state) {
  if (step_ > 0 && std::isfinite(state.manual_step) && state.manual_step > step_growth * step_) {
    step_ = state.manual_step;
    set_timestep(step_);
  }
  for (const auto& pass : passes_)
    if (std::string text = pass->take_message(); !text.empty())
      return ContactEvent{contact_, state.time, std::move(text)};
  if (crossings_ == nullptr) return std::nullopt;
  return crossings_->check(setting_.model, contact_, *surfaces_, state);
}

void ContactInterface::deactivate(const State& state, ContactState& result) {
  if (active_)
    for (const auto& pass : passes_) pass->deactivate(state, result);
  active_ = false;
}

}  // namespace gapcheck::solver
