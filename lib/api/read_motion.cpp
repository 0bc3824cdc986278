#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <gapcheck/read_motion.hpp>
#include <numeric>
#include <system_error>
#include <utility>

#include "api/convert.hpp"
#include "results/d3plot/d3plot_states.hpp"

namespace gapcheck::api {
namespace {

namespace fs = std::filesystem;

void append_rows(const std::vector<std::array<double, 3>>& rows, std::vector<double>& numbers) {
  for (const std::array<double, 3>& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
}

/// The states that are asked for; an error names the first that is not there.
Result<std::vector<std::size_t>> chosen_states(const MotionOptions& options, std::size_t count) {
  std::vector<std::size_t> states = options.states;
  if (states.empty()) {
    states.resize(count);
    std::iota(states.begin(), states.end(), std::size_t{0});
  }
  const auto bad = std::find_if(states.begin(), states.end(), [count](std::size_t state) { return state >= count; });
  if (bad != states.end())
    return plain_error(fmt::format("states: there is no state {}; the file has {}, which count from 0", *bad, count));
  return states;
}

}  // namespace

Result<Motion> read_motion(const std::string& path, const MotionOptions& options) {
  std::error_code failed;
  const std::string file = fs::is_directory(path, failed) ? (fs::path(path) / "d3plot").string() : path;
  const auto plot = results::D3plotStates::open(file);
  if (!plot) return error_of(plot.error(), {});
  const auto states = chosen_states(options, plot.value().size());
  if (!states) return states.error();
  const auto& mesh = plot.value().mesh();
  Motion motion;
  motion.node = mesh.node_ids;
  append_rows(mesh.coordinates, motion.start);
  const bool velocities = options.velocities && plot.value().layout().velocities != 0;
  motion.positions.reserve(states.value().size() * motion.start.size());
  if (velocities) motion.velocities.reserve(motion.positions.capacity());
  for (const std::size_t i : states.value()) {
    const results::D3plotState state = plot.value().read(i);
    if (state.coordinates.size() != mesh.node_ids.size()) return Error{file, 0, "its states have no coordinates", {}};
    motion.times.push_back(state.time);
    append_rows(state.coordinates, motion.positions);
    if (velocities) append_rows(state.velocities, motion.velocities);
  }
  return motion;
}

}  // namespace gapcheck::api
