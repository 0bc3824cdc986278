#include "solver/build/build_folded_shells.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/build/build_full_shells.hpp"

namespace gapcheck::solver {

SolverResult<FoldedShell> folded_shells(const model::Model& model, PartIndex part, const model::Section& section,
                                        Diagnostics& diagnostics) {
  const model::Controls& controls = model.controls;
  const bool full = full_shell(section);
  const std::int64_t flag = full ? controls.nfail4 : controls.nfail1;
  if (flag <= 0) return FoldedShell::allowed;
  if (const std::int64_t id = controls.psnfail; id != 0) {
    const auto set = model.sets.parts.find(id);
    if (set == model.sets.parts.end())
      return Failure{
          Failure::Kind::contradiction,
          fmt::format("PSNFAIL of *CONTROL_SHELL names part set {}, which is not defined; define it or set 0", id),
          controls.shell_place};
    const auto& members = set->second.members;
    if (std::find(members.begin(), members.end(), part) == members.end()) return FoldedShell::allowed;
  }
  if (flag > 2)
    diagnostics.warning(
        model.file(controls.shell_place), controls.shell_place.line,
        fmt::format("part {}: {} = {} is calculated as 1: distorted shells fail, but their number does not "
                    "end the run",
                    model.part(part).id.value, full ? "NFAIL4" : "NFAIL1", flag));
  return flag == 2 ? FoldedShell::ends_run : FoldedShell::fails;
}

}  // namespace gapcheck::solver
