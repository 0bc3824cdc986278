#pragma once
#include <cstdint>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"

namespace gapcheck::contact {

/// The element that limits the time step of a run.
struct ElementTimestep {
  double timestep = 0;  ///< without TSSFAC; 0: no element has one
  model::ElementKind kind = model::ElementKind::shell;
  std::uint32_t element = 0;  ///< position in the array of its kind
};

/// Speed of sound: shells √(E / (ρ (1 - ν²))), solids √(E (1 - ν) / ((1 + ν) (1 - 2 ν) ρ)) or √(K / ρ) if only K is
/// known, beams √(E / ρ). 0 if the material does not say.
[[nodiscard]] double shell_sound_speed(const model::Material& material, double density, std::int64_t isdo);
[[nodiscard]] double solid_sound_speed(const model::Material& material, double density);
[[nodiscard]] double beam_sound_speed(const model::Material& material, double density);

/// Characteristic length of a solid: V / largest face; tetrahedra: their lowest height, 3 V / largest face.
[[nodiscard]] double solid_length(const std::array<NodeIndex, 8>& nodes, double volume, const std::vector<Vector>& x);

/// The smallest step, characteristic length / speed of sound, of all deformable shells, solids, thick shells and beams;
/// of equal ones the first (shells, solids, thick shells, beams). Rigid parts, and materials whose constants are not
/// read, have none. Source: LS-DYNA Theory Manual, time step control; no mass scaling.
[[nodiscard]] ElementTimestep smallest_element_timestep(const model::Model& model, const ElementSizes& sizes);

/// The `count` smallest of these steps, ascending; of equal ones the first.
[[nodiscard]] std::vector<ElementTimestep> smallest_element_timesteps(const model::Model& model,
                                                                      const ElementSizes& sizes, std::size_t count);

/// Speed of sound by part in each kind of element; 0: its elements have no step.
struct PartSpeeds {
  explicit PartSpeeds(const model::Model& model);
  std::vector<double> shell, solid, beam;  ///< solid: thick shells too
};

/// The steps of single elements on any coordinates, by the same rules. The model must outlive it.
class ElementSteps {
 public:
  explicit ElementSteps(const model::Model& model) : model_(model), speeds_(model) {}
  /// `element`: position in the array of its kind. Infinity: it has none.
  [[nodiscard]] double operator()(model::ElementKind kind, std::uint32_t element, const std::vector<Vector>& x) const;
  /// The smallest step of all elements. Infinity: none has one.
  [[nodiscard]] double smallest(const std::vector<Vector>& x) const;

 private:
  const model::Model& model_;
  PartSpeeds speeds_;
};

}  // namespace gapcheck::contact
