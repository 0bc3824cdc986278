#include "audit/fix/mover.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace gapcheck::audit {
namespace {

/// Searches without any progress before giving up.
constexpr std::uint32_t stubborn = 8;
/// After so many, gaps get more clearance.
constexpr std::uint32_t slow = 3;
/// So many in a row that are worse than a state without any penetration end the search for less movement.
constexpr std::uint32_t worse_at_once = 3;
/// New searches with elements held that would cross others; after that nothing is moved at all. Together they may take
/// as much work as the first.
constexpr int crossing_attempts = 6;
/// Coordinates that change by less than this share of the largest move from one solution to the next are settled.
constexpr double settled_share = 1e-4;

}  // namespace

Mover::Mover(model::Model& model, NodeLines& lines, ElementBounds& bounds, const std::vector<Vector>& deck_x,
             Freedoms freedoms, const std::vector<model::HangingNode>& hanging, const FixOptions& options,
             Crossings crossings)
    : model_(model),
      bounds_(bounds),
      hanging_(hanging),
      options_(options),
      judge_(model),
      start_{deck_x, deck_x, std::move(freedoms)},
      writable_(lines, deck_x),
      conditions_(bounds.index()),
      solver_(model.mesh, start_, conditions_, writable_, bounds, budget_),
      crossings_(crossings) {}

void Mover::run() {
  before_ = judge(start_.deck);
  crossings_before_ = crossing_pairs(model_);
  if (crossings_ == Crossings::untangle) before_.crossings = crossings_before_.size();
  if (options_.recommended) return move_as_recommended();
  start_on_ties();
  start_again();
  search(options_.work);
  if (work_stopped()) return;
  // Elements that would cross are held, and the others must move without them.
  std::optional<BestMove> best;
  for (int attempt = 0;; ++attempt) {
    const CrossingChange change = hold_new_crossings();
    if (change.none_new && (!best || best_.crosses_less(*best))) best = best_;
    if ((change.none_new && !change.left_alone) || attempt == crossing_attempts) break;
    start_again();
    search(options_.work / crossing_attempts);
    if (work_stopped()) return;
  }
  if (best) {
    best_ = std::move(*best);
    crossings_after_ = best_.crossings;
  } else {
    start_again();
    crossings_after_ = crossings_before_.size();
  }
  model_.mesh.nodes.x = best_.written;
}

/// Each node by its deepest record.
void Mover::move_as_recommended() {
  std::map<NodeIndex, const Penetration*> deepest;
  for (const Penetration& p : before_.state.penetrations) {
    const auto node = model_.mesh.nodes.lookup.find(p.node);
    if (!node || !to_be_fixed(p.kind) || !p.recommended()) continue;
    const Penetration*& known = deepest[NodeIndex{*node}];
    if (known == nullptr || p.depth > known->depth) known = &p;
  }
  std::vector<NodeIndex> nodes;
  nodes.reserve(deepest.size());
  for (const auto& [node, record] : deepest) nodes.push_back(node);
  writable_.hold_others(nodes, start_.freedoms);
  std::vector<Vector> x = start_.deck;
  for (const auto& [node, record] : deepest)
    if (!start_.freedoms.held(node)) x[node.value] = record->moved_to;
  const std::vector<Vector> written = writable_.written(x);
  best_ = {x, written, judge(written)};
  crossings_after_ = crossing_pairs(model_).size();
}

/// Tied nodes first move onto their segments, as in the solver.
void Mover::start_on_ties() {
  const std::vector<Vector>&tied = before_.state.x, &deck = start_.deck;
  Freedoms& freedoms = start_.freedoms;
  std::vector<NodeIndex> nodes;
  for (const contact::JudgedNode& judged : before_.state.judged)
    if (judged.tied() && tied[judged.node.value] != deck[judged.node.value]) nodes.push_back(judged.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  writable_.hold_others(nodes, freedoms);
  std::erase_if(nodes, [&](NodeIndex n) {
    return freedoms.reason[n.value] != HoldReason::none || freedoms.joined.by_keyword(n);
  });
  for (const NodeIndex n : nodes) start_.x[n.value] = tied[n.value];
  for (auto held = bounds_.offenders(start_.x, nodes); !held.empty(); held = bounds_.offenders(start_.x, nodes))
    for (const NodeIndex n : held) start_.hold_in_deck(n, HoldReason::shape);
}

void Mover::start_again() {
  if (crossings_ == Crossings::untangle) conditions_.gaps().clear();
  best_ = {start_.deck, start_.deck, before_};
  best_.movement = std::numeric_limits<double>::infinity();  // ties move first, with nothing gained
  for (Gap& gap : conditions_.gaps().list()) {
    gap.multiplier = 0;
    gap.given_up = HoldReason::none;
  }
}

/// `work`: limit, except for the step that exceeds it.
void Mover::search(std::uint64_t work) {
  budget_.allow(work);
  Gaps& gaps = conditions_.gaps();
  std::vector<Vector> x = start_.x;
  std::uint32_t progress = 0;
  std::uint32_t worse = 0;
  bool settled = false;
  for (std::uint32_t round = 1; round <= options_.rounds; ++round) {
    if (work_stopped()) return;
    ++rounds_;
    const std::vector<Vector> written = writable_.written(x);
    Judgement now = judge(written);
    if (round == 1) conditions_.set_ties(ties_at(now, written));
    const std::optional<Untangling> untangling = untangle(now, written);
    gaps.add(model_, judge_.surfaces(), now.state, written, [&](NodeIndex n, const model::SegmentNodes& segment) {
      return untangling && untangling->at_crossing(n, segment);
    });
    if (untangling) gaps.add(model_.mesh, untangling->sides(), written);
    gaps.add(now.walls);
    gaps.give_up(start_.freedoms.joined);
    if (round > slow) gaps.widen(now.deepest);
    worse = now.penetrating > best_.judgement.penetrating ? worse + 1 : 0;
    const bool done = best_.judgement.penetrating == 0 && worse >= worse_at_once;
    const bool open = can_open_more(now) || (untangling && !untangling->sides().empty());
    if (best_.take(x, written, std::move(now), movement(written))) progress = round;
    if (gaps.list().empty() || done || (!open && settled) || round - progress > stubborn) break;
    cut_short_ = budget_.used_up() || (open && round == options_.rounds);
    if (cut_short_) break;
    std::vector<Vector> next = solver_.solve(x);
    const std::vector<NodeIndex>& nodes = solver_.nodes();
    settled = largest_difference(next, x, nodes) <= settled_share * largest_difference(next, start_.x, nodes);
    x = std::move(next);
  }
}

/// Σ w |u|², as in find_freedoms().
double Mover::movement(const std::vector<Vector>& x) const {
  double sum = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (x[n] == start_.deck[n]) continue;
    const Vector& mobility = start_.freedoms.mobility[n];
    const Vector move = x[n] - start_.deck[n];
    for (int axis = 0; axis < 3; ++axis)
      if (mobility[axis] > 0) sum += move[axis] * move[axis] / mobility[axis];
  }
  return sum;
}

