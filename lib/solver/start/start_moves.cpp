#include "solver/start/start_moves.hpp"

#include <algorithm>
#include <tuple>

namespace gapcheck::solver {
namespace {

PartIndex part_with_id(const model::Model& model, std::int64_t id) {
  const auto found = model.part_of_id.find(id);
  return found == model.part_of_id.end() ? none<PartIndex> : found->second;
}

/// What a contact says about a node: where it was, or that it is tied.
struct NodeEvent {
  NodeIndex node;
  ContactIndex contact;
  const Penetration* record = nullptr;       ///< else null
  const contact::JudgedNode* tie = nullptr;  ///< else null
};

/// By node, then contact: of nodes that the initialisation has moved.
std::vector<NodeEvent> events_of_moved_nodes(const model::Model& model, const contact::InitialState& initial) {
  const model::Nodes& nodes = model.mesh.nodes;
  std::vector<bool> concerned(nodes.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) concerned[i] = nodes.x[i] != initial.x[i];
  std::vector<std::pair<std::uint32_t, const Penetration*>> records;
  for (const Penetration& record : initial.penetrations) {
    // The point of an edge is not its node.
    const auto node = record.kind == PenetrationKind::edge ? std::nullopt : nodes.lookup.find(record.node);
    if (!node) continue;
    records.emplace_back(*node, &record);
    // A node may come back to where it was.
    if (record.outcome == Outcome::moved) concerned[*node] = true;
  }
  std::vector<NodeEvent> events;
  for (const auto& [node, record] : records)
    if (concerned[node]) events.push_back({NodeIndex{node}, ContactIndex{record->contact}, record, nullptr});
  for (const contact::JudgedNode& judged : initial.judged)
    if (judged.tied() && concerned[judged.node.value] &&
        contact::moves_tied_nodes(contact::classify(model.contact(judged.contact))))
      events.push_back({judged.node, judged.contact, nullptr, &judged});
  std::ranges::stable_sort(events, {}, [](const NodeEvent& event) { return std::tie(event.node, event.contact); });
  return events;
}

/// Follows one node through its events.
class NodeTrack {
 public:
  NodeTrack(const model::Model& model, NodeIndex node, std::vector<NodeStep>& steps)
      : model_(model), node_(node), at_(model.mesh.nodes.x[node.value]), steps_(steps) {}

  void follow(const NodeEvent& event) {
    if (event.tie != nullptr) {
      if (tie_ == nullptr) tie_ = event.tie;
      return;
    }
    const Penetration& record = *event.record;
    be_at(record.original);
    if (record.outcome != Outcome::moved) return;
    steps_.push_back({event.contact, node_, part_with_id(model_, record.part),
                      part_with_id(model_, record.element_part), at_, record.moved_to, StartCause::shot});
    at_ = record.moved_to;
  }
  /// The node is seen there: a tie since then has moved it, if it has moved.
  void be_at(const Vector& x) {
    if (x != at_ && tie_ != nullptr)
      steps_.push_back({tie_->contact, node_, tie_->part, tie_->segment_part, at_, x, StartCause::tied});
    at_ = x;
    tie_ = nullptr;
  }

 private:
  const model::Model& model_;
  NodeIndex node_;
  Vector at_;
  const contact::JudgedNode* tie_ = nullptr;  ///< the first one since the node was last seen
  std::vector<NodeStep>& steps_;
};

}  // namespace

std::vector<NodeStep> initial_steps(const model::Model& model, const contact::InitialState& initial) {
  const std::vector<NodeEvent> events = events_of_moved_nodes(model, initial);
  std::vector<NodeStep> steps;
  for (auto first = events.begin(); first != events.end();) {
    const auto last = std::find_if(first, events.end(), [&](const NodeEvent& e) { return e.node != first->node; });
    NodeTrack track(model, first->node, steps);
    for (auto event = first; event != last; ++event) track.follow(*event);
    track.be_at(initial.x[first->node.value]);
    first = last;
  }
  std::ranges::stable_sort(steps, {}, &NodeStep::contact);
  return steps;
}

std::vector<NodeStep> cycle_steps(std::span<const ShotNode> shot) {
  std::vector<NodeStep> steps;
  for (const ShotNode& s : shot)
    steps.push_back({s.contact, s.node, s.part, s.segment_part, s.from, s.to, StartCause::first_cycle});
  return steps;
}

double rounding_at(const Vector& x) {
  constexpr double single_precision = 0x1p-23;
  return single_precision * x.cwiseAbs().maxCoeff();
}

}  // namespace gapcheck::solver
