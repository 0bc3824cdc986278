#include "audit/fix/mover.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::audit {
namespace {

constexpr std::size_t sweeps = 1000;
/// Of the largest gap that is to be opened: how exactly the least movement is found, and what is a contradiction.
constexpr double solved = 1e-7, contradicted = 1e-3;
/// Searches without any progress before it is given up.
constexpr std::uint32_t stubborn = 8;
/// Attempts to find moves that keep all elements in shape; each holds one node more at least.
constexpr int attempts = 200;
/// New searches with elements held that would cross others; then nothing is moved at all. Together they may take as
/// much work as the first.
constexpr int crossing_attempts = 6;
/// Moves below this share of the largest are rounding.
constexpr double rounding = 1e-9;
/// Coordinates that change by less than this share of the largest move from one solution to the next are settled.
constexpr double settled_share = 1e-4;

double largest_difference(const std::vector<Vector>& a, const std::vector<Vector>& b, std::span<const NodeIndex> nodes) {
  double largest = 0;
  for (const NodeIndex n : nodes) largest = std::max(largest, (a[n.value] - b[n.value]).norm());
  return largest;
}

}  // namespace

Mover::Mover(model::Model& model, NodeLines& lines, ElementBounds& bounds, const std::vector<Vector>& deck_x,
             Freedoms freedoms, const std::vector<model::HangingNode>& hanging, const FixOptions& options)
    : model_(model),
      lines_(lines),
      bounds_(bounds),
      deck_(deck_x),
      freedoms_(std::move(freedoms)),
      hanging_(hanging),
      options_(options),
      base_(deck_x),
      target_(deck_x),
      best_(deck_x),
      gaps_(bounds.index()),
      slot_(deck_x.size()),
      looked_at_(deck_x.size()) {}

Judgement Mover::judge(const std::vector<Vector>& x) {
  model_.mesh.nodes.x = x;
  surfaces_.emplace(model_);
  contact::InitialOptions options;
  options.nodes_stay = true;
  contact::InitialCounters counters;
  Judgement now;
  now.state = contact::initialise_contacts(model_, *surfaces_, options, counters);
  work_ += counters.sweep.candidate_pairs + x.size();
  for (const Penetration& record : now.state.penetrations) {
    if (!to_be_fixed(record.kind)) continue;
    ++now.penetrating;
    now.depth += record.depth;
  }
  return now;
}

void Mover::run() {
  before_ = judge(deck_);
  crossings_before_ = crossing_pairs(model_);
  start_again();
  tie_first();
  search(options_.work);
  // Elements that would cross are held, and the others have to do without them.
  bool crossed = hold_crossing();
  for (int attempt = 0; crossed && attempt < crossing_attempts; ++attempt) {
    start_again();
    search(options_.work / crossing_attempts);
    crossed = hold_crossing();
  }
  if (crossed) {
    start_again();
    crossings_after_ = crossings_before_.size();
  }
  model_.mesh.nodes.x = best_;
}

void Mover::start_again() {
  target_ = best_ = deck_;
  after_ = before_;
  for (Gap& gap : gaps_.list()) {
    gap.multiplier = 0;
    gap.given_up = HoldReason::none;
  }
}

/// True if elements cross that did not in the deck; then their moved nodes are held.
bool Mover::hold_crossing() {
  model_.mesh.nodes.x = best_;
  const std::set<ElementPair> now = crossing_pairs(model_);
  crossings_after_ = now.size();
  bool any = false;
  for (const ElementPair& pair : now) {
    if (crossings_before_.contains(pair)) continue;
    any = true;
    for (const ElementOfKind& element : {pair.first, pair.second})
      for (const NodeIndex n : nodes_of(model_.mesh, element)) {
        if (best_[n.value] == deck_[n.value]) continue;
        base_[n.value] = deck_[n.value];
        freedoms_.hold(n, HoldReason::crossing);
      }
  }
  return any;
}

