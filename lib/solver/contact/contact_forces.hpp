#pragma once
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/initial.hpp"
#include "contact/stiffness/contact_timestep.hpp"
#include "solver/contact/contact_interface.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/contact/contact_setting.hpp"
#include "solver/contact/contact_source.hpp"
#include "solver/contact/interface_pass.hpp"
#include "solver/contact/search_margin.hpp"
#include "solver/state/force.hpp"

namespace gapcheck::solver {

/// The penalty contacts of a model, and the contact part of tiebreaks besides their ties: side A's nodes in side B's
/// segments. In deck order, SURFA's nodes before SURFB's, each on the coordinates left by the one before. Others are
/// left out.
class ContactForces : public Force, public ContactSource {
 public:
  /// `surfaces` and `initial` are of this model and of one initialisation; the calculation must start from initial.x.
  /// `movable`: by node, whether a shooting node may be moved. Model and surfaces must outlive it, and the first state
  /// must stay at its address.
  ContactForces(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                std::vector<bool> movable);

  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override;
  /// For the springs of eroding types, unless ECDT of *CONTROL_CONTACT says that they do not count.
  [[nodiscard]] double stable_step() const override { return stable_step_; }

  [[nodiscard]] std::span<const ContactState> states() const override { return states_; }
  [[nodiscard]] std::vector<ContactNode> nodes(std::size_t position) const override;
  void links(std::size_t position, std::vector<ContactLink>& links) const override;
  [[nodiscard]] std::optional<double> stored(std::size_t position) const override;
  [[nodiscard]] std::vector<ContactEvent> take_events() override { return std::exchange(events_, {}); }
  [[nodiscard]] const ContactCounters& counters() const { return counters_; }

  [[nodiscard]] static bool calculates(const model::Contact& contact) {
    const ContactMethod method = choose_method(contact).method;
    return method == ContactMethod::penalty ||
           (method == ContactMethod::tiebreak && contact.kind->tie != model::TieForm::tiebreak_only);
  }
  /// A tie of this node to a segment of this part has failed: from the next cycle on they are in contact like others.
  void release(NodeIndex node, PartIndex part);

 private:
  void build(const State& state);
  /// Elements have failed since the last call.
  void erode(const State& state);
  void limit_step();
  void gather_nodes();
  [[nodiscard]] bool search_is_due(const State& state) const;
  void find_candidates(const State& state);
  /// For one contact, between the searches for all of them.
  void find_candidates_again(std::size_t interface);
  /// How much of the margin is used up since the last search for this contact.
  [[nodiscard]] double used_since_search(std::size_t interface) const;
  /// Calculates one contact in this cycle: forces, energies and events.
  void advance_interface(std::size_t interface, State& state, Forces& forces);

  const model::Model& model_;
  contact::SurfaceStore& store_;
  std::vector<Penetration> found_;  ///< by the initialisation
  bool moved_ = false;              ///< by it
  std::vector<bool> movable_;
  ContactMasses masses_;
  std::unique_ptr<contact::CandidateSearch> search_;
  contact::TiedPairs ties_;
  SharedTables shared_;
  ContactSetting setting_;
  std::vector<ContactInterface> interfaces_;
  std::vector<ContactState> states_;
  std::vector<ContactEvent> events_;
  ContactCounters counters_;
  MarginUse margin_;                    ///< since the last search for all contacts
  std::vector<double> used_at_search_;  ///< by interface: how much of it was used up at its own last search
  std::int64_t sort_interval_ = 0;      ///< smallest BSORT; 0: none given
  std::uint64_t searched_ = 0;          ///< cycle of the last search
  std::uint64_t failures_ = 0;          ///< FailedElements::count that the surfaces know
  std::unique_ptr<contact::TimestepEstimate> estimate_;
  double stable_step_ = std::numeric_limits<double>::infinity();
  bool built_ = false;
  bool released_ = false;  ///< a tie has failed since the last search
};

}  // namespace gapcheck::solver
