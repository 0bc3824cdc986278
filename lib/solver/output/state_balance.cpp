#include "solver/output/state_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gapcheck::solver {
namespace {

bool has_failed(const ShellElements& shells, std::size_t i) { return shells.failed(i); }
bool has_failed(const SolidElements& solids, std::size_t i) { return solids.failed(i); }
bool has_failed(const BeamElements& beams, std::size_t i) { return beams.failed(i); }
bool has_failed(const ThickShellElements& shells, std::size_t i) { return shells.failed(i); }

/// The elements of one kind, by part. What failed elements took is gone.
template <class Elements>
void add_parts(HeldEnergy::Kind kind, const Elements& elements, const std::vector<PartIndex>& part_of, const Run& run,
               std::vector<HeldEnergy>& held) {
  const std::vector<Vector>& x = run.stepper().state().x;
  std::map<PartIndex, HeldEnergy> parts;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    HeldEnergy& part = parts[part_of[elements.origin(i)]];
    const ElementEnergy& energy = elements.energy(i);
    const double supplied = energy.initial + energy.sum();
    part.work += supplied;
    part.state += has_failed(elements, i) ? supplied : elements.stored(i, x) + energy.dissipated;
  }
  for (auto& [part, energy] : parts) {
    energy.kind = kind;
    energy.id = run.model().part(part).id.value;
    held.push_back(energy);
  }
}

/// The contacts, each once even if several sources calculate it. Friction and damping only dissipate.
void add_contacts(const Run& run, std::vector<HeldEnergy>& held) {
  const std::size_t first = held.size();
  for (const ContactView& view : run.contacts()) {
    const ContactState& contact = view.state();
    const std::int64_t id = run.model().contact(contact.contact).id.value;
    if (held.size() == first || held.back().id != id) held.push_back({HeldEnergy::Kind::contact, id});
    HeldEnergy& sum = held.back();
    const std::optional<double> stored = view.stored();
    sum.work += contact.work();
    sum.state += stored ? *stored + contact.friction + contact.damping + contact.lost : std::max(contact.work(), 0.0);
    sum.covered = sum.covered && stored;
  }
}

}  // namespace

double StateBalance::created() const {
  double sum = 0;
  for (const HeldEnergy& one : held) sum += one.created();
  return sum;
}

std::vector<HeldEnergy> StateBalance::faults(double tolerance) const {
  std::vector<HeldEnergy> list;
  for (const HeldEnergy& one : held)
    if (std::abs(one.created()) > tolerance * largest) list.push_back(one);
  std::stable_sort(list.begin(), list.end(), [](const HeldEnergy& a, const HeldEnergy& b) {
    return std::abs(a.created()) > std::abs(b.created());
  });
  return list;
}

StateBalance state_balance(const Run& run) {
  const Stepper& stepper = run.stepper();
  const Structure& structure = stepper.structure();
  const model::Mesh& mesh = run.model().mesh;
  StateBalance balance;
  add_parts(HeldEnergy::Kind::shells, structure.shells, mesh.shells.part, run, balance.held);
  add_parts(HeldEnergy::Kind::solids, structure.solids, mesh.solids.part, run, balance.held);
  add_parts(HeldEnergy::Kind::beams, structure.beams, mesh.beams.part, run, balance.held);
  add_parts(HeldEnergy::Kind::thick_shells, structure.thick_shells, mesh.thick_shells.part, run, balance.held);
  const Energies& energies = stepper.energies();
  const double springs = stepper.held().springs;
  if (springs != 0 || energies.absorbed.springs != 0)
    balance.held.push_back({HeldEnergy::Kind::springs, 0, energies.absorbed.springs, springs});
  add_contacts(run, balance.held);
  balance.largest = stepper.largest_energy();
  const double supplied = energies.printed_initial + energies.external;
  // What is printed leaves out the work of the bulk viscosity; it has been dissipated all the same.
  balance.ratio =
      supplied == 0 ? 1 : energies.printed_ratio() + (energies.bulk_viscosity + balance.created()) / supplied;
  return balance;
}

std::string name(const HeldEnergy& held) {
  switch (held.kind) {
    case HeldEnergy::Kind::shells:
      return fmt::format("shells of part {}", held.id);
    case HeldEnergy::Kind::solids:
      return fmt::format("solids of part {}", held.id);
    case HeldEnergy::Kind::beams:
      return fmt::format("beams of part {}", held.id);
    case HeldEnergy::Kind::thick_shells:
      return fmt::format("thick shells of part {}", held.id);
    case HeldEnergy::Kind::contact:
      return fmt::format("contact {}", held.id);
    case HeldEnergy::Kind::springs:
      break;
  }
  return "discrete springs";
}

}  // namespace gapcheck::solver
