#include "audit/fix/judgement.hpp"

#include <algorithm>
#include <utility>

#include "audit/fix/gaps.hpp"
#include "audit/fix/move_start.hpp"

namespace gapcheck::audit {

Judgement ContactJudge::at(const std::vector<Vector>& x) {
  model_.mesh.nodes.x = x;
  surfaces_.emplace(model_);
  contact::InitialOptions options;
  options.nodes_stay = true;
  options.repeated = false;
  contact::InitialCounters counters;
  Judgement now;
  now.state = contact::initialise_contacts(model_, *surfaces_, options, counters);
  now.counts.reserve(now.state.contacts.size());
  for (ContactSummary& summary : now.state.contacts) {
    if (!summary.not_checked.empty())
      now.not_checked.emplace(to_index<ContactIndex>(now.counts.size()), std::move(summary.not_checked));
    now.counts.push_back({summary.penetrations, summary.released, summary.max_penetration});
  }
  std::vector<ContactSummary>().swap(now.state.contacts);
  now.work = counters.sweep.candidate_pairs + x.size();
  for (const Penetration& record : now.state.penetrations) {
    if (!to_be_fixed(record.kind)) continue;
    ++now.penetrating;
    now.depth += record.depth;
    now.deepest = std::max(now.deepest, record.depth);
  }
  return now;
}

bool BestMove::take(const std::vector<Vector>& x, const std::vector<Vector>& as_written, Judgement&& now,
                    double moved) {
  const bool as_crossed = now.crossings == judgement.crossings;
  const bool fewer = now.crossings < judgement.crossings || (as_crossed && now.penetrating < judgement.penetrating);
  const bool as_many = as_crossed && now.penetrating == judgement.penetrating;
  const bool less = as_many && now.depth < judgement.depth * (1 - move_rounding);
  const bool same = as_many && now.depth <= judgement.depth * (1 + move_rounding);
  if (!fewer && !less && !(same && moved <= movement)) return false;
  target = x;
  written = as_written;
  judgement = std::move(now);
  movement = moved;
  return fewer || less;
}

}  // namespace gapcheck::audit
