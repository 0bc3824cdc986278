#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "audit/selection.hpp"
#include "contact/crossing/crossings.hpp"
#include "contact/initial.hpp"
#include "contact/stiffness/contact_timestep.hpp"
#include "contact/surface/contact_mesh.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::audit {

/// Results that the rules of one audit share, each computed when a rule first asks for it, and the counters of this
/// work.
class SharedResults {
 public:
  /// The selection must outlive it.
  explicit SharedResults(const Selection& selection) : selection_(selection), surfaces_(selection.model()) {}

  /// The surfaces of a contact on the deck's coordinates; kept once built.
  [[nodiscard]] const contact::ContactSurfaces& surfaces(ContactIndex contact) { return surfaces_.at(contact); }
  [[nodiscard]] contact::SurfaceStore& surface_store() { return surfaces_; }
  /// The segments of the selected contacts, each once.
  [[nodiscard]] contact::ContactMesh& contact_mesh();
  /// The initialisation of all contacts, with the kinds of penetrations that the selected rules need.
  [[nodiscard]] contact::InitialState& initial();
  [[nodiscard]] bool initialised() const { return initial_.has_value(); }
  /// The initialisation of some of the contacts and of all ties on other surfaces; penetrating nodes are
  /// not moved. Costs as much as the contacts' share of initial().
  [[nodiscard]] contact::InitialState initial_if(contact::SurfaceStore& surfaces,
                                                 const std::vector<ContactIndex>& contacts);
  /// Time steps of the selected contacts and of the elements.
  [[nodiscard]] const contact::PredictedTimesteps& timesteps();

  /// How often rules asked for surfaces, searches or time steps.
  [[nodiscard]] std::uint64_t requests() const { return requests_ + surfaces_.asked(); }
  [[nodiscard]] const contact::InitialCounters& counters() const { return counters_; }
  /// How the rules about crossing elements decided.
  [[nodiscard]] contact::CrossingCounters& crossing_counters() { return crossing_counters_; }
  /// Counts the surfaces of a store that a rule made for initial_if().
  void count_other(const contact::SurfaceStore& surfaces) { other_surfaces_ += surfaces.built(); }
  /// Surfaces with another thickness than the deck's, and the counters of initial_if() on them.
  [[nodiscard]] std::uint64_t other_surfaces() const { return other_surfaces_ + other_counters_.surfaces_built; }
  [[nodiscard]] const contact::InitialCounters& other_counters() const { return other_counters_; }

 private:
  [[nodiscard]] contact::InitialOptions initial_options() const;

  const Selection& selection_;
  contact::SurfaceStore surfaces_;
  std::optional<contact::ContactMesh> contact_mesh_;
  std::optional<contact::InitialState> initial_;
  std::optional<contact::PredictedTimesteps> timesteps_;
  contact::InitialCounters counters_, other_counters_;
  contact::CrossingCounters crossing_counters_;
  std::uint64_t requests_ = 0, other_surfaces_ = 0;
};

}  // namespace gapcheck::audit
