#include "audit/shared/sliding_energy.hpp"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

namespace gapcheck::audit {
namespace {

/// One unit of the last of `digits` digits.
double printed_unit(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return 0;
  return std::pow(10.0, std::floor(std::log10(std::abs(value))) - (digits - 1));
}

void add(SlidingHistory& history, const SlidingState& state) {
  if (std::isfinite(state.energy)) history.states.push_back(state);
}

std::vector<SlidingHistory> of_contacts(const RunContext& context) {
  constexpr int digits = 4;
  std::vector<SlidingHistory> list;
  std::unordered_map<std::int64_t, std::size_t> places;
  for (const results::InterfaceStates& state : context.files().sleout.states)
    for (const results::InterfaceState& contact : state.contacts) {
      if (!context.chosen(contact.contact)) continue;
      const auto [place, is_new] = places.try_emplace(contact.contact, list.size());
      if (is_new) list.emplace_back().contact = contact.contact;
      const double error = printed_unit(contact.energy[0], digits) + printed_unit(contact.energy[1], digits) +
                           printed_unit(contact.friction, digits);
      add(list[place->second], {state.time, contact.energy[0] + contact.energy[1] - contact.friction, error});
    }
  return list;
}

}  // namespace

std::vector<SlidingHistory> sliding_energies(const RunContext& context) {
  if (!context.files().sleout.states.empty()) return of_contacts(context);
  if (context.files().glstat.empty()) return {};
  SlidingHistory all;
  all.file = "glstat";
  all.without_friction = false;
  for (const results::GlobalState& state : context.files().glstat)
    add(all, {state.time, state.sliding, printed_unit(state.sliding, 6)});
  return {all};
}

std::string share_text(double energy, const ReferenceEnergy& reference) {
  return fmt::format("{:.4g} % of {}", 100 * (energy / reference.value), reference.words());
}

}  // namespace gapcheck::audit
