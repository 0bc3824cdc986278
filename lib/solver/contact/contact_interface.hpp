#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/erosion.hpp"
#include "solver/contact/contact_setting.hpp"
#include "solver/contact/interface_pass.hpp"
#include "solver/contact/segment_crossings.hpp"

namespace gapcheck::solver {

/// One penalty contact of a run: its present surfaces, the passes over them, and how they follow time and step.
class ContactInterface {
 public:
  /// `contact`: position in Model::contacts. `moved`: the initialisation has moved nodes, so the store's surfaces do
  /// not match `state`. `sides`: of the contacts built so far on these coordinates. All references but this one must
  /// outlive it, and the state must stay at its address.
  ContactInterface(const ContactSetting& setting, contact::SurfaceStore& store, contact::SideCache& sides,
                   ContactIndex contact, bool moved, const State& state);

  [[nodiscard]] ContactIndex contact() const { return contact_; }
  [[nodiscard]] const model::Contact& card() const { return setting_.model.contact(contact_); }
  [[nodiscard]] const contact::ContactSurfaces& surfaces() const { return *surfaces_; }
  [[nodiscard]] bool has_offsets() const;
  [[nodiscard]] std::span<const std::unique_ptr<InterfacePass>> passes() const { return passes_; }
  [[nodiscard]] bool acts_at(double time) const { return time >= start_ && time < end_; }

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
  void add_passes(const std::vector<Vector>& x);
  void set_timestep(double timestep);

  const ContactSetting& setting_;
  ContactIndex contact_;
  const contact::ContactSurfaces* surfaces_ = nullptr;
  /// Used if the initialisation has moved nodes, thickness changes or elements have failed.
  std::unique_ptr<contact::ContactSurfaces> own_;
  std::shared_ptr<contact::ContactSide> inflated_;  ///< side A of `own_` where thickness changes; else null
  std::vector<std::unique_ptr<InterfacePass>> passes_;
  double start_ = 0, end_ = 0;
  bool active_ = false;                                    ///< in the last cycle
  const model::Curve* thickness_ = nullptr;                ///< over time (LCIDAB); nullptr: constant
  double present_thickness_ = 0, searched_thickness_ = 0;  ///< now, and at the last search
  double first_step_ = 0;
  double step_ = 0;  ///< used by the stiffness; 0: it stays that of the first cycle, or DTSTIF
  SegmentCrossings crossings_;
};

}  // namespace gapcheck::solver
