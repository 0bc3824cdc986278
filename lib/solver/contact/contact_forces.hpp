#pragma once
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/initial.hpp"
#include "contact/stiffness/contact_timestep.hpp"
#include "solver/contact/contact_interface.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/contact/search_margin.hpp"
#include "solver/interface/contact_setting.hpp"
#include "solver/interface/contact_source.hpp"
#include "solver/interface/interface_pass.hpp"
#include "solver/state/force.hpp"

namespace gapcheck::solver {

/// The penalty contacts of a model, and the contact part of tiebreaks besides their ties: side A's nodes in side B's
/// segments. In deck order, SURFA's nodes before SURFB's, each on the coordinates left by the one before. Others are
/// left out. Contacts with the same cards share one interface, which is calculated once, and each adds its forces; as
/// soon as a node is moved between them, the later ones have an interface of their own.
class ContactForces : public Force, public ContactSource {
 public:
  /// `surfaces` and `initial` are of this model and of one initialisation; the calculation must start from initial.x.
  /// `movable`: by node, whether a shooting node may be moved. Model and surfaces must outlive it, and the first state
  /// must stay at its address.
  ContactForces(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                std::vector<bool> movable, SpringFormula formula = SpringFormula::documented);

  void log_shot_nodes(std::vector<ShotNode>* list) { setting_.shot = list; }  ///< gets moved nodes; must outlive it
  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override;
  /// For the springs of eroding types, unless ECDT of *CONTROL_CONTACT says that they do not count.
  [[nodiscard]] double stable_step() const override { return stable_step_; }

  [[nodiscard]] std::span<const ContactState> states() const override { return states_; }
  [[nodiscard]] std::vector<ContactNode> nodes(std::size_t position) const override;
  void links(std::size_t position, std::vector<ContactLink>& links) const override;
  [[nodiscard]] std::optional<double> stored(std::size_t position) const override;
  ContactInterface& interface(std::size_t i) { return interfaces_[interface_of_[i]]; }  ///< that of states()[i]
  [[nodiscard]] std::vector<ContactEvent> take_events() override { return std::exchange(events_, {}); }
  [[nodiscard]] const ContactCounters& counters() const { return counters_; }
  /// Interfaces that have had nothing near so far.
  [[nodiscard]] std::size_t waiting() const;

  [[nodiscard]] static bool calculates(const model::Contact& contact) {
    const ContactMethod method = choose_method(contact).method;
    return method == ContactMethod::penalty ||
           (method == ContactMethod::tiebreak && contact.kind->tie != model::TieForm::tiebreak_only);
  }
  /// The nodes that this contact pushes at the moment.
  [[nodiscard]] std::vector<Touch> touches(ContactIndex contact) const;
  /// From the next cycle on the node is tied to this part, and contact between them ends.
  void hold(NodeIndex node, PartIndex part) { ties_.add(node, part), released_ = true; }
  /// A tie of this node to a segment of this part has failed: from the next cycle on they are in contact like others.
  void release(NodeIndex node, PartIndex part) { ties_.remove(node, part), released_ = true; }

 private:
  /// An interface that several contacts share.
  struct Shared {
    std::vector<std::uint32_t> positions;  ///< ascending; the first one calculates
    InterfaceMemory before;                ///< what it remembered at the beginning of its last cycle
    std::uint64_t moves = 0;               ///< `moves_` at that time
  };

  /// What is needed while the interfaces are built.
  struct Building {
    contact::SideCache sides;
    std::vector<ContactIndex> first;  ///< by contact, that which it repeats
    /// By such a first one: position of the last equal one that calculates.
    std::map<ContactIndex, std::uint32_t> last;
  };

  void build(const State& state);
  /// For the next contact, unless an earlier one acts for it.
  void add_interface(ContactIndex contact, Building& building, const State& state);
  /// Elements have failed since the last call.
  void erode(const State& state);
  /// The surfaces are new or changed: their nodes, and the step of their springs.
  void follow_surfaces();
  [[nodiscard]] bool search_is_due(const State& state) const;
  void find_candidates(const State& state);
  /// For one contact, between the searches for all of them.
  void find_candidates_again(std::uint32_t interface);
  /// How much of the margin is used up since the last search for this contact.
  [[nodiscard]] double used_since_search(std::uint32_t interface) const;
  /// Calculates one contact in this cycle: forces, energies and events.
  void advance_contact(std::size_t position, State& state, Forces& forces);
  /// The same by its interface.
  void advance_interface(std::size_t position, State& state, Forces& forces);
  /// The same as the first contact of its interface has done in this cycle.
  void repeat_interface(std::size_t position, const State& state, Forces& forces);
  /// Another interface for this contact and the later ones that share its interface.
  void part_interface(std::size_t position);
  /// Its sums are those of the first contact of its interface.
  void repeat_state(std::size_t position);

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
  std::vector<std::uint32_t> interface_of_;  ///< by position among the contacts
  std::map<std::uint32_t, Shared> sharing_;  ///< by interface, those of several contacts
  std::vector<ContactState> states_;
  std::uint64_t moves_ = 0;  ///< of shooting nodes, so far
  std::vector<ContactEvent> events_;
  ContactCounters counters_;
  MarginUse margin_;                    ///< since the last search for all contacts
  std::vector<double> used_at_search_;  ///< by interface: how much of it was used up at its own last search
  std::int64_t sort_interval_ = 0;      ///< smallest BSORT; 0: none given
  std::uint64_t searched_ = 0;          ///< cycle of the last search; they begin again after a relaxation
  std::uint64_t failures_ = 0;          ///< FailedElements::count that the surfaces know
  std::unique_ptr<contact::TimestepEstimate> estimate_;
  double stable_step_ = std::numeric_limits<double>::infinity();
  bool built_ = false;
  bool released_ = false;  ///< a tie has failed or begun since the last search
};

}  // namespace gapcheck::solver