/// `work`: at most, but for what the step that exceeds it takes.
void Mover::search(std::uint64_t work) {
  most_work_ = work_ + work;
  std::vector<Vector> x = base_;
  std::uint32_t progress = 0;
  bool settled = false;
  for (std::uint32_t round = 1; round <= options_.rounds; ++round) {
    ++rounds_;
    const std::vector<Vector> written = as_written(x);
    Judgement now = judge(written);
    if (round == 1) {
      all_ties_ = held_ties(now.state.judged, *surfaces_, written);
      for (const model::HangingNode& hanging : hanging_) all_ties_.push_back(held_tie(hanging));
    }
    gaps_.add(model_, *surfaces_, now.state, written);
    gaps_.give_up(freedoms_.joined);
    const bool open = open_gaps(now);
    if (take_best(x, written, std::move(now))) progress = round;
    if (gaps_.list().empty() || (!open && settled) || round - progress > stubborn) break;
    cut_short_ = work_ > most_work_ || (open && round == options_.rounds);
    if (cut_short_) break;
    number_nodes();
    std::vector<Vector> next = solve(x);
    settled = largest_difference(next, x, nodes_) <= settled_share * largest_difference(next, base_, nodes_);
    x = std::move(next);
  }
}

/// Tied nodes go onto their segments before anything else, as the solver has it.
void Mover::tie_first() {
  const std::vector<Vector>& tied = before_.state.x;
  nodes_.clear();
  for (const contact::JudgedNode& judged : before_.state.judged)
    if (judged.tied() && tied[judged.node.value] != deck_[judged.node.value]) nodes_.push_back(judged.node);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  hold_unwritable();
  std::erase_if(nodes_, [&](NodeIndex n) {
    return freedoms_.reason[n.value] != HoldReason::none || freedoms_.joined.by_keyword(n);
  });
  for (const NodeIndex n : nodes_) base_[n.value] = tied[n.value];
  for (auto held = bounds_.offenders(base_, nodes_); !held.empty(); held = bounds_.offenders(base_, nodes_))
    for (const NodeIndex n : held) {
      base_[n.value] = deck_[n.value];
      freedoms_.hold(n, HoldReason::shape);
    }
}

/// True if it is better than the best so far.
bool Mover::take_best(const std::vector<Vector>& x, const std::vector<Vector>& written, Judgement&& now) {
  const bool fewer = now.penetrating < after_.penetrating;
  const bool less = now.penetrating == after_.penetrating && now.depth < after_.depth * (1 - rounding);
  const bool same = now.penetrating == after_.penetrating && now.depth <= after_.depth * (1 + rounding);
  if (!fewer && !same) return false;
  target_ = x;
  best_ = written;
  after_ = std::move(now);
  return fewer || less;
}

/// True if something penetrates that has not been given up.
bool Mover::open_gaps(const Judgement& now) {
  for (const Penetration& record : now.state.penetrations) {
    if (!to_be_fixed(record.kind)) continue;
    const Gap* gap = gaps_.find(model_, record);
    if (gap == nullptr || gap->given_up == HoldReason::none) return true;
  }
  return false;
}

/// Marks the nodes that are tied or joined to marked ones.
void Mover::bring_along(std::vector<std::uint8_t>& moving) {
  const std::size_t known = ties_.size();
  const JoinedNodes& joined = freedoms_.joined;
  for (bool more = true; more;) {
    ties_ = ties_of(all_ties_, moving);
    more = false;
    for (const NodeIndex leader : joined.leaders()) {
      const auto followers = joined.followers(leader);
      const auto marked = std::count_if(followers.begin(), followers.end(), [&](NodeIndex n) { return moving[n.value] != 0; });
      if (marked == 0 || static_cast<std::size_t>(marked) == followers.size()) continue;
      for (const NodeIndex n : followers) moving[n.value] = 1;
      more = true;
    }
  }
  if (ties_.size() != known) tie_multipliers_.assign(3 * ties_.size(), 0);
}

