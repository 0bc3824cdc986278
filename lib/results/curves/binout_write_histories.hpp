#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "results/curves/binout_write.hpp"
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

// More branches, of the files whose text is written beside their rows. What is in the metadata (ids of sections, walls,
// …) is that of the first state, and must stay the same.

void add_secforc(BinoutWriter& binout, const std::vector<LegendEntry>& titles, double time,
                 std::span<const SectionState> sections);
void add_spcforc(BinoutWriter& binout, double time, const SupportStates& states);
/// One branch for the nodes and one for the rigid bodies of each kind.
void add_bndout(BinoutWriter& binout, double time, std::span<const BoundaryState> states);
void add_rwforc(BinoutWriter& binout, const std::vector<LegendEntry>& titles, double time,
                std::span<const WallForce> walls);
/// Nodal rigid bodies must come last.
void add_rbdout(BinoutWriter& binout, std::uint64_t cycle, double time, std::span<const BodyMotion> bodies);
void add_swforc(BinoutWriter& binout, double time, std::span<const WeldForce> welds);
/// One branch for each kind; `titles` by StressKind. Shells with several points in the plane have "npl".
void add_elout(BinoutWriter& binout, const std::array<std::vector<LegendEntry>, 3>& titles, std::uint64_t cycle,
               double time, bool local, std::span<const ElementStress> elements);
void add_abstat(BinoutWriter& binout, const std::vector<LegendEntry>& titles, double time,
                std::span<const AirbagRow> airbags);
void add_deforc(BinoutWriter& binout, double time, std::span<const SpringForce> springs);
void add_jntforc(BinoutWriter& binout, double time, std::span<const JointForce> joints);

}  // namespace gapcheck::results
