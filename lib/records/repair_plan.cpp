#include "records/repair_plan.hpp"

#include <numeric>

namespace gapcheck {

std::vector<std::string> RepairPlan::best() const {
  std::vector<std::string> ids;
  for (const RepairPair& pair : pairs) {
    if (!pair.tried || pair.repairs.empty()) continue;
    const Repair& first = pair.repairs.front();
    if (first.outcome.solves() && !changes_the_model(first.kind)) ids.push_back(first.id);
  }
  return ids;
}

std::uint64_t AppliedRepairs::before() const {
  return std::accumulate(contacts.begin(), contacts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Contact& c) { return sum + c.before + c.forgiven_before; });
}

std::uint64_t AppliedRepairs::after() const {
  return std::accumulate(contacts.begin(), contacts.end(), std::uint64_t{0}, [&](std::uint64_t sum, const Contact& c) {
    return sum + c.after + (forgives ? 0 : c.forgiven);
  });
}

}  // namespace gapcheck
