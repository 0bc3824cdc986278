#include "api/part_history.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <unordered_map>

#include "base/vector.hpp"

namespace gapcheck::api {
namespace {

/// The states that count, by time.
std::vector<const results::PartStates*> ascending(const std::vector<results::PartStates>& states) {
  std::vector<const results::PartStates*> list;
  for (const results::PartStates& state : states) {
    while (!list.empty() && !(list.back()->time < state.time)) list.pop_back();
    list.push_back(&state);
  }
  return list;
}

/// Fills the arrays of a history whose parts and times are known.
class PartArrays {
 public:
  explicit PartArrays(PartHistory& to) : to_(to) {
    const std::size_t size = to.times.size() * to.part.size();
    for (std::vector<double>* numbers :
         {&to.internal, &to.kinetic, &to.hourglass, &to.eroded_internal, &to.eroded_hourglass})
      numbers->assign(size, std::numeric_limits<double>::quiet_NaN());
    for (std::vector<double>* numbers : {&to.momentum, &to.velocity})
      numbers->assign(3 * size, std::numeric_limits<double>::quiet_NaN());
  }
  void set(std::size_t entry, const results::PartState& from) {
    to_.internal[entry] = from.internal;
    to_.kinetic[entry] = from.kinetic;
    to_.hourglass[entry] = from.hourglass;
    to_.eroded_internal[entry] = from.eroded_internal;
    to_.eroded_hourglass[entry] = from.eroded_hourglass;
    for (int axis = 0; axis < 3; ++axis) {
      to_.momentum[3 * entry + static_cast<std::size_t>(axis)] = from.momentum[axis];
      to_.velocity[3 * entry + static_cast<std::size_t>(axis)] = from.velocity[axis];
    }
  }

 private:
  PartHistory& to_;
};

}  // namespace

std::optional<PartHistory> part_arrays(const results::PartHistory& history) {
  const std::vector<const results::PartStates*> states = ascending(history.states);
  PartHistory arrays;
  std::unordered_map<std::int64_t, std::size_t> column;
  for (const results::PartStates* state : states) {
    arrays.times.push_back(state->time);
    for (const results::PartState& part : state->parts)
      if (column.try_emplace(part.part, arrays.part.size()).second) arrays.part.push_back(part.part);
  }
  if (arrays.part.empty()) return std::nullopt;
  arrays.title.resize(arrays.part.size());
  for (const results::LegendEntry& entry : history.titles)
    if (const auto found = column.find(entry.id); found != column.end()) arrays.title[found->second] = entry.title;
  PartArrays numbers(arrays);
  for (std::size_t t = 0; t < states.size(); ++t)
    for (const results::PartState& part : states[t]->parts)
      numbers.set(t * arrays.part.size() + column.at(part.part), part);
  return arrays;
}

}  // namespace gapcheck::api
