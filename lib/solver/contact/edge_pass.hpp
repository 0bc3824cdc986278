#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/edge/edge_scene.hpp"
#include "contact/pair/node_contact.hpp"
#include "solver/contact/edge_springs.hpp"
#include "solver/interface/contact_link.hpp"
#include "solver/interface/contact_setting.hpp"
#include "solver/interface/interface_pass.hpp"

namespace gapcheck::solver {

/// State of two edges that are or were in contact.
struct EdgeTouch {
  contact::NodeContact memory;
  bool active = false;  ///< `force` acts
  double penetration = 0;
  std::array<ContactPoint, 2> point;  ///< nearest points of the tracked and the other edge
  LinkForce force;
  LinkWork work;  ///< in the last cycle in which the force acted or ended
  /// Adds half a step of work of the present force.
  void add_work(const State& state, LinkWork& sum) const {
    sum.add(force, point[0].of(state.v), point[1].of(state.v), state.dt);
  }
  /// The energy of the spring.
  [[nodiscard]] double stored() const { return active ? force.stored(penetration - memory.forgiven) : 0; }
  [[nodiscard]] bool apart() const { return !active && memory.state == contact::NodeContact::State::apart; }
};

/// Two edges that may come into contact.
struct EdgePair {
  std::uint32_t tracked = 0, other = 0;
  double wake = 0;  ///< nothing to check until this much of the margin is used up
  /// Unit vector from the other edge to the tracked one when the nearest points were last between the ends; zero:
  /// never.
  Vector side = Vector::Zero();
  std::unique_ptr<EdgeTouch> touch;
  [[nodiscard]] std::uint64_t key() const { return std::uint64_t{tracked} << 32 | other; }
};

/// Edges against edges of one contact: free shell edges (type i26: all) and beam axes in types 26, free shell edges in
/// SOFT = 2 with a DEPTH that ends in 5. lib/contact decides which edges meet, and where. The force acts along the
/// common perpendicular and keeps the side from which the edges met: they do not pass through each other.
class EdgePass final : public InterfacePass {
 public:
  /// `contact`: position in Model::contacts. `x` must be the coordinates of every later state.
  EdgePass(const ContactSetting& setting, ContactIndex contact, const contact::ContactSurfaces& surfaces,
           const std::vector<Vector>& x);
  EdgePass(const EdgePass&) = delete;
  EdgePass& operator=(const EdgePass&) = delete;

  void set_timestep(double timestep) override { springs_.set_timestep(timestep); }
  void find_candidates(double margin, ContactCounters& counters) override;
  double advance_state(State& state, double used, ContactCounters& counters) override;
  void add_forces(const State& state, Forces& forces, ContactState& result) const override;
  void continue_from(InterfacePass& before, const State& state, ContactState& result) override;
  void deactivate(const State& state, ContactState& result) override;
  [[nodiscard]] double stored() const override;
  [[nodiscard]] std::vector<ContactNode> nodes() const override;
  void add_links(std::vector<ContactLink>& links) const override;

 private:
  /// Results of checking consecutive pairs, besides the pairs.
  struct Block {
    std::uint64_t checked = 0, released = 0;
    double lost = 0;                  ///< energy of springs of edges that are released now
    std::vector<std::uint32_t> busy;  ///< pairs whose force acts or has ended in this cycle
  };

  /// Keys of the pairs that can touch before the margin is used up, ascending; if these are too many, the nearest of
  /// each edge.
  [[nodiscard]] std::vector<std::uint64_t> find_keys(double margin, ContactCounters& counters) const;
  void advance_pair(std::uint32_t number, const State& state, double used, Block& block);
  [[nodiscard]] contact::NodeAction decide_action(contact::NodeContact& memory,
                                                  const contact::NodeEncounter& encounter) const;
  [[nodiscard]] bool exchanged(const EdgePair& pair) const { return edge_scene_.on_b(edges_[pair.tracked]); }

  const model::Model& model_;
  contact::EdgeScene edge_scene_;
  const contact::PairScene& scene_;
  contact::Exclusions exclusions_;
  contact::EdgeRules rules_;
  std::vector<contact::SurfaceEdge> edges_;  // their ends are the initial ones
  EdgeSprings springs_;
  double reduction_ = 0;
  bool first_ = true;            ///< no cycle since the contact has become active
  std::vector<EdgePair> pairs_;  // by key
  std::vector<Block> blocks_;
};

}  // namespace gapcheck::solver
