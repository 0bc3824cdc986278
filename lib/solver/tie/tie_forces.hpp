#pragma once
#include <functional>
#include <memory>
#include <span>
#include <unordered_set>
#include <vector>

#include "solver/interface/touch.hpp"
#include "solver/state/force.hpp"
#include "solver/tie/tie.hpp"
#include "solver/tie/tie_spring.hpp"
#include "solver/tie/tie_stability.hpp"
#include "solver/tie/tie_strengths.hpp"

namespace gapcheck::solver {

/// Ties by springs: the offset forms, and the nodes that IPBACK ties because a constraint cannot. A spring between the
/// node and the point that turns with its segment, as stiff as that of a penalty contact; springs that would push the
/// step below half that of the elements in the first cycle are softened. Types 7 tie rotations by springs of the same
/// frequency. The o forms leave out the moment of the offset, the b forms carry it. Tiebreaks (8, 9) are tied like o
/// forms until they fail. With OPTION 1 and 3 nodes that come into contact later are tied where they touch.
class TieForces : public Force, public ContactSource {
 public:
  /// `initial` is of this model and these surfaces, `structure` the one that will be stepped from initial.x; model,
  /// surfaces and initial must outlive it.
  TieForces(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
            const Structure& structure);

  /// Fails, or reaches the end of its time.
  void on_failure(Released released) { released_ = std::move(released); }

  /// For OPTION 1 and 3: the nodes that a contact pushes, asked after its forces are known, and whom to tell of those
  /// that are tied from now on.
  void on_touch(std::function<std::vector<Touch>(ContactIndex)> touches, Released held) {
    touches_ = std::move(touches);
    held_ = std::move(held);
  }

  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override;
  [[nodiscard]] double stable_step() const override;

  [[nodiscard]] std::span<const ContactState> states() const override { return states_; }
  [[nodiscard]] std::vector<ContactNode> nodes(std::size_t position) const override;
  void links(std::size_t position, std::vector<ContactLink>& links) const override;
  /// Nothing for tiebreaks: what damage takes does not follow from the state.
  [[nodiscard]] std::optional<double> stored(std::size_t position) const override;
  [[nodiscard]] std::vector<ContactEvent> take_events() override;

 private:
  /// One contact: its springs, in the order in which they were tied.
  struct Interface {
    TieRange range;  ///< its times; of the ties at the start
    std::vector<TieSpring> springs;
    std::unique_ptr<TieStrengths> strengths;      ///< of nodes that stick later; null: none does
    std::unordered_set<std::uint32_t> has_stuck;  ///< nodes that do not stick again
  };
  void build(const State& state);
  void build_springs(Interface& interface, const ContactMasses& masses, StiffnessCache& tables, const State& state);
  void tell_ends(Interface& interface, double time);
  void let_slide(Interface& interface);
  void let_stick(Interface& interface, const State& state);

  const model::Model& model_;
  contact::SurfaceStore& store_;
  const contact::InitialState& initial_;
  const Structure& structure_;
  std::vector<Interface> interfaces_;
  std::vector<ContactState> states_;
  std::vector<std::unique_ptr<contact::SlidingSurface>> sliding_;
  TieStability stability_;
  std::vector<double> shares_;           ///< of the stiffness, two by spring in the order of `stability_`
  double ratio_ = 0;                     ///< greatest share of the critical damping
  double squared_frequency_ = 0;         ///< upper bound of the springs'
  double coming_ = 0;                    ///< step that the elements allow
  double elements_share_ = usual_share;  ///< their share of the bound of stability at that step
  std::vector<ContactEvent> events_;
  Released released_, held_;
  std::function<std::vector<Touch>(ContactIndex)> touches_;
  std::uint64_t failures_ = 0;  ///< elements that have failed, when this was last asked
  bool built_ = false;
};

}  // namespace gapcheck::solver
