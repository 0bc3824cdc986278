#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/definition/active_time.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/erosion.hpp"
#include "solver/contact/segment_crossings.hpp"
#include "solver/interface/contact_setting.hpp"
#include "solver/interface/interface_pass.hpp"

namespace gapcheck::solver {

class ContactPass;

/// What an interface remembers from cycle to cycle.
struct InterfaceMemory {
  bool active = false;
  std::vector<std::unique_ptr<PassMemory>> passes;
};

/// One penalty contact of a run: its present surfaces, the passes over them, and how they follow time and step. Most of
/// many contacts have nothing near: where that changes nothing, the passes are made when the first search needs them.
class ContactInterface {
 public:
  /// `contact`: position in Model::contacts. `moved`: the initialisation has moved nodes, so the store's surfaces do
  /// not match `state`. `sides`: of the contacts built so far on these coordinates. All references but this one must
  /// outlive it, and the state must stay at its address.
  ContactInterface(const ContactSetting& setting, contact::SurfaceStore& store, contact::SideCache& sides,
                   ContactIndex contact, bool moved, const State& state);

  /// Continues as `other`, the interface of a contact with the same cards, would have from what it remembered.
  ContactInterface(const ContactInterface& other, ContactIndex contact, const InterfaceMemory& memory);

  [[nodiscard]] ContactIndex contact() const { return contact_; }
  [[nodiscard]] const model::Contact& card() const { return setting_.model.contact(contact_); }
  [[nodiscard]] const contact::ContactSurfaces& surfaces() const { return *surfaces_; }
  [[nodiscard]] bool has_offsets() const;
  /// Empty: nothing has been near so far.
  [[nodiscard]] std::span<const std::unique_ptr<InterfacePass>> passes() const { return passes_; }
  /// Makes the passes, if that has not been done.
  void begin_passes();
  [[nodiscard]] bool acts_now(const State& state) const { return times_.at(state.time, state.relaxing); }
  /// After the relaxation.
  [[nodiscard]] bool acts_at(double time) const { return times_.at(time, false); }
  /// The passes over nodes in segments.
  [[nodiscard]] std::vector<const ContactPass*> node_passes() const;
  /// The step that the stiffness of SOFT = 1 and 2 follows.
  [[nodiscard]] double stiffness_step() const;

  /// Whether it may act for other contacts with the same cards: its memory is known, and only coordinates and
  /// velocities change it.
  [[nodiscard]] bool can_be_shared() const;
  [[nodiscard]] InterfaceMemory memory() const;

  /// Sets what the initialisation did to the nodes. `found`: the records of all contacts, sorted by contact.
  void set_memories(std::span<const Penetration> found);
  /// Rebuilds the surfaces after elements have failed; the passes continue on them.
  void erode(contact::SurfaceStore& store, const contact::GoneElements& gone, const State& state, ContactState& result);
  /// Global search of all passes at the present thickness.
  void find_candidates(double margin, ContactCounters& counters);
  /// Sets the current thickness; returns by how much both halves together have grown since the last search.
  double update_thickness(double time);
  /// SOFT = 2: stiffness follows the step, plus the checks of DTPCHK.
  [[nodiscard]] std::optional<ContactEvent> follow_step(const State& state);
  void activate() { active_ = true; }
  /// The contact does not act: its forces end.
  void deactivate(const State& state, ContactState& result);

 private:
  void build_surfaces(contact::SurfaceStore& store, contact::SideCache& sides, bool moved,
                      const std::vector<Vector>& x);
  void set_own_surfaces(const contact::ContactSurfaces& surfaces);
  void add_passes();
  /// Whether the passes may wait for something to be near: nothing in them depends on the coordinates at their start.
  [[nodiscard]] bool may_wait() const;
  /// False if no node of one side can be a candidate of the other side.
  [[nodiscard]] bool sides_are_near(double margin) const;
  void set_timestep(double timestep);

  const ContactSetting& setting_;
  const std::vector<Vector>& x_;  ///< coordinates of the state
  ContactIndex contact_;
  const contact::ContactSurfaces* surfaces_ = nullptr;
  /// Used if the initialisation has moved nodes, thickness changes or elements have failed.
  std::unique_ptr<contact::ContactSurfaces> own_;
  std::shared_ptr<contact::ContactSide> inflated_;  ///< side A of `own_` where thickness changes; else null
  std::vector<std::unique_ptr<InterfacePass>> passes_;
  contact::ActiveTimes times_;
  bool active_ = false;                                    ///< in the last cycle
  const model::Curve* thickness_ = nullptr;                ///< over time (LCIDAB); nullptr: constant
  double present_thickness_ = 0, searched_thickness_ = 0;  ///< now, and at the last search
  double first_step_ = 0;
  double step_ = 0;  ///< used by the stiffness; 0: it stays that of the first cycle, or DTSTIF
  std::unique_ptr<SegmentCrossings> crossings_;  ///< of SOFT = 2; else null
};

}  // namespace gapcheck::solver
