// Any bytes as a d3plot with its states; what follows a line of equals signs are the next files of the family.
#include <fmt/format.h>

#include "fuzz.hpp"
#include "results/d3plot/d3plot_states.hpp"

namespace gapcheck::fuzz::states_target {

GAPCHECK_FUZZ_TARGET(states) {
  static const Folder folder;
  const auto files = parts(input);
  folder.clear();
  const std::string path = folder.write("d3plot", files.front());
  for (std::size_t i = 1; i < files.size() && i < 4; ++i) folder.write(fmt::format("d3plot{:02}", i), files[i]);
  const auto opened = results::D3plotStates::open(path);
  if (!opened) {
    require(!opened.error().message.empty());
    return;
  }
  const auto& plot = opened.value();
  require(plot.size() == plot.times().size());
  for (std::size_t i = 0; i < plot.size() && i < 20; ++i) {
    const results::D3plotState state = plot.read(i);
    require(state.coordinates.empty() || state.coordinates.size() == plot.mesh().node_ids.size());
    require(state.velocities.empty() || state.velocities.size() == plot.mesh().node_ids.size());
    require(state.solids.empty() || state.solids.size() == plot.mesh().solids.ids.size());
    require(state.shells.empty() || state.shells.size() == plot.mesh().shells.ids.size());
    require(state.shell_points.size() == state.shells.size() * state.layers || state.shells.empty());
  }
}

}  // namespace gapcheck::fuzz::states_target
