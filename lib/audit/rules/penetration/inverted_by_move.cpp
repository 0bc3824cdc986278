#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"
#include "audit/shared_results.hpp"
#include "base/parallel.hpp"
#include "contact/surface/element_fate.hpp"

namespace gapcheck::audit::rule::inverted_by_move {
namespace {

using Points = std::vector<Vector>;

/// Who moved a node.
struct Move {
  ContactIndex contact;
  bool tie = false;
};

/// The elements of one kind, and the nodes that the initialisation has moved.
class Moves {
 public:
  Moves(Context& context, const contact::InitialState& state)
      : model_(context.model()), state_(state), after_(state.x) {
    const Points& before = model_.mesh.nodes.x;
    if (after_.size() != before.size()) return;
    moved_.resize(before.size());
    std::atomic<bool> any{false};
    parallel_for(before.size(), 16384, [&](std::size_t begin, std::size_t end) {
      bool some = false;
      for (std::size_t i = begin; i < end; ++i) some |= moved_[i] = before[i] != after_[i];
      if (some) any = true;
    });
    any_ = any;
  }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] const Points& after() const { return after_; }

  /// The node of an element that is moved furthest; none: the element stays.
  [[nodiscard]] NodeIndex furthest(std::span<const NodeIndex> nodes) const {
    NodeIndex best = none<NodeIndex>;
    for (const NodeIndex n : nodes)
      if (moved_[n.value] && (best == none<NodeIndex> || distance(n) > distance(best))) best = n;
    return best;
  }
  [[nodiscard]] bool any_of(std::span<const NodeIndex> nodes) const {
    return std::any_of(nodes.begin(), nodes.end(), [&](NodeIndex n) { return moved_[n.value] != 0; });
  }
  [[nodiscard]] double distance(NodeIndex n) const { return (after_[n.value] - model_.mesh.nodes.x[n.value]).norm(); }
  /// The last one that moved the node; nothing: not known. From one thread: the first call sorts out all nodes.
  [[nodiscard]] std::optional<Move> of(NodeIndex n) {
    if (of_node_.empty()) sort_out();
    const Move& move = of_node_[n.value];
    return move.contact == none<ContactIndex> ? std::nullopt : std::optional(move);
  }

 private:
  void sort_out() {
    of_node_.assign(moved_.size(), {none<ContactIndex>});
    for (const contact::JudgedNode& node : state_.judged)
      if (node.tied() && moved_[node.node.value]) of_node_[node.node.value] = {node.contact, true};
    for (const Penetration& record : state_.penetrations)
      if (const auto node = model_.mesh.nodes.lookup.find(record.node);
          node && record.outcome == Outcome::moved && moved_[*node])
        of_node_[*node] = {ContactIndex{record.contact}, false};
  }

  const model::Model& model_;
  const contact::InitialState& state_;
  const Points& after_;
  std::vector<std::uint8_t> moved_;
  std::vector<Move> of_node_;  ///< by node; empty until it is asked for
  bool any_ = false;
};

template <std::size_t N>
void check(const RuleIdentity& rule, Context& context, Report& report, Moves& moves, const model::Elements<N>& elements,
           std::string_view word, std::string_view measure) {
  const model::Model& model = context.model();
  const Points& x = model.mesh.nodes.x;
  std::vector<Found> found = find_all(elements.size(), [&](std::size_t i, std::vector<Found>& list) {
    const auto& nodes = elements.nodes[i];
    if (!moves.any_of(nodes)) return;
    if (elements.part[i] != none<PartIndex> && !context.part_chosen(elements.part[i])) return;
    const contact::ElementFate f = contact::element_fate(nodes, x, moves.after());
    if (f.bad())
      list.push_back({elements.part[i].value, rough_weight((f.before - f.after) / f.before), i, {elements.id[i]}});
  });
  const auto at = [&](std::size_t i, std::string message) {
    const NodeIndex node = moves.furthest(elements.nodes[i]);
    Finding finding = node_finding(rule, context, node, std::move(message));
    finding.element = elements.id[i];
    if (const PartIndex part = elements.part[i]; part != none<PartIndex>)
      finding.part = finding.element_part = model.part(part).id.value;
    if (const auto move = moves.of(node)) finding.contact = model.contact(move->contact).id.value;
    return finding;
  };
  add_grouped(
      report, std::move(found),
      [&](const Found& one) {
        const std::size_t i = one.item;
        const NodeIndex node = moves.furthest(elements.nodes[i]);
        const contact::ElementFate f = contact::element_fate(elements.nodes[i], x, moves.after());
        const auto move = moves.of(node);
        const std::string who = !move ? "the start moves" : move->tie ? "the tie moves" : "the contact moves";
        return at(
            i, fmt::format("{} {} {}: {} its node {} by {:.6g}; {} {:.6g} before, {:.6g} after: correct the geometry "
                           "there, or {}",
                           word, elements.id[i], f.inverted ? "is turned inside out" : "is flattened", who,
                           model.mesh.nodes.id[node.value], moves.distance(node), measure, f.before, f.after,
                           move && move->tie ? "tie with an offset" : "set IGNORE = 1"));
      },
      [&](const Found& one, std::uint64_t count) {
        return at(one.item, fmt::format("{} more {}s of this part are turned inside out or flattened by moved nodes",
                                        count, word));
      },
      collect_nodes(context, [&](const Found& one) { return moves.furthest(elements.nodes[one.item]); }));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  Moves moves(context, context.results().initial());
  if (!moves.any()) return;
  const model::Mesh& mesh = context.model().mesh;
  check(rule, context, report, moves, mesh.shells, "shell", "area");
  check(rule, context, report, moves, mesh.solids, "solid", "volume");
  check(rule, context, report, moves, mesh.thick_shells, "thick shell", "volume");
}

}  // namespace

const Rule definition{{"GC114", "inverted-by-move", Severity::error,
                       "an element is turned inside out or flattened when the solver moves its nodes at the start",
                       Need::node_penetrations | Need::ties,
                       "The solver stops with a negative volume, or calculates with an element of no size"},
                      run};

}  // namespace gapcheck::audit::rule::inverted_by_move
