// Any bytes as the geometry of a d3plot. What is taken is consistent.
#include <cstdint>

#include "fuzz.hpp"
#include "results/d3plot/d3plot.hpp"

namespace gapcheck::fuzz::d3plot_target {
namespace {

template <std::size_t N>
void nodes_exist(const results::D3plot::Elements<N>& elements, std::size_t nodes) {
  require(elements.ids.size() == elements.nodes.size() && elements.ids.size() == elements.parts.size());
  for (const auto& element : elements.nodes)
    for (const std::uint32_t node : element) require(node < nodes);
}

}  // namespace

GAPCHECK_FUZZ_TARGET(d3plot) {
  const auto plot = results::read_d3plot_bytes(input, "fuzz");
  if (!plot) {
    require(!plot.error().message.empty());
    return;
  }
  const auto& mesh = plot.value();
  require(!mesh.node_ids.empty() && mesh.node_ids.size() == mesh.coordinates.size());
  nodes_exist(mesh.solids, mesh.node_ids.size());
  nodes_exist(mesh.thick_shells, mesh.node_ids.size());
  nodes_exist(mesh.beams, mesh.node_ids.size());
  nodes_exist(mesh.shells, mesh.node_ids.size());
  nodes_exist(mesh.particles, mesh.node_ids.size());
  require(results::mesh_source(mesh).coordinates.size() == mesh.node_ids.size());
}

}  // namespace gapcheck::fuzz::d3plot_target
