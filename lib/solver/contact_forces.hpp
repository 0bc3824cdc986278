#pragma once
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "contact/initial.hpp"
#include "solver/contact_pass.hpp"
#include "solver/force.hpp"

namespace gapcheck::solver {

/// The penalty contacts of a model: types 3, a3, 4, 5, a5, 10, a10, 13 and the forming ones, SOFT = 0 and 1. In deck
/// order, SURFA's nodes before SURFB's, each on the coordinates that the one before has left. Others are left out.
class ContactForces : public Force {
 public:
  /// `surfaces` and `initial` are of this model and of one initialisation; the calculation must start from initial.x.
  /// `movable`: by node, whether a shooting node may be moved. Model and surfaces must outlive it, and the state that
  /// comes first must stay where it is.
  ContactForces(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                std::vector<bool> movable);

  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override;

  /// One for each contact that is calculated, in deck order.
  [[nodiscard]] std::span<const ContactState> states() const { return states_; }
  /// The tracked nodes in the contact zone of one of them.
  [[nodiscard]] std::vector<ContactNode> nodes(std::size_t contact) const;
  [[nodiscard]] const ContactCounters& counters() const { return counters_; }

  /// Why a contact is not calculated; empty: it is. Force transducers are not, and do nothing.
  [[nodiscard]] static std::string_view why_not(const model::Contact& contact);
  [[nodiscard]] static bool calculates(const model::Contact& contact) { return why_not(contact).empty(); }

 private:
  struct Interface {
    std::uint32_t contact = 0;
    const contact::ContactSurfaces* surfaces = nullptr;
    contact::ContactSurfaces own;  ///< where the initialisation has moved nodes
    std::vector<std::unique_ptr<ContactPass>> passes;
    double start = 0, end = 0;
    bool active = false;
    const model::Curve* thickness = nullptr;  ///< over time (LCIDAB); nullptr: constant
    double present_thickness = 0, searched_thickness = 0;  ///< now, and at the last search
  };
  /// Sets the thickness of the time; returns by how much both halves together have grown since the last search.
  static double grow(Interface& interface, double time);
  void build(State& state);
  void remember(Interface& interface) const;
  void search(const State& state);
  /// How far anything has come closer to anything else in the last step, at most.
  [[nodiscard]] double approach(const State& state) const;

  const model::Model& model_;
  contact::SurfaceStore& store_;
  std::vector<Penetration> found_;  ///< by the initialisation
  bool moved_ = false;              ///< by it
  std::vector<bool> movable_;
  ContactMasses masses_;
  std::unique_ptr<contact::CandidateSearch> search_;
  contact::Ties ties_;
  ContactSetting setting_;
  std::vector<Interface> interfaces_;
  std::vector<ContactState> states_;
  std::vector<std::uint32_t> nodes_;  ///< of all interfaces
  ContactCounters counters_;
  Vector drift_ = Vector::Zero();  ///< middle of all velocities at the last search: moving together brings nothing closer
  double margin_ = 0, used_ = 0;
  std::int64_t sort_interval_ = 0;  ///< least BSORT; 0: none is given
  std::uint64_t searched_ = 0;      ///< cycle of the last search
  bool built_ = false;
};

}  // namespace gapcheck::solver
