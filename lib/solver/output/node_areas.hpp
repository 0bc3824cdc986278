#pragma once
#include <map>
#include <tuple>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// The segments around the nodes of the contacts' sides, as the run begins.
class NodeAreas {
 public:
  NodeAreas() = default;
  /// Of all contacts that are calculated.
  NodeAreas(const model::Model& model, contact::SurfaceStore& surfaces);

  /// The force on a node of a side (0: A, 1: B) along the normal there, over its share of the areas now: a quarter of
  /// each quad, a third of each triangle. Not below zero; 0 for a node without segments.
  [[nodiscard]] double pressure(ContactIndex contact, std::size_t side, NodeIndex node, const Vector& force,
                                const std::vector<Vector>& x) const;

 private:
  void add(ContactIndex contact, std::size_t side, const contact::Segments& segments);

  std::map<std::tuple<ContactIndex, std::size_t, NodeIndex>, std::vector<model::SegmentNodes>> around_;
};

}  // namespace gapcheck::solver