/// All nodes that some gap names, or that are tied or joined to such nodes.
void Mover::number_nodes() {
  std::vector<std::uint8_t> moving(deck_.size());
  for (std::uint32_t i = 0; i < moving.size(); ++i) moving[i] = base_[i] != deck_[i];
  for (const Gap& gap : gaps_.list()) {
    moving[gap.node.value] = 1;
    for (const NodeIndex n : gap.corners) moving[n.value] = 1;
  }
  for (const ShapeCondition& shape : shapes_)
    for (const NodeIndex n : shape.nodes) moving[n.value] = 1;
  bring_along(moving);
  nodes_.clear();
  leaders_.clear();
  for (std::uint32_t i = 0; i < moving.size(); ++i) {
    if (moving[i] == 0) continue;
    const NodeIndex node{i}, leader = freedoms_.joined.leader(node);
    // The leader is the first of its nodes.
    slot_[i] = leader == node ? static_cast<std::uint32_t>(leaders_.size()) : slot_[leader.value];
    if (leader == node) leaders_.push_back(node);
    nodes_.push_back(node);
  }
  hold_unwritable();
}

void Mover::hold_unwritable() {
  for (const NodeIndex n : nodes_) {
    if (looked_at_[n.value] != 0 || freedoms_.held(n)) continue;
    looked_at_[n.value] = 1;
    std::string why = deck_[n.value].allFinite() ? lines_.why_fixed(n) : "its coordinates are no numbers";
    if (why.empty()) continue;
    freedoms_.hold(n, HoldReason::unwritable);
    const auto [entry, added] = unwritable_.try_emplace(std::move(why), Unwritable{n, 0});
    ++entry->second.count;
  }
}

std::vector<Vector> Mover::as_written(const std::vector<Vector>& x) {
  std::vector<Vector> written = deck_;
  const double least = rounding * largest_difference(x, deck_, nodes_);
  for (const NodeIndex n : nodes_)
    if ((x[n.value] - deck_[n.value]).norm() > least) written[n.value] = lines_.written(n, x[n.value]);
  return written;
}

/// One condition for each gap that counts at these coordinates, then three for each tie, then those of shapes.
std::vector<MoveCondition> Mover::conditions(const std::vector<Vector>& at, std::vector<std::size_t>& gap_of) {
  std::vector<MoveCondition> list;
  // Gives what the left side is at these coordinates.
  const auto add_terms = [&](MoveCondition& c, NodeIndex node, const model::SegmentNodes& corners,
                             const std::array<double, 4>& share) {
    const auto move = [&](NodeIndex n) { return c.direction.dot(at[n.value] - base_[n.value]); };
    double sum = move(node);
    c.add(slot_[node.value], 1);
    for (std::size_t i = 0; i < 4; ++i) {
      if (share[i] == 0) continue;
      c.add(slot_[corners[i].value], -share[i]);
      sum -= share[i] * move(corners[i]);
    }
    return sum;
  };
  for (std::size_t i = 0; i < gaps_.list().size(); ++i) {
    Gap& gap = gaps_.list()[i];
    if (gap.given_up != HoldReason::none) continue;
    const GapState state = measure_gap(gap, at);
    MoveCondition c;
    c.direction = state.direction;
    c.bound = gap.distance + gap.clearance - state.gap + add_terms(c, gap.node, gap.corners, state.share);
    c.multiplier = gap.multiplier;
    if (!state.counts || !std::isfinite(c.bound) || !c.direction.allFinite()) {
      gap.multiplier = 0;
      continue;
    }
    list.push_back(c);
    gap_of.push_back(i);
  }
  for (std::size_t i = 0; i < ties_.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      MoveCondition c;
      c.equal = true;
      c.direction = Vector::Unit(axis);
      add_terms(c, ties_[i].node, ties_[i].corners, ties_[i].share);
      c.multiplier = tie_multipliers_[3 * i + static_cast<std::size_t>(axis)];
      list.push_back(c);
    }
  for (const ShapeCondition& shape : shapes_) {
    MoveCondition c;
    c.direction = shape.direction;
    c.bound = shape.bound;
    for (std::size_t i = 0; i < 4; ++i)
      if (shape.coefficient[i] != 0) c.add(slot_[shape.nodes[i].value], shape.coefficient[i]);
    c.multiplier = shape.multiplier;
    list.push_back(c);
  }
  return list;
}

/// Adds conditions that keep the shape of elements that have none yet; true if there were any.
bool Mover::keep_shapes(std::span<const ElementOfKind> broken) {
  bool any = false;
  for (const ElementOfKind& element : broken) {
    if (!shaped_.insert(element).second) continue;
    for (const ShapeCondition& c : shape_conditions(model_.mesh, deck_, element, options_.limits)) {
      shapes_.push_back(c);
      any = true;
    }
  }
  return any;
}

