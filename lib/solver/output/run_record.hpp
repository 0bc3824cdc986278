#pragma once
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "solver/output/body_states.hpp"
#include "solver/output/boundary_work.hpp"
#include "solver/output/element_places.hpp"
#include "solver/output/element_states.hpp"
#include "solver/output/node_areas.hpp"
#include "solver/output/part_masses.hpp"
#include "solver/output/section_cuts.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// ∫ ω dt of the nodes of *DATABASE_HISTORY_NODE, component by component, as nodout prints rotations.
class NodeTurns {
 public:
  explicit NodeTurns(const Run& run);
  /// Once per step.
  void advance(const Run& run);
  /// By position in Output::history_nodes.
  [[nodiscard]] const Vector& rotation(std::size_t entry) const { return rotation_[entry]; }

 private:
  std::vector<Vector> rotation_;
  std::vector<Vector> spin_;  ///< in the step that follows the last evaluation
};

/// What the files of a run hold beyond the state of its last step. Text files and binout write the same from it.
struct RunRecord {
  PartMasses masses;
  NodeTurns turns;
  ElementPlaces places;
  HeldFreedoms held;
  std::vector<CutSection> sections;
  NodeAreas areas;
  BoundaryWork boundary;
  BodyTurns bodies;
  WeldForces welds;

  /// Only what the deck's intervals ask for is followed.
  RunRecord(const Run& run, const contact::ElementSizes& sizes, contact::SurfaceStore& surfaces);
  /// Once per step, after its forces are known and before its files are written.
  void advance(const Run& run);
};

/// What of the deck's requests for files a run does not do, with its place: all notes of the deck, sections that
/// are not calculated, and files without contents.
[[nodiscard]] std::vector<model::Output::Note> output_notes(const model::Model& model);

}  // namespace gapcheck::solver
