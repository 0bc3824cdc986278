#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/pair/candidates.hpp"
#include "contact/definition/friction.hpp"
#include "contact/pair/side_scene.hpp"
#include "geometry/follow.hpp"
#include "solver/contact/contact_link.hpp"
#include "solver/contact/contact_setting.hpp"
#include "solver/contact/contact_spring.hpp"
#include "solver/contact/interface_pass.hpp"
#include "solver/contact/push_list.hpp"

namespace gapcheck::solver {

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
  /// How a tracked node lies to the segment that counts.
  struct Contact {
    std::uint32_t segment = 0;
    double s = 0, t = 0;            ///< of the closest point
    Vector way = Vector::Zero();    ///< from there to the node
    Vector normal = Vector::Zero(); ///< to the segment's free side; only used where `way` is zero
    double distance = 0;            ///< negative behind the segment
    bool on_face = false;           ///< the closest point lies inside the segment
    /// Unit vector to the free side.
    [[nodiscard]] Vector direction() const { return distance != 0 ? Vector(way / distance) : normal; }
  };
  /// Takes back a node that has passed the surface: changes the sign of the distance. Asked once per look; `contact`:
  /// none where it penetrates nothing.
  virtual void orient(std::uint32_t /*slot*/, Contact* /*contact*/) {}
  [[nodiscard]] virtual contact::NodeAction advance(contact::NodeContact& memory,
                                                    const contact::NodeEncounter& encounter) const;

 private:
  /// The spring between a node and a segment.
  struct Link : LinkForce {
    std::uint32_t segment = 0;
    bool on_face = false;  ///< `s`, `t` lie inside the segment: the next cycle may start there
    double s = 0, t = 0;
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
    double penetration = 0;
    double sleep = 0;  ///< until so much of the margin is used up there is nothing to look at
    double lead = 0;   ///< until so much is used up no other segment is as near as that of `link`
    Partner partner;
    Link link;
  };
  struct Move {
    std::uint32_t slot = 0;
    Vector way = Vector::Zero();
  };
  /// What looking at consecutive places gave beside their Tracked.
  struct Block {
    double sleep = 0;  ///< until so much of the margin is used up all of them rest
    std::uint64_t nodes = 0, pairs = 0, followed = 0, asleep = 0, released = 0, touching = 0;
    Work work;
    std::vector<Move> moves;
    void clear();
  };
  struct Velocities {
    Vector node;
    std::array<Vector, 4> corners;
    /// Of the segment's point with these weights.
    [[nodiscard]] Vector of_segment(const std::array<double, 4>& weights) const {
      return (weights[0] * corners[0] + weights[1] * corners[1]) + (weights[2] * corners[2] + weights[3] * corners[3]);
    }
  };
  struct Meeting;
  struct Scratch;

  [[nodiscard]] std::uint32_t slot_at(std::size_t place) const;
  [[nodiscard]] double segment_area(std::uint32_t segment) const;
  /// The places of one block, unless all of them rest.
  void look_at_block(std::size_t block, const State& state, double used, Scratch& scratch);
  /// Looks at consecutive places, FollowedPairs::capacity of them at most.
  void look_at(std::size_t first, std::size_t last, const State& state, double used, Scratch& scratch,
               std::size_t block);
  void look(std::size_t place, const State& state, double used, Scratch& scratch, std::size_t block);
  void act(std::uint32_t slot, Meeting& meeting, const State& state, std::size_t block);
  /// Decides the candidates that can be near; says which segment counts.
  [[nodiscard]] Meeting meet(std::uint32_t slot, std::span<contact::Candidate> candidates, double used,
                             Scratch& scratch, Tracked& tracked, Block& block) const;
  [[nodiscard]] Contact contact_of(std::uint32_t slot, std::uint32_t segment, const contact::PairResult& pair) const;
  /// Takes the closest point that following the pair of the last cycle finds: whether the node was followed then or
  /// decided in the long way must not show in the last bit.
  void improve(std::uint32_t slot, const Tracked& tracked, Contact& contact, geometry::FollowedPairs& pairs) const;
  /// Least distance of the candidates but `segment`, as far as their sleep says.
  [[nodiscard]] double nearest_other(std::uint32_t slot, std::uint32_t segment,
                                     std::span<const contact::Candidate> candidates, double used) const;
  /// Puts off the wake of candidates but `segment` as far as the plane of their last decision separates them from the
  /// node; only of those that may be nearer than `far`.
  void separate(std::uint32_t slot, std::uint32_t segment, std::span<contact::Candidate> candidates, double used,
                double far) const;
  /// Until how much of the margin is used up no other candidate can come as near as the chosen one.
  [[nodiscard]] double lead(double nearest_other, const Contact& chosen, double used) const;
  /// Distance of a segment at which the node has nothing to do with it.
  [[nodiscard]] double reach(std::uint32_t slot, std::uint32_t s) const {
    return scene_.oriented(s) ? greatest_reach_ : scene_.nodes.half[slot] + scene_.segments.half[s];
  }
  /// True if the pair of the last cycle is likely to be all that counts.
  [[nodiscard]] bool may_follow(std::size_t place) const;
  /// True if no candidate but that of the contact can count.
  [[nodiscard]] bool keeps_lead(std::size_t place, const Contact& contact, double used);
  void prepare(std::uint32_t slot, geometry::FollowedPairs& pairs, std::size_t lane) const;
  /// The meeting of a pair that was followed; nothing where it must be decided in the long way.
  [[nodiscard]] std::optional<Contact> followed(std::uint32_t slot, const geometry::FollowedPairs& pairs,
                                                std::size_t lane) const;
  [[nodiscard]] contact::NodeEncounter encounter(std::uint32_t slot, const Meeting& meeting, Tracked& tracked) const;
  [[nodiscard]] Link place_link(const Contact& contact) const;
  /// Sets the forces of a link that is in its place.
  void press(std::uint32_t slot, Tracked& tracked, const Vector& velocity, const Vector& friction_before,
             double dt) const;
  [[nodiscard]] Velocities velocities(std::uint32_t slot, std::uint32_t segment, const State& state) const;
  void add_energies(const Work& work, ContactState& result) const;
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
  std::vector<PushList> pushes_;           // of each block
  bool leads_;  // segments that lead now do so until motion has used that up; not where thickness changes
};

}  // namespace gapcheck::solver
