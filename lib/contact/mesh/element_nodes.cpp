#include "contact/mesh/element_nodes.hpp"

#include <atomic>

#include "base/parallel.hpp"

namespace gapcheck::contact {

std::vector<std::uint8_t> element_nodes(const model::Mesh& mesh) {
  std::vector<std::uint8_t> used(mesh.nodes.size());
  const auto mark = [&](const auto& elements) {
    parallel_for(elements.size(), 16384, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e)
        for (const NodeIndex n : elements.nodes[e])
          if (n != none<NodeIndex>) std::atomic_ref(used[n.value]).store(1, std::memory_order_relaxed);
    });
  };
  mark(mesh.shells);
  mark(mesh.solids);
  mark(mesh.thick_shells);
  mark(mesh.beams);
  mark(mesh.discrete);
  mark(mesh.masses);
  mark(mesh.particles);
  return used;
}

}  // namespace gapcheck::contact
