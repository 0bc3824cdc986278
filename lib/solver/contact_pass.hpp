#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/candidates.hpp"
#include "contact/friction.hpp"
#include "contact/side_scene.hpp"
#include "solver/contact_link.hpp"
#include "solver/contact_spring.hpp"
#include "solver/interface_pass.hpp"

namespace gapcheck::solver {

/// What all passes of a run share. All references must outlive them.
struct ContactSetting {
  const model::Model& model;
  const ContactMasses& masses;
  const contact::CandidateSearch& search;
  const contact::Ties& ties;
  const std::vector<bool>& movable;  ///< by node: the shooting-node logic may move it
};

/// One side's nodes against the other side's segments of one contact. Candidates, distances, which segment counts, what
/// happens to the node and how stiff the spring is come from lib/contact; here they become forces and work.
class ContactPass : public InterfacePass {
 public:
  /// `contact`: position in Model::contacts. `x` must be the coordinates of every state that comes.
  ContactPass(const ContactSetting& setting, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
              bool exchanged, const std::vector<Vector>& x);
  ContactPass(const ContactPass&) = delete;
  ContactPass& operator=(const ContactPass&) = delete;

  void remember(const Penetration& record, const contact::NodeContact& memory) override;
  void set_timestep(double timestep) override { springs_.set_timestep(timestep); }
  void search(double margin, ContactCounters& counters) override;
  double update(State& state, double used, ContactCounters& counters) override;
  void apply(const State& state, Forces& forces, ContactState& result) const override;
  void carry_over(InterfacePass& before, const State& state, ContactState& result) override;
  void rest(const State& state, ContactState& result) override;
  [[nodiscard]] std::vector<ContactNode> nodes() const override;
  void links(std::vector<ContactLink>& links) const override;

 protected:
  [[nodiscard]] const ContactSetting& setting() const { return setting_; }
  [[nodiscard]] const contact::SideScene& side() const { return side_; }
  /// Springs and release depths are asked for again.
  void forget_partners();

  // What segment-based contact does in another way.
  [[nodiscard]] virtual ContactSprings::Spring spring(std::uint32_t slot, std::uint32_t segment) const {
    return springs_(slot, segment);
  }
  [[nodiscard]] virtual double release_depth(std::uint32_t slot, std::uint32_t segment) const;
  /// Takes back a node that has passed the surface: changes the sign of pair.distance. Asked once per look; `pair`:
  /// none where it penetrates nothing.
  virtual void orient(std::uint32_t /*slot*/, std::uint32_t /*segment*/, contact::PairResult* /*pair*/) {}
  [[nodiscard]] virtual contact::NodeAction advance(contact::NodeContact& memory,
                                                    const contact::NodeEncounter& encounter) const;

 private:
  /// The spring between a node and a segment.
  struct Link : LinkForce {
    std::uint32_t segment = 0;
    std::array<double, 4> weights{};
  };
  using Work = LinkWork;
  /// What is needed of a node and a segment and changes little from one search to the next: it follows from thickness,
  /// mass and the size of elements.
  struct Partner {
    std::uint32_t segment = 0;  ///< from 1; 0: not known
    double release_depth = 0;
    ContactSprings::Spring spring;
  };
  struct Tracked {
    contact::NodeContact memory;
    bool active = false;  ///< `link` carries a force
    bool worked = false;  ///< `work` is of this cycle
    double penetration = 0;
    double sleep = 0;  ///< until so much of the margin is used up there is nothing to look at
    Partner partner;
    Link link;
    Work work;
  };
  struct Move {
    std::uint32_t slot = 0;
    Vector way = Vector::Zero();
  };
  /// What looking at consecutive places gave beside their Tracked.
  struct Block {
    std::uint64_t nodes = 0, pairs = 0, released = 0;
    std::vector<std::uint32_t> busy;
    std::vector<Move> moves;
    void clear();
  };
  struct Velocities {
    Vector node;
    std::array<Vector, 4> corners;
    /// Of the segment's point with these weights.
    [[nodiscard]] Vector of_segment(const std::array<double, 4>& weights) const;
  };
  struct Meeting;
  struct Scratch;

  [[nodiscard]] std::uint32_t slot_at(std::size_t place) const;
  void look(std::size_t place, const State& state, double used, Scratch& scratch, Block& block);
  [[nodiscard]] Meeting meet(std::uint32_t slot, std::span<contact::Candidate> candidates, double used,
                             Scratch& scratch, Tracked& tracked, Block& block) const;
  [[nodiscard]] contact::NodeEncounter encounter(std::uint32_t slot, const Meeting& meeting, Tracked& tracked) const;
  [[nodiscard]] Link link(std::uint32_t slot, const Meeting& meeting, const Tracked& now, const Vector& friction_before,
                          const Velocities& velocities, double dt) const;
  [[nodiscard]] Velocities velocities(std::uint32_t slot, std::uint32_t segment, const State& state) const;
  void add_energies(const Work& work, ContactState& result) const;
  void apply_one(std::uint32_t slot, const State& state, Forces& forces, ContactState& result) const;
  void add_work(const Link& link, const Velocities& velocities, double dt, Work& work) const;

  const ContactSetting& setting_;
  const contact::ContactSurfaces& surfaces_;
  contact::SideScene side_;
  const contact::PairScene& scene_;
  contact::Exclusions exclusions_;
  contact::PairRules rules_;
  contact::Friction friction_;
  ContactSprings springs_;
  double greatest_reach_ = 0;
  bool exchanged_;
  contact::CandidateTable candidates_;
  std::vector<Tracked> tracked_;           // by slot
  std::vector<std::uint32_t> lost_;        // slots with a memory but without candidates since the search
  std::vector<Block> blocks_;              // of the present cycle
};

}  // namespace gapcheck::solver
