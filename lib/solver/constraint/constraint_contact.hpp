#pragma once
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "contact/initial.hpp"
#include "solver/constraint/constraint_pass.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// The constraint contacts of a model, types 17 and 18. When all other forces are known, nodes that would be behind the
/// other surface at the end of the coming step get reactions that put them on it (impact of Hughes et al., Comput.
/// Methods Appl. Mech. Engng 8, 1976: what meets goes on together); a reaction that would pull is released. All
/// contacts are solved together, so nodes that share segments see each other. A node that already is behind is moved
/// back onto the surface without force. Momentum is kept, energy is lost in impacts. See docs/theory.
class ConstraintContact : public Force, public ContactSource {
 public:
  /// Nothing where the model has no such contact; a failure where one has nodes of rigid bodies or welds. `surfaces`
  /// and `initial` are of this model and of one initialisation; the calculation must start from initial.x. Uses the
  /// constraints that the structure has by now. `movable`: by node, whether it may be moved back. Model and surfaces
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
  /// A node is tied to a part no more: from the next search on it may meet it.
  void release(NodeIndex node, PartIndex part) {
    ties_.remove(node, part);
    searched_.clear();
  }
  /// How well the last cycle's constraints are met.
  [[nodiscard]] const ConstraintSolution& solution() const { return solution_; }

  [[nodiscard]] static bool calculates(const model::Contact& contact) {
    return choose_method(contact).method == ContactMethod::constraint;
  }

 private:
  struct Interface {
    std::uint32_t contact = 0;
    const contact::ContactSurfaces* surfaces = nullptr;
    /// Where the initialisation has moved nodes or elements have failed.
    std::unique_ptr<contact::ContactSurfaces> own;
    std::vector<std::unique_ptr<ConstraintPass>> passes;
    double start = 0, end = 0;
    bool active = false;
  };
  /// Beside constraints_: where a constraint comes from.
  struct Origin {
    std::uint32_t interface = 0, pass = 0, slot = 0;
    double area = 0;
  };
  ConstraintContact(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                    const Structure& structure, std::vector<bool> movable);
  [[nodiscard]] std::optional<Failure> rigid_nodes(const Structure& structure) const;
  void build(const std::vector<Vector>& x);
  void add_passes(Interface& interface);
  /// Elements have failed since the last call.
  void erode(const State& state);
  /// Searches again where anything may have come too near since the last time.
  void follow();
  void predict(const State& state, double mean, double next, const Forces& net);
  /// Adds constraints for nodes that are behind now and have none; true if there are any.
  bool add_constraints();
  void add_work(const State& state);
  void apply(Forces& net, Forces& external);

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
  std::vector<Vector> at_;        ///< coordinates that the passes see
  std::vector<Vector> searched_;  ///< those of the last search, beside nodes_
  std::vector<Vector> way_;       ///< by node: over the coming step, without reactions
  NodeResponse response_;
  std::vector<SurfaceConstraint> constraints_;
  std::vector<Origin> origins_;
  ConstraintSolution solution_;
  double margin_ = 0, step_ = 0;
  std::uint64_t failures_ = 0;  ///< FailedElements::count that the surfaces know
  bool built_ = false;
};

}  // namespace gapcheck::solver