/// How crossings at the coordinates `x` are to be undone, which `now` counts from here on; nothing where they stay.
std::optional<Untangling> Mover::untangle(Judgement& now, const std::vector<Vector>& x) {
  if (crossings_ == Crossings::stay || crossings_before_.empty()) return std::nullopt;
  const auto crossings = contact_crossings(model_, judge_.surfaces(), x);
  now.crossings = crossings.size();
  std::uint64_t steps = budget_.left();
  std::optional<Untangling> untangling(std::in_place, model_, judge_.surfaces(), x, crossings, left_alone_, steps);
  budget_.done = std::max(budget_.done, budget_.most - steps);
  return untangling;
}

Judgement Mover::judge(const std::vector<Vector>& x) {
  Judgement now = judge_.at(x);
  budget_.done += now.work;
  return now;
}

/// The ties that the contacts made at the coordinates `x`, and nodes at the middle of edges.
std::vector<HeldTie> Mover::ties_at(const Judgement& now, const std::vector<Vector>& x) {
  std::vector<HeldTie> ties = held_ties(now.state.judged, judge_.surfaces(), x);
  for (const model::HangingNode& hanging : hanging_) ties.push_back(held_tie(hanging));
  return ties;
}

/// True if something penetrates that has not been given up.
bool Mover::can_open_more(const Judgement& now) {
  const auto open = [](const Gap* gap) { return gap == nullptr || gap->given_up == HoldReason::none; };
  for (const WallHit& hit : now.walls)
    if (open(conditions_.gaps().find(hit))) return true;
  for (const Penetration& record : now.state.penetrations) {
    if (!to_be_fixed(record.kind)) continue;
    if (open(conditions_.gaps().find(model_, record))) return true;
  }
  return false;
}

/// Counts the crossings of the best coordinates. Elements that did not cross in the deck: their moved nodes are held.
Mover::CrossingChange Mover::hold_new_crossings() {
  model_.mesh.nodes.x = best_.written;
  const std::set<ElementPair> now = crossing_pairs(model_);
  best_.crossings = now.size();
  bool any = false;
  for (const ElementPair& pair : now) {
    if (crossings_before_.contains(pair)) continue;
    any = true;
    for (const ElementOfKind& element : {pair.first, pair.second})
      for (const NodeIndex n : nodes_of(model_.mesh, element))
        if (best_.written[n.value] != start_.deck[n.value]) start_.hold_in_deck(n, HoldReason::crossing);
  }
  return {!any, leave_crossings_alone(now)};
}

/// Crossings that could not be undone, and moved on the way, stay as they are in the next search. True if there are
/// any.
bool Mover::leave_crossings_alone(const std::set<ElementPair>& now) {
  if (crossings_ != Crossings::untangle) return false;
  bool any = false;
  for (const ElementPair& pair : now) any |= left_alone_.insert(pair).second;
  return any;
}

std::vector<NodeIndex> Mover::moved() const {
  const std::vector<Vector>& x = best_.written;
  std::vector<NodeIndex> list;
  for (const NodeIndex n : positions<NodeIndex>(x.size()))
    if (x[n.value] != start_.deck[n.value] && x[n.value].allFinite()) list.push_back(n);
  return list;
}

HoldReason Mover::reason(const Penetration& record) {
  const Gap* gap = conditions_.gaps().find(model_, record);
  return gap == nullptr ? HoldReason::none : gap->given_up;
}

HoldReason Mover::reason(const WallHit& hit) {
  const Gap* gap = conditions_.gaps().find(hit);
  return gap == nullptr ? HoldReason::none : gap->given_up;
}

}  // namespace gapcheck::audit
