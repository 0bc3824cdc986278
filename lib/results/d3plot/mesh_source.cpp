#include "results/d3plot/mesh_source.hpp"

#include "results/d3plot/d3plot.hpp"

namespace gapcheck::results {
namespace {

template <std::size_t N>
void add_parts(const D3plot& plot, const D3plot::Elements<N>& elements, MeshSource& source) {
  for (std::size_t i = 0; i < elements.nodes.size(); ++i)
    for (const std::uint32_t node : elements.nodes[i]) source.parts.try_emplace(plot.node_ids[node], elements.parts[i]);
}

}  // namespace

MeshSource mesh_source(const D3plot& plot) {
  MeshSource source;
  source.coordinates.reserve(plot.node_ids.size());
  source.parts.reserve(plot.node_ids.size());
  for (std::size_t i = 0; i < plot.node_ids.size(); ++i) {
    const auto& x = plot.coordinates[i];
    source.coordinates.try_emplace(plot.node_ids[i], x[0], x[1], x[2]);
  }
  add_parts(plot, plot.shells, source);
  add_parts(plot, plot.solids, source);
  add_parts(plot, plot.thick_shells, source);
  add_parts(plot, plot.beams, source);
  add_parts(plot, plot.particles, source);
  return source;
}

}  // namespace gapcheck::results
