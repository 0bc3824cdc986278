#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "contact/definition/friction.hpp"
#include "solver/interface/interface_pass.hpp"
#include "solver/mortar/mortar_offsets.hpp"
#include "solver/mortar/mortar_search.hpp"
#include "solver/mortar/mortar_stiffness.hpp"

namespace gapcheck::solver {

/// Mortar contact: faces against faces, by the pressure over their overlap in projection. Each pair has one resultant:
/// normal force, friction and damping at the centre of its pressure, on the corners of both faces with the weights of
/// the integrals, so that forces and, without friction, moments balance. The stiffness is that of the tracked face, but
/// nowhere steeper than the step leaves room for. Sources: docs/theory/solver-mortar.md.
class MortarPass final : public InterfacePass {
 public:
  /// `contact`: position in Model::contacts. `x` must be the coordinates of every later state.
  MortarPass(const ContactSetting& setting, ContactIndex contact, const contact::ContactSurfaces& surfaces,
             const std::vector<Vector>& x);
  MortarPass(const MortarPass&) = delete;
  MortarPass& operator=(const MortarPass&) = delete;

  void set_timestep(double timestep) override { stiffness_.set_timestep(timestep); }
  void find_candidates(double margin, ContactCounters& counters) override;
  double advance_state(State& state, double used, ContactCounters& counters) override;
  void add_forces(const State& state, Forces& forces, ContactState& result) const override;
  void continue_from(InterfacePass& before, const State& state, ContactState& result) override;
  void set_followed() override { first_ = false; }
  void deactivate(const State& state, ContactState& result) override;
  [[nodiscard]] std::string take_message() override { return std::exchange(message_, {}); }
  [[nodiscard]] double stored() const override;
  [[nodiscard]] std::vector<ContactNode> nodes() const override;
  void add_links(std::vector<ContactLink>& links) const override;

 private:
  /// Results of checking consecutive pairs, besides the pairs.
  struct Block {
    std::uint64_t checked = 0, asleep = 0;
    std::vector<std::uint32_t> busy;  ///< pairs with a force in this cycle or the last one, or released places
  };

  /// Calls `visit(pair number, block, scratch)` for all pairs, in blocks on all threads.
  template <class Visit>
  void for_each_pair(const Visit& visit);
  void measure_start(const State& state);
  void advance_pair(std::uint32_t number, const State& state, double used, Block& block, MortarSight& sight);
  /// Sets the force of a pair that has been seen; false: there is none.
  bool push_pair(MortarPair& pair, const MortarSight& sight, const State& state) const;
  [[nodiscard]] LinkSpring spring_of(const MortarPair& pair, const MortarLaw& law, double area) const;
  [[nodiscard]] bool exchanged(const MortarPair& pair) const { return surface_[pair.tracked].on_b; }

  const model::Contact& contact_;
  const std::vector<Vector>& x_;
  MortarSurface surface_;
  MortarSearch search_;
  MortarOffsets offsets_;
  MortarStiffness stiffness_;
  contact::Friction friction_;
  std::vector<MortarPair> pairs_;  // by key
  std::vector<Block> blocks_;
  bool first_ = true;
  std::string message_;
};

}  // namespace gapcheck::solver
