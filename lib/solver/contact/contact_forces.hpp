#pragma once
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/stiffness/contact_timestep.hpp"
#include "contact/initial.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/contact/contact_setting.hpp"
#include "solver/contact/contact_source.hpp"
#include "solver/state/force.hpp"
#include "solver/contact/interface_pass.hpp"
#include "solver/contact/segment_crossings.hpp"

namespace gapcheck::solver {

/// The penalty contacts of a model, and what tiebreak contacts are beside their ties: side A's nodes in side B's
/// segments. In deck order, SURFA's nodes before SURFB's, each on the coordinates that the one
/// before has left. Others are left out.
class ContactForces : public Force, public ContactSource {
 public:
  /// `surfaces` and `initial` are of this model and of one initialisation; the calculation must start from initial.x.
  /// `movable`: by node, whether a shooting node may be moved. Model and surfaces must outlive it, and the state that
  /// comes first must stay where it is.
  ContactForces(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                std::vector<bool> movable);

  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override;
  /// That of the springs of eroding types, unless ECDT of *CONTROL_CONTACT says that they do not count.
  [[nodiscard]] double stable_step() const override { return stable_step_; }

  [[nodiscard]] std::span<const ContactState> states() const override { return states_; }
  [[nodiscard]] std::vector<ContactNode> nodes(std::size_t position) const override;
  void links(std::size_t position, std::vector<ContactLink>& links) const override;
  [[nodiscard]] std::vector<ContactEvent> take_events() override { return std::exchange(events_, {}); }
  [[nodiscard]] const ContactCounters& counters() const { return counters_; }

  [[nodiscard]] static bool calculates(const model::Contact& contact) {
    const ContactMethod method = choose_method(contact).method;
    return method == ContactMethod::penalty ||
           (method == ContactMethod::tiebreak && !contact.keyword.ends_with("_ONLY"));
  }
  /// A tie of this node to a segment of this part has failed: from the next cycle on they meet like others.
  void release(NodeIndex node, PartIndex part);

 private:
  struct Interface {
    std::uint32_t contact = 0;
    const contact::ContactSurfaces* surfaces = nullptr;
    /// Where the initialisation has moved nodes, thickness changes or elements have failed.
    std::unique_ptr<contact::ContactSurfaces> own;
    std::vector<std::unique_ptr<InterfacePass>> passes;
    double start = 0, end = 0;
    bool active = false;
    const model::Curve* thickness = nullptr;  ///< over time (LCIDAB); nullptr: constant
    double present_thickness = 0, searched_thickness = 0;  ///< now, and at the last search
    double step = 0;  ///< that stiffness reckons with; 0: it stays that of the first cycle, or DTSTIF
    SegmentCrossings crossings;
  };
  /// Sets the thickness of the time; returns by how much both halves together have grown since the last search.
  static double grow(Interface& interface, double time);
  void build(State& state);
  /// Elements have failed since the last call.
  void erode(const State& state);
  void limit_step();
  void gather_nodes();
  void add_passes(Interface& interface, const std::vector<Vector>& x);
  void remember(Interface& interface) const;
  void search(const State& state);
  /// SOFT = 2: stiffness follows the step, and what DTPCHK asks for.
  void follow(Interface& interface, const State& state);
  /// How far anything has come closer to anything else in the last step, at most.
  [[nodiscard]] double approach(const State& state) const;

  const model::Model& model_;
  contact::SurfaceStore& store_;
  std::vector<Penetration> found_;  ///< by the initialisation
  bool moved_ = false;              ///< by it
  std::vector<bool> movable_;
  ContactMasses masses_;
  std::unique_ptr<contact::CandidateSearch> search_;
  contact::TiedPairs ties_;
  ContactSetting setting_;
  std::vector<Interface> interfaces_;
  std::vector<ContactState> states_;
  std::vector<ContactEvent> events_;
  std::vector<std::uint32_t> nodes_;  ///< of all interfaces
  ContactCounters counters_;
  Vector drift_ = Vector::Zero();  ///< middle of all velocities at the last search: moving together brings nothing closer
  double margin_ = 0, used_ = 0;
  double first_step_ = 0;
  std::int64_t sort_interval_ = 0;  ///< least BSORT; 0: none is given
  std::uint64_t searched_ = 0;      ///< cycle of the last search
  std::uint64_t failures_ = 0;      ///< FailedElements::count that the surfaces know
  std::unique_ptr<contact::TimestepEstimate> estimate_;
  double stable_step_ = std::numeric_limits<double>::infinity();
  bool built_ = false;
  bool released_ = false;  ///< a tie has failed since the last search
};

}  // namespace gapcheck::solver
