#include "audit/fix/judgement.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "audit/fix/gaps.hpp"
#include "audit/fix/move_start.hpp"
#include "contact/crossing/crossed_edges.hpp"

namespace gapcheck::audit {

namespace {

/// Mortar contacts that press an overlap out over time: a press fit.
bool is_fit(const model::Contact& contact, const model::Controls& controls) {
  const contact::ContactType type = contact::classify(contact);
  const std::int64_t ignore = std::abs(contact::settings(contact, type, controls).ignore);
  return type.pairing == contact::Pairing::mortar && (ignore == 3 || ignore == 4);
}

}  // namespace

ContactJudge::ContactJudge(model::Model& model) : model_(model), walls_(model) {
  for (const model::Contact& contact : model.contacts) fits_.push_back(is_fit(contact, model.controls) ? 1 : 0);
}

Judgement ContactJudge::at(const std::vector<Vector>& x) {
  model_.mesh.nodes.x = x;
  surfaces_.emplace(model_);
  contact::InitialOptions options;
  options.nodes_stay = true;
  options.repeated = false;
  options.flush = contact::flush_in_runs;  // flush blocks are parted along the faces that press, as in a run
  options.segments = options.mortar = options.edges = true;
  contact::InitialCounters counters;
  Judgement now;
  now.state = contact::initialise_contacts(model_, *surfaces_, options, counters);
  for (std::size_t c = 0; c < now.state.contacts.size(); ++c)
    if (ContactSummary& summary = now.state.contacts[c]; !summary.not_checked.empty())
      now.not_checked.emplace(to_index<ContactIndex>(c), std::move(summary.not_checked));
  std::vector<ContactSummary>().swap(now.state.contacts);
  leave_fits(now);
  add_crossed_edges(now);
  now.walls = walls_.at(x);
  count(now);
  now.work = counters.sweep.candidate_pairs + x.size();
  return now;
}

void ContactJudge::add_crossed_edges(Judgement& now) {
  contact::CrossingCounters counters;
  for (const ContactIndex c : positions<ContactIndex>(model_.contacts.size())) {
    const model::Contact& contact = model_.contact(c);
    const contact::ContactType type = contact::classify(contact);
    if (type.edges || !contact::looks_at_edges(contact, type)) continue;
    const auto records = contact::crossed_edge_records(model_, c, surfaces_->at(c), {}, counters);
    now.state.penetrations.insert(now.state.penetrations.end(), records.begin(), records.end());
  }
}

void ContactJudge::leave_fits(Judgement& now) const {
  std::erase_if(now.state.penetrations, [&](const Penetration& record) {
    if (fits_[record.contact] == 0) return false;
    now.not_checked[ContactIndex{record.contact}] = "its overlap is meant to be pressed out over time (IGNORE = 3, 4)";
    return true;
  });
}

void ContactJudge::count(Judgement& now) const {
  now.counts.resize(model_.contacts.size());
  now.edges.resize(model_.contacts.size());
  const auto add = [&](double depth) {
    ++now.penetrating;
    now.depth += depth;
    now.deepest = std::max(now.deepest, depth);
  };
  for (const Penetration& record : now.state.penetrations) {
    if (!to_be_fixed(record.kind)) continue;
    add(record.depth);
    FixContact::State& contact = now.counts[record.contact];
    if (record.kind == PenetrationKind::released) {
      ++contact.released;
    } else if (record.kind == PenetrationKind::edge) {
      ++now.edges[record.contact];
    } else {
      ++contact.penetrations;
      contact.deepest = std::max(contact.deepest, record.depth);
    }
  }
  for (const WallHit& hit : now.walls) add(hit.depth);
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
