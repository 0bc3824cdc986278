#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/contact/node_settler.hpp"
#include "solver/contact/pass_block.hpp"
#include "solver/contact/push_list.hpp"
#include "solver/contact/segment_finder.hpp"
#include "solver/contact/tracked_pairs.hpp"
#include "solver/interface/contact_setting.hpp"
#include "solver/interface/interface_pass.hpp"

namespace gapcheck::solver {

/// One side's nodes against the other side's segments of one contact. Candidates, distances, which segment counts, what
/// happens to the node and how stiff the spring is all come from lib/contact; here they become forces and work. The
/// nodes are checked in blocks, whose results are added in order: the same bits for any number of threads.
class ContactPass final : public InterfacePass {
 public:
  /// `contact`: position in Model::contacts. `exchanged`: side B's nodes against side A's segments. `x` must be the
  /// coordinates of every later state.
  ContactPass(const ContactSetting& setting, ContactIndex contact, const contact::ContactSurfaces& surfaces,
              bool exchanged, const std::vector<Vector>& x);
  ContactPass(const ContactPass&) = delete;
  ContactPass& operator=(const ContactPass&) = delete;

  [[nodiscard]] const TrackedPairs& pairs() const { return pairs_; }
  [[nodiscard]] const NodeRule& rule() const { return *rule_; }

  void set_memory(const Penetration& record, const contact::NodeContact& memory) override;
  void set_timestep(double timestep) override;
  void find_candidates(double margin, ContactCounters& counters) override;
  double advance_state(State& state, double used, ContactCounters& counters) override;
  void add_forces(const State& state, Forces& forces, ContactState& result) const override;
  void continue_from(InterfacePass& before, const State& state, ContactState& result) override;
  void set_followed() override { settler_.end_cycle(); }
  [[nodiscard]] std::unique_ptr<PassMemory> memory() const override;
  void continue_as(const InterfacePass& other, const PassMemory& memory) override;
  void deactivate(const State& state, ContactState& result) override;
  [[nodiscard]] double stored() const override;
  [[nodiscard]] std::vector<ContactNode> nodes() const override;
  [[nodiscard]] std::vector<Touch> touches() const override;
  void add_links(std::vector<ContactLink>& links) const override;

 private:
  /// The places of one block, unless all of them sleep.
  void advance_block(std::size_t block, const State& state, double used, FinderScratch& scratch);
  /// Consecutive places of a block, at most FollowedPairs::capacity of them.
  void advance_places(std::size_t first, std::size_t last, const State& state, double used, FinderScratch& scratch,
                      std::size_t block);
  /// Adds the work of a node's force over its last half step.
  void end_force(SlotIndex slot, const State& state, ContactState& result) const;

  /// Moves the nodes of a block in `state`; returns the longest of their ways.
  [[nodiscard]] double move_nodes(const PassBlock& block, State& state) const;

  const ContactSetting& setting_;
  ContactIndex contact_;
  TrackedPairs pairs_;
  std::unique_ptr<NodeRule> rule_;
  SegmentFinder finder_;
  NodeSettler settler_;
  double given_ = 0;               // energy that springs got from SpringGrowth before the step
  std::vector<PassBlock> blocks_;  // of the present cycle
  std::vector<PushList> pushes_;   // of each block
};

}  // namespace gapcheck::solver
