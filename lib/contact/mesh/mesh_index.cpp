#include "contact/mesh/mesh_index.hpp"

#include "base/union_find.hpp"

namespace gapcheck::contact {

/// `each(visit)` calls visit(row, entry) for all entries, twice the same.
template <class Each>
void ElementIndex::Rows::fill(std::size_t rows, const Each& each) {
  start.assign(rows + 1, 0);
  each([&](std::uint32_t row, std::uint32_t) { ++start[row + 1]; });
  for (std::size_t i = 0; i < rows; ++i) start[i + 1] += start[i];
  list.resize(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  each([&](std::uint32_t row, std::uint32_t entry) { list[next[row]++] = entry; });
}

std::span<const std::uint32_t> ElementIndex::at(NodeIndex node) {
  if (by_node_.start.empty())
    by_node_.fill(mesh_nodes_, [&](const auto& visit) {
      for (std::uint32_t e = 0; e < part_.size(); ++e)
        for (std::size_t i = 0; i < per_element_; ++i)
          if (const NodeIndex n = nodes_[e * per_element_ + i]; n.value < mesh_nodes_) visit(n.value, e);
    });
  return by_node_.row(node.value);
}

std::span<const std::uint32_t> ElementIndex::of(PartIndex part) {
  if (by_part_.start.empty())
    by_part_.fill(parts_, [&](const auto& visit) {
      for (std::uint32_t e = 0; e < part_.size(); ++e)
        if (part_[e].value < parts_) visit(part_[e].value, e);
    });
  return by_part_.row(part.value);
}

std::shared_ptr<const std::vector<std::uint32_t>> MeshIndex::bodies() {
  if (bodies_) return bodies_;
  UnionFind connected(mesh.nodes.size());
  for (const model::Elements<8>* elements : {&mesh.solids, &mesh.thick_shells})
    for (const auto& nodes : elements->nodes)
      for (const NodeIndex n : nodes)
        if (n.value < connected.size() && nodes[0].value < connected.size()) connected.unite(n.value, nodes[0].value);
  auto bodies = std::make_shared<std::vector<std::uint32_t>>(connected.size());
  for (std::uint32_t n = 0; n < bodies->size(); ++n) (*bodies)[n] = connected.root(n);
  bodies_ = std::move(bodies);
  return bodies_;
}

}  // namespace gapcheck::contact
