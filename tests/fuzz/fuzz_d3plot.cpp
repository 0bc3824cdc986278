// The function under test: any bytes as a d3plot. It must neither crash nor hang nor need more memory than a small
// multiple of the input, and what it takes must be consistent.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "results/d3plot/d3plot.hpp"

namespace {

template <std::size_t N>
void check(const gapcheck::results::D3plot::Elements<N>& elements, std::size_t nodes) {
  if (elements.ids.size() != elements.nodes.size() || elements.ids.size() != elements.parts.size()) std::abort();
  for (const auto& element : elements.nodes)
    for (const std::uint32_t node : element)
      if (node >= nodes) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto plot = gapcheck::results::read_d3plot_bytes({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!plot) return plot.error().message.empty() ? (std::abort(), 0) : 0;
  const auto& mesh = plot.value();
  if (mesh.node_ids.empty() || mesh.node_ids.size() != mesh.coordinates.size()) std::abort();
  check(mesh.solids, mesh.node_ids.size());
  check(mesh.thick_shells, mesh.node_ids.size());
  check(mesh.beams, mesh.node_ids.size());
  check(mesh.shells, mesh.node_ids.size());
  check(mesh.particles, mesh.node_ids.size());
  if (gapcheck::results::mesh_source(mesh).coordinates.size() != mesh.node_ids.size()) std::abort();
  return 0;
}
