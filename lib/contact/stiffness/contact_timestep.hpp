#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "contact/stiffness/element_timestep.hpp"
#include "contact/stiffness/segment_spring.hpp"
#include "contact/stiffness/stiffness.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "records/timesteps.hpp"

namespace gapcheck::contact {

/// What limits the time step on one side of a contact.
struct SideTimestep {
  double timestep = no_timestep_limit;
  NodeIndex node = none<NodeIndex>;  ///< controlling; without a limit the lowest node of the surface
  PartIndex part = none<PartIndex>;  ///< of a segment at that node
  double mass = 0, stiffness = 0;    ///< of that node
};

/// Which limit is meant. `printed`: the one that the solver prints when it initialises, √(m / (2 k)) with masses and
/// stiffness of its own (contact rules, section 12.3). `spring`: 2 √(m / k) with the stiffness of the springs
/// themselves (contact rules, section 6.1), the step at which a node oscillates without bound against a rigid surface.
enum class TimestepLimit : std::uint8_t { printed, spring };

/// The time step of contact springs: for each side the smallest limit of its nodes, with m the node's mass and k the
/// weighted stiffness of the segments at the node.
/// Steps that differ by less than 1e-12 are equal; the lowest node controls. Source: contact rules, section 12.3.
/// Not for use from several threads. Model and sizes must outlive it.
class TimestepEstimate {
 public:
  TimestepEstimate(const model::Model& model, const ElementSizes& sizes);
  /// `scale`: SLSFAC · SFS (or SFM); SSF of *PART_CONTACT goes on top.
  [[nodiscard]] SideTimestep side(const Segments& segments, double scale, TimestepLimit limit = TimestepLimit::printed);
  /// The same against a free node of the other side with its mass M and stiffness K: the least of
  /// √(m M / ((m + M) min(k, K))), as printed for transducers, or of twice that for springs.
  [[nodiscard]] SideTimestep side_against(const Segments& segments, double scale, const SideTimestep& other,
                                          TimestepLimit limit);
  /// Of a surface that is its own other side: side() and, against what that found, side_against().
  [[nodiscard]] std::pair<SideTimestep, SideTimestep> side_against_itself(const Segments& segments, double scale,
                                                                          TimestepLimit limit);

 private:
  /// Fills `corners_` and `sums_`.
  void sum(const Segments& segments, double scale, TimestepLimit limit);
  /// Sets `sums_` to zero again.
  void clear(const Segments& segments);
  /// The least of the sums' squared_step(m, k).
  template <class SquaredStep>
  [[nodiscard]] SideTimestep least(const Segments& segments, TimestepLimit limit, const SquaredStep& squared_step);
  template <class SquaredStep>
  [[nodiscard]] NodeIndex controlling(const Segments& segments, TimestepLimit limit, const SquaredStep& squared_step);
  [[nodiscard]] const std::vector<double>& masses(TimestepLimit limit) const {
    return limit == TimestepLimit::printed ? printed_masses_ : masses_;
  }
  /// Then all nodes are visited, not the corners of the segments.
  [[nodiscard]] bool most_of_the_mesh(const Segments& segments) const { return segments.size() > sums_.size() / 8; }

  const model::Model& model_;
  SegmentSprings springs_;
  const ElementSizes& sizes_;
  std::vector<double> printed_masses_;  // by node
  std::vector<double> masses_;          // by node; empty until the springs' own step is asked for
  std::vector<NodeStiffness> sums_;     // by node; zero between calls
  std::vector<NodeStiffness> corners_;  // by segment: what it adds at each corner
  std::vector<double> squared_;         // by node; used if most of the mesh is in the surface
};

/// True for contacts of which the solver prints a time step: those with penalty springs, mortar ones and force
/// transducers. Ties by constraint, constraint types, rigid-body force curves, beads and edges have none.
[[nodiscard]] bool has_timestep(const ContactType& type);

/// A side of a contact whose springs are unstable at the step of the run.
struct UnstableSide {
  std::uint32_t surface = 0;  ///< position in Timesteps::surface_timesteps
  SideTimestep limit;         ///< of the springs
  bool alone = true;          ///< even against a surface that does not move; false: only against free nodes
};

/// Time steps of contacts and of the elements.
struct PredictedTimesteps {
  Timesteps timesteps;
  ElementTimestep element;
  double run = 0;  ///< run_timestep
  /// Ascending. Transducers have no springs, those of SOFT = 2 follow the step, mortar contacts have others.
  std::vector<UnstableSide> unstable;
};
/// Of the elements and of the sides of these contacts.
[[nodiscard]] PredictedTimesteps predict_timesteps(const model::Model& model, SurfaceStore& surfaces,
                                                   std::span<const ContactIndex> contacts);

/// The step that the elements and *CONTROL_TIMESTEP set: TSSFAC times the elements' step, or |DT2MS| if mass scaling
/// raises it. 0: not known.
[[nodiscard]] double run_timestep(const model::Controls& controls, double element_timestep);

}  // namespace gapcheck::contact