void Mover::keep_multipliers(std::span<const MoveCondition> list, std::span<const std::size_t> gap_of) {
  std::size_t i = 0;
  for (const std::size_t gap : gap_of) gaps_.list()[gap].multiplier = list[i++].multiplier;
  for (double& multiplier : tie_multipliers_) multiplier = list[i++].multiplier;
  for (ShapeCondition& shape : shapes_) shape.multiplier = list[i++].multiplier;
}

/// Gives up gaps that no node can move for, and holds the nodes of conditions that contradict others. True if there
/// were any: then the moves must be found again.
bool Mover::give_up(std::span<const MoveCondition> conditions, std::span<const std::size_t> gap_of,
                    std::span<const Vector> moves, std::span<const Vector> mobility, bool converged) {
  bool any = false;
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < gap_of.size(); ++i) {
    Gap& gap = gaps_.list()[gap_of[i]];
    const double missing = violation(conditions[i], moves);
    largest = std::max(largest, conditions[i].bound);
    if (compliance(conditions[i], mobility) > 0) {
      worst = std::max(worst, missing);
    } else if (missing > gap.clearance * (1 - rounding)) {
      const HoldReason why = freedoms_.reason[gap.node.value];
      gap.given_up = why == HoldReason::none ? HoldReason::conflict : why;
      any = true;
    }
  }
  if (converged || !(worst > contradicted * largest)) return any;
  for (std::size_t i = 0; i < gap_of.size(); ++i) {
    Gap& gap = gaps_.list()[gap_of[i]];
    if (compliance(conditions[i], mobility) == 0 || !(violation(conditions[i], moves) >= worst / 2)) continue;
    if (freedoms_.held(gap.node))
      for (const NodeIndex n : gap.corners) freedoms_.hold(n, HoldReason::conflict);
    freedoms_.hold(gap.node, HoldReason::conflict);
  }
  for (Gap& gap : gaps_.list()) gap.multiplier = 0;
  std::fill(tie_multipliers_.begin(), tie_multipliers_.end(), 0.0);
  for (ShapeCondition& shape : shapes_) shape.multiplier = 0;
  return true;
}

/// The coordinates with the least movement that open all gaps as they stand at `at`. Elements keep their shape.
std::vector<Vector> Mover::solve(const std::vector<Vector>& at) {
  std::vector<Vector> moves, mobility;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    moves.resize(leaders_.size());
    mobility.clear();
    for (const NodeIndex n : leaders_) mobility.push_back(freedoms_.mobility[n.value]);
    std::vector<std::size_t> gap_of;
    std::vector<MoveCondition> list = conditions(at, gap_of);
    double largest = 0;
    for (const MoveCondition& c : list) largest = std::max(largest, c.bound);
    const MovementResult result = least_movement(list, mobility, moves, solved * largest, sweeps);
    keep_multipliers(list, gap_of);
    work_ += result.sweeps * list.size();
    if (work_ > most_work_) break;
    if (give_up(list, gap_of, moves, mobility, result.sweeps < sweeps)) continue;
    std::vector<Vector> x = base_;
    for (const NodeIndex n : nodes_) x[n.value] += moves[slot_[n.value]];
    const std::vector<ElementOfKind> broken = bounds_.broken(x, nodes_);
    if (broken.empty()) return x;
    // Neighbours are to come along first; what that does not help is held.
    if (keep_shapes(broken)) {
      number_nodes();
      continue;
    }
    for (const NodeIndex n : bounds_.offenders(x, broken)) {
      freedoms_.hold(n, HoldReason::shape);
      base_[n.value] = deck_[n.value];
    }
  }
  return base_;
}

std::vector<NodeIndex> Mover::moved() const {
  std::vector<NodeIndex> list;
  for (std::uint32_t i = 0; i < deck_.size(); ++i)
    if (best_[i] != deck_[i] && best_[i].allFinite()) list.push_back(NodeIndex{i});
  return list;
}

HoldReason Mover::reason(const Penetration& record) {
  const Gap* gap = gaps_.find(model_, record);
  return gap == nullptr ? HoldReason::none : gap->given_up;
}

}  // namespace gapcheck::audit
