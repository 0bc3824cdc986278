#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/edge/edge_scene.hpp"
#include "contact/definition/friction.hpp"
#include "contact/pair/node_contact.hpp"
#include "solver/contact/contact_link.hpp"
#include "solver/contact/contact_pass.hpp"
#include "solver/contact/interface_pass.hpp"

namespace gapcheck::solver {

/// Edges against edges of one contact: free shell edges (type i26: all) and beam axes in types 26, free shell edges in
/// SOFT = 2 with a DEPTH that ends in 5. Which edges meet, and where, lib/contact decides. The force acts along the
/// common perpendicular and keeps the side from which the edges have met: they do not pass through each other.
class EdgePass : public InterfacePass {
 public:
  /// `contact`: position in Model::contacts. `x` must be the coordinates of every state that comes.
  EdgePass(const ContactSetting& setting, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
           const std::vector<Vector>& x);
  EdgePass(const EdgePass&) = delete;
  EdgePass& operator=(const EdgePass&) = delete;

  void set_timestep(double timestep) override { timestep_ = timestep; }
  void search(double margin, ContactCounters& counters) override;
  double update(State& state, double used, ContactCounters& counters) override;
  void apply(const State& state, Forces& forces, ContactState& result) const override;
  void carry_over(InterfacePass& before, const State& state, ContactState& result) override;
  void rest(const State& state, ContactState& result) override;
  [[nodiscard]] std::vector<ContactNode> nodes() const override;
  void links(std::vector<ContactLink>& links) const override;

 private:
  /// A pair of edges that are, or were, in contact.
  struct Touch {
    contact::NodeContact memory;
    bool active = false;  ///< `force` acts
    bool worked = false;  ///< `work` is of this cycle
    double penetration = 0;
    std::array<ContactPoint, 2> point;  ///< nearest points of the tracked and the other edge
    LinkForce force;
    LinkWork work;
  };
  struct Pair {
    std::uint32_t tracked = 0, other = 0;
    double wake = 0;  ///< until so much of the margin is used up there is nothing to look at
    /// Unit vector from the other edge to the tracked one when last seen with the nearest points between the ends;
    /// zero: not so.
    Vector side = Vector::Zero();
    std::unique_ptr<Touch> touch;
    [[nodiscard]] std::uint64_t key() const { return std::uint64_t{tracked} << 32 | other; }
  };
  /// What an edge gives to all of its springs.
  struct Spring {
    double stiffness = 0;     ///< SOFT = 0
    double mass = 0;          ///< of both ends
    double segment_mass = 0;  ///< SOFT = 2
    double scale = 1;         ///< SLSFAC and SFS or SFM
    PartIndex part = none<PartIndex>;
  };
  /// What looking at consecutive pairs gave beside the pairs.
  struct Block {
    std::uint64_t looks = 0, released = 0;
    std::vector<std::uint32_t> busy;
  };
  struct Meeting;

  [[nodiscard]] std::vector<std::uint64_t> find(double margin) const;
  [[nodiscard]] Meeting meet(Pair& pair) const;
  void look(std::uint32_t number, const State& state, double used, Block& block);
  [[nodiscard]] LinkSpring spring(const Pair& pair) const;
  [[nodiscard]] contact::NodeAction advance(contact::NodeContact& memory,
                                            const contact::NodeEncounter& encounter) const;
  static void add_energies(const LinkWork& work, bool exchanged, ContactState& result);
  [[nodiscard]] bool exchanged(const Pair& pair) const { return edge_scene_.on_b(edges_[pair.tracked]); }

  const ContactSetting& setting_;
  contact::EdgeScene edge_scene_;
  const contact::PairScene& scene_;
  contact::Exclusions exclusions_;
  contact::EdgeRules rules_;
  contact::Friction friction_;
  std::vector<contact::SurfaceEdge> edges_;  // their ends are those of the start
  std::vector<Spring> springs_;              // by edge
  double timestep_ = 0, reduction_ = 0;
  bool first_ = true;        ///< no cycle since the contact has become active
  std::vector<Pair> pairs_;  // by key
  std::vector<Block> blocks_;
};

}  // namespace gapcheck::solver
