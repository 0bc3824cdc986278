#pragma once
#include <cstdint>
#include <set>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/element/beam_elements.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// The solver's properties of a beam section with constants. ELFORM 3 is a truss (001, 003, 009, 024), 1 and 9 are
/// integrated over their cross-section (001, 003, 009, 024; 9 also 100), all others are the resultant beam (001, 009).
/// A failure names the unsuitable section or material, limits of spotwelds out of range, or an area of zero. `written`:
/// the material as the deck has it.
[[nodiscard]] SolverResult<BeamProperties> beam_properties(const model::Section& section, const Material& material,
                                                           const model::Material& written);

/// What is not calculated for a deck's beams, and what is calculated as something else; each reported once.
class BeamLimits {
 public:
  BeamLimits(const model::Model& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  /// True for parts with sections that are not calculated: ELFORM other than 1 to 5, 9 and 13, or without constants.
  /// Beams of a null material only need an area. Reports what is left out and what is calculated as the resultant beam.
  bool leaves_out(PartIndex part);
  /// From the first node to a point in the plane of the axes r and s; zero if the deck gives none.
  [[nodiscard]] Vector third_point(std::uint32_t beam, const State& state);
  /// Offsets, the reference surface of the section and pin releases. A failure names what is not calculated of them.
  [[nodiscard]] SolverResult<BeamJoint> joint(std::uint32_t beam);
  /// Reports what was counted: offsets and pin releases that have no effect, beams without axes.
  void tell();

 private:
  const model::Model& model_;
  Diagnostics& diagnostics_;
  std::set<std::uint32_t> named_;  ///< sections
  std::size_t released_ = 0, shifted_ = 0, without_axes_ = 0;
};

}  // namespace gapcheck::solver
