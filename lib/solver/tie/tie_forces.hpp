#pragma once
#include <memory>
#include <span>
#include <vector>

#include "solver/state/force.hpp"
#include "solver/tie/tie.hpp"
#include "solver/tie/tie_spring.hpp"

namespace gapcheck::solver {

/// Ties by springs: the offset forms, and the nodes that IPBACK ties because a constraint cannot. A spring between the
/// node and the point that turns with its segment, as stiff as that of a penalty contact; springs that would push the
/// step below half that of the elements in the first cycle are softened. Types 7 tie rotations by springs of the same
/// frequency. The o forms leave out the moment of the offset, the b forms carry it. Tiebreaks (8, 9) are tied like o
/// forms until they fail.
class TieForces : public Force, public ContactSource {
 public:
  /// `initial` is of this model and these surfaces, `structure` the one that will be stepped from initial.x; model,
  /// surfaces and initial must outlive it.
  TieForces(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
            const Structure& structure);

  /// Fails, or reaches the end of its time.
  void on_failure(Released released) { released_ = std::move(released); }

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
  void build(const State& state);
  void tell_ends(const TieRange& interface, double time);
  void let_slide(const TieRange& interface);

  const model::Model& model_;
  contact::SurfaceStore& store_;
  const contact::InitialState& initial_;
  const Structure* structure_;  ///< until the first cycle
  std::vector<TieSpring> springs_;
  std::vector<TieRange> interfaces_;
  std::vector<ContactState> states_;
  std::vector<std::unique_ptr<contact::SlidingSurface>> sliding_;
  double squared_frequency_ = 0;         ///< upper bound of the springs'
  double coming_ = 0;                    ///< step that the elements allow
  double elements_share_ = usual_share;  ///< their share of the bound of stability at that step
  std::vector<ContactEvent> events_;
  Released released_;
  std::uint64_t failures_ = 0;  ///< elements that have failed, when this was last asked
  bool built_ = false;
};

}  // namespace gapcheck::solver
