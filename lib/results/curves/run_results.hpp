#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/intfor_history.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "results/history/airbag_states.hpp"
#include "results/history/body_motion.hpp"
#include "results/history/boundary_forces.hpp"
#include "results/history/element_stress.hpp"
#include "results/history/joint_forces.hpp"
#include "results/history/section_forces.hpp"
#include "results/history/spring_forces.hpp"
#include "results/history/support_forces.hpp"
#include "results/history/wall_forces.hpp"
#include "results/history/weld_forces.hpp"

namespace gapcheck::results {

/// The result files in the directory of a run, as text or in its binout; empty: missing, or without a state.
struct RunResults {
  std::string directory;
  std::vector<GlobalState> glstat;
  InterfaceHistory rcforc, sleout;
  PartHistory matsum;
  NodeHistory nodout;
  History<SectionState> secforc;
  SupportHistory spcforc;
  BoundaryHistory bndout;
  History<WallForce> rwforc;
  History<BodyMotion> rbdout;
  History<WeldForce> swforc;
  History<ElementStress> elout;
  History<SpringForce> deforc;
  History<JointForce> jntforc;
  History<AirbagRow> abstat;
  SurfaceHistory intfor;
  std::vector<std::string> missing;  ///< names of missing files of the first five

  /// Path of one of them.
  [[nodiscard]] std::string path(std::string_view name) const;
};

/// Reads the existing files; what has no text file is taken from a binout. `nodes`: nodout, secforc and all behind it
/// as well. An empty directory name is the current one.
[[nodiscard]] RunResults read_run_results(const std::string& directory, bool nodes, Diagnostics& diagnostics);

}  // namespace gapcheck::results
