#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// Which elements of one kind have a node, and which belong to a part. Each table is built on first use, linear in the
/// number of elements. The elements must outlive it. Not for use from several threads.
class ElementIndex {
 public:
  template <std::size_t N>
  ElementIndex(const model::Elements<N>& elements, const model::Model& model)
      : nodes_(elements.size() > 0 ? elements.nodes.front().data() : nullptr),
        per_element_(N),
        part_(elements.part),
        mesh_nodes_(model.mesh.nodes.size()),
        parts_(model.parts.size()) {}
  /// Positions of the elements at the node, ascending; one that repeats the node occurs several times.
  [[nodiscard]] std::span<const std::uint32_t> at(NodeIndex node);
  /// Positions of the elements of the part, ascending.
  [[nodiscard]] std::span<const std::uint32_t> of(PartIndex part);

 private:
  struct Rows {
    std::vector<std::uint32_t> start, list;
    template <class Each>
    void fill(std::size_t rows, const Each& each);
    [[nodiscard]] std::span<const std::uint32_t> row(std::uint32_t i) const {
      return {list.data() + start[i], list.data() + start[i + 1]};
    }
  };
  const NodeIndex* nodes_;
  std::size_t per_element_;
  std::span<const PartIndex> part_;
  std::size_t mesh_nodes_, parts_;
  Rows by_node_, by_part_;  // no starts: not asked for
};

/// The elements of a mesh by node and part, so that thousands of contacts need not each scan the whole mesh for their
/// surfaces. The model must outlive it and not change.
struct MeshIndex {
  explicit MeshIndex(const model::Model& model)
      : mesh(model.mesh),
        shells(model.mesh.shells, model),
        solids(model.mesh.solids, model),
        thick_shells(model.mesh.thick_shells, model),
        beams(model.mesh.beams, model),
        particles(model.mesh.particles, model) {}
  /// By node: the connected body of solids and thick shells, as the number of its first node. Built on first use.
  [[nodiscard]] std::shared_ptr<const std::vector<std::uint32_t>> bodies();

  const model::Mesh& mesh;
  ElementIndex shells, solids, thick_shells, beams, particles;

 private:
  std::shared_ptr<const std::vector<std::uint32_t>> bodies_;
};

}  // namespace gapcheck::contact
