#pragma once
#include <cstdint>

#include "model/model.hpp"

namespace gapcheck::contact {

// Penalty stiffness of contact, one function per formula. Units: those of the deck. A quotient whose divisor is not
// positive is 0: the value is unknown, and no stiffness is better than an infinite one. Source: contact rules, section
// 6; for the printed time step: contact rules, section 12.3.

/// Bulk modulus that contact uses for a material: K, or E / (3 (1 - 2 ν)); *MAT_FABRIC: Ea / (1 - ν²). 0 = unknown.
[[nodiscard]] double contact_modulus(const model::Material& material);
/// The same for a part; 0 without a material.
[[nodiscard]] double contact_modulus(const model::Model& model, PartIndex part);

/// SOFT = 0, segment of a solid: scale · K · A² / V. `scale` = SLSFAC · SFS (or SFM).
[[nodiscard]] double solid_segment_stiffness(double scale, double modulus, double area, double volume);
/// SOFT = 0, segment of a shell: scale · K · A / length; the length is the longest diagonal, in the printed time step
/// the larger of thickness and shorter diagonal.
[[nodiscard]] double shell_segment_stiffness(double scale, double modulus, double area, double length);

/// Area-weighted stiffness of a node: Σ w k / Σ w over the segments at it, w = A / number of the segment's corners.
struct NodeStiffness {
  double weight = 0, weighted = 0;  ///< Σ w, Σ w k
  NodeStiffness& operator+=(const NodeStiffness& other) {
    weight += other.weight;
    weighted += other.weighted;
    return *this;
  }
  [[nodiscard]] double value() const { return weight > 0 ? weighted / weight : 0; }
};

/// What PENOPT of *CONTROL_CONTACT chooses from.
struct PairStiffness {
  double node = 0;           ///< of the tracked node's segment
  double segment = 0;        ///< of the reference segment
  double node_weighted = 0;  ///< NodeStiffness of the tracked node
  double thickness = 0;      ///< of the tracked node's shell
};
/// Stiffness of one contact spring, SOFT = 0. PENOPT 1: the smaller of both; 2: segment; 3: node; 4: node, weighted;
/// 5: as 4, divided by the thickness. Others count as 1.
[[nodiscard]] double spring_stiffness(std::int64_t penopt, const PairStiffness& pair);

/// SOFT = 1 before SOFSCL: 0.5 m* / Δt², m* the smaller of the node's mass and that of the segment's nodes.
[[nodiscard]] double soft_1_stiffness(double node_mass, double segment_mass, double timestep);
/// SOFT = 1: the larger of the SOFT = 0 stiffness and SOFSCL times the one above.
[[nodiscard]] double soft_1_spring(double soft_0, double sofscl, double soft_1);
/// SOFT = 2: 0.5 · scale · m1 m2 / (m1 + m2) / Δt².
[[nodiscard]] double soft_2_stiffness(double scale, double mass1, double mass2, double timestep);

}  // namespace gapcheck::contact
