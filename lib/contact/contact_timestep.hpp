#pragma once
#include <optional>
#include <span>
#include <vector>

#include "contact/contact_surfaces.hpp"
#include "contact/element_sizes.hpp"
#include "contact/element_timestep.hpp"
#include "contact/stiffness.hpp"
#include "records/timesteps.hpp"

namespace gapcheck::contact {

/// What limits the time step on one side of a contact.
struct SideTimestep {
  double timestep = no_timestep_limit;
  NodeIndex node = none<NodeIndex>;  ///< controlling; without a limit the lowest node of the surface
  PartIndex part = none<PartIndex>;  ///< of a segment at that node
  bool triangles = false;            ///< a triangle is at that node: the solver's value differs somewhat
};

/// Estimates the stable time step of contact springs as the solver prints it when it initialises: for each side the
/// smallest √(m / (2 k)) of its nodes, with m the node's mass and k the weighted stiffness of the segments at the node.
/// Steps that differ by less than 1e-12 are equal; the lowest node controls. Source: contact rules, section 12.
/// Not for use from several threads. Model and sizes must outlive it.
class TimestepEstimate {
 public:
  TimestepEstimate(const model::Model& model, const ElementSizes& sizes);
  /// `scale`: SLSFAC · SFS (or SFM); SSF of *PART_CONTACT goes on top.
  [[nodiscard]] SideTimestep side(const Segments& segments, double scale);

 private:
  [[nodiscard]] NodeStiffness corner(const Segments& segments, std::size_t segment, double scale) const;
  [[nodiscard]] NodeIndex smallest(const Segments& segments);

  const model::Model& model_;
  const ElementSizes& sizes_;
  std::vector<double> masses_;         // by node
  std::vector<double> moduli_;         // by part, SSF included
  std::vector<NodeStiffness> sums_;    // by node; zero between calls
  std::vector<NodeStiffness> corners_; // by segment: what it adds at each corner
};

/// True for contacts of which the solver prints a time step: those with penalty springs and force transducers. Ties by
/// constraint, constraint types, rigid-body force curves, beads, edges and mortar have none.
[[nodiscard]] bool has_timestep(const ContactType& type);

/// Time steps of the given contacts (positions in Model::contacts) and of the elements.
struct PredictedTimesteps {
  Timesteps timesteps;
  std::optional<std::uint32_t> limiting;  ///< position of the smallest one in `surface_timesteps`; none: no limit
  ElementTimestep element;
};
[[nodiscard]] PredictedTimesteps predict_timesteps(const model::Model& model, SurfaceStore& surfaces,
                                                   std::span<const std::uint32_t> contacts);

/// The step that the elements and *CONTROL_TIMESTEP set: TSSFAC times the elements' step, or |DT2MS| where mass scaling
/// raises it. 0: not known.
[[nodiscard]] double run_timestep(const model::Controls& controls, double element_timestep);

}  // namespace gapcheck::contact
