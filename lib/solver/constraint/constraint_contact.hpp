#pragma once
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "contact/initial.hpp"
#include "solver/constraint/constraint_list.hpp"
#include "solver/constraint/constraint_pass.hpp"
#include "solver/constraint/searched_places.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// The constraint contacts of a model, types 17 and 18. When all other forces are known, nodes that would be behind the
/// other surface at the end of the next step get reactions that put them on it (impact of Hughes et al., Comput.
/// Methods Appl. Mech. Engng 8, 1976: bodies that meet move on together); a reaction that would pull is released. All
/// contacts are solved together, so nodes that share segments affect each other. A node that is already behind is moved
/// back onto the surface without force. Momentum is conserved, energy is lost in impacts. See docs/theory.
class ConstraintContact : public Force, public ContactSource {
 public:
  /// Nothing if the model has no such contact; a failure if one has nodes of rigid bodies or welds. `surfaces` and
  /// `initial` belong to this model and one initialisation; the calculation must start from initial.x. Uses the
  /// constraints that the structure has so far. `movable`: by node, whether it may be moved back. Model and surfaces
  /// must outlive it.
  static std::variant<std::unique_ptr<ConstraintContact>, Failure> create(const model::Model& model,
                                                                          contact::SurfaceStore& surfaces,
                                                                          const contact::InitialState& initial,
                                                                          const Structure& structure,
                                                                          std::vector<bool> movable);

  void add(State& state, Forces& forces) override;
  [[nodiscard]] bool reacts() const override { return true; }
  void react(const State& state, double mean, double next, Forces& net, Forces& external) override;
  void absorbed(Absorbed& work) const override;

  [[nodiscard]] std::span<const ContactState> states() const override { return states_; }
  [[nodiscard]] std::vector<ContactNode> nodes(std::size_t position) const override;
  void links(std::size_t position, std::vector<ContactLink>& links) const override;
  /// A node is no longer tied to a part: from the next search on it may contact it.
  void release(NodeIndex node, PartIndex part) {
    ties_.remove(node, part);
    searched_.forget();
  }
  /// How well the last cycle's constraints are met.
  [[nodiscard]] const ConstraintSolution& solution() const { return solution_; }

  [[nodiscard]] static bool calculates(const model::Contact& contact) {
    return choose_method(contact).method == ContactMethod::constraint;
  }

 private:
  struct Interface {
    ContactIndex contact;
    const contact::ContactSurfaces* surfaces = nullptr;
    /// Used if the initialisation has moved nodes or elements have failed.
    std::unique_ptr<contact::ContactSurfaces> own;
    std::vector<std::unique_ptr<ConstraintPass>> passes;
    double start = 0, end = 0;
    bool active = false;
  };
  ConstraintContact(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                    const Structure& structure, std::vector<bool> movable);
  [[nodiscard]] SolverStatus check_rigid_nodes(const Structure& structure) const;
  void build(const std::vector<Vector>& x);
  void add_passes(Interface& interface);
  /// Elements have failed since the last call.
  void erode(const State& state);
  /// Searches again if anything may have come too near since the last time.
  void renew_candidates();
  /// Sets the motion of the nodes over the next step without reactions, and their response to reactions.
  void predict_motion(const State& state, double mean, double next, const Forces& net);
  /// The constraint of a node that is behind; nothing if it does not approach the surface.
  [[nodiscard]] std::optional<SurfaceConstraint> constraint_of(const ConstraintPass::Hit& hit) const;
  /// Adds constraints for nodes that are behind now and have none; true if there are any.
  bool add_constraints();

  const model::Model& model_;
  contact::SurfaceStore& store_;
  bool moved_;  ///< by the initialisation
  std::vector<bool> movable_;
  Constraints held_;
  std::unique_ptr<contact::CandidateSearch> search_;
  contact::TiedPairs ties_;
  std::vector<std::uint32_t> nodes_;  ///< of all contacts
  std::vector<Interface> interfaces_;
  std::vector<ContactState> states_;
  std::vector<Vector> at_;  ///< coordinates that the passes see
  SearchedPlaces searched_;
  std::vector<Vector> way_;  ///< by node: over the next step, without reactions
  NodeResponse response_;
  ConstraintList constraints_;
  ConstraintSolution solution_;
  double step_ = 0;
  std::uint64_t failures_ = 0;  ///< FailedElements::count that the surfaces know
  bool built_ = false;
};

}  // namespace gapcheck::solver
