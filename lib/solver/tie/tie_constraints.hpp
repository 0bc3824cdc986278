#pragma once
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "solver/state/force.hpp"
#include "solver/tie/tie_failures.hpp"
#include "solver/tie/tie_nodes.hpp"
#include "solver/tie/tie_system.hpp"

namespace gapcheck::solver {

/// Ties by constraints: 2, 6, 7 and their c forms. When all other forces are known, the forces that keep all tied nodes
/// on the points of their segments are solved together (Lagrange multipliers), so ties may share nodes and form chains.
/// Equations without arms constrain the velocities of the next step; arms (c forms) are first turned over the step.
/// Forces act at the positions at the start of the step, so momentum and angular momentum are conserved, and do no work
/// except for the residue of a rotation over a finite step.
class TieConstraints : public Force, public ContactSource {
 public:
  /// `initial` is of this model and these surfaces, `structure` is stepped from initial.x; it must outlive the ties.
  /// Ties that cannot be made go to `diagnostics`.
  TieConstraints(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                 const Structure& structure, Diagnostics& diagnostics);

  /// Stays untied, fails with its segment, or reaches the end of its time.
  void on_failure(Released released) { released_ = std::move(released); }

  void add(State& /*state*/, Forces& /*forces*/) override {}
  [[nodiscard]] bool reacts() const override { return true; }
  void react(const State& state, double mean, double next, Forces& net, Forces& external) override;
  void absorbed(Absorbed& work) const override;

  [[nodiscard]] std::span<const ContactState> states() const override { return states_; }
  [[nodiscard]] std::vector<ContactNode> nodes(std::size_t position) const override;
  void links(std::size_t position, std::vector<ContactLink>& links) const override;
  [[nodiscard]] std::vector<ContactEvent> take_events() override;

 private:
  /// The variable data of a tie.
  struct Present {
    SegmentAxes axes;
    TieOffset offset;
    TieLoads loads;
    bool started = false;
    bool gone = false;  ///< with the element of its segment, or by its strength
    bool told = false;  ///< its end is already reported
  };
  void keep_sound(const model::Model& model, Diagnostics& diagnostics);
  bool activate(const State& state);
  void place(const State& state);
  [[nodiscard]] Eigen::VectorXd targets(const State& state, double next);
  void put(const Eigen::VectorXd& lambda, double mean);
  void sum_up(const State& state, Forces& net, Forces& external);
  void name_dependent(double time);
  void tell_ends(double time);

  const Structure& structure_;
  std::vector<Tie> ties_;
  std::vector<Present> present_;  ///< by tie
  std::vector<TieEquation> equations_;
  std::vector<TieRange> interfaces_;
  std::vector<bool> active_;  ///< by interface
  std::vector<ContactState> states_;
  TieNodes nodes_;
  std::vector<ContactEvent> events_;
  std::vector<std::pair<NodeIndex, PartIndex>> untied_;  ///< not reported yet
  Released released_;
  std::unique_ptr<TieSystem> system_;
  TieFailures weak_;
  std::uint64_t failures_ = 0;  ///< elements that have failed, when this was last asked
  bool varying_ = false;        ///< some equation has an arm or axes, which turn from step to step
};

}  // namespace gapcheck::solver
