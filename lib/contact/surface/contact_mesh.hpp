#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/segment_quality.hpp"

namespace gapcheck::contact {

/// A use of an edge by a segment; kept at the edge's lower node.
struct EdgeUse {
  NodeIndex other;            ///< the edge's higher node
  std::uint32_t segment = 0;  ///< position in the ContactMesh
};

/// Most uses of edges at one node that are compared with one another; a sound mesh has a tenth of it.
inline constexpr std::size_t most_uses = 64;

/// The mesh as contact sees it: the segments of all contacts, each only once. In the order of the contacts, those that
/// tie after all others, of their sides and segments. Beam axes are left out. Costly data is computed on first use; not
/// for use from several threads while that may happen.
class ContactMesh {
 public:
  /// Model and surfaces must outlive it.
  ContactMesh(const model::Model& model, SurfaceStore& surfaces, std::span<const ContactIndex> contacts);

  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  [[nodiscard]] const model::SegmentNodes& nodes(std::size_t i) const {
    return surface(i).nodes[segments_[i].position];
  }
  /// Position in the array of its kind; max = unknown.
  [[nodiscard]] std::uint32_t element(std::size_t i) const { return surface(i).element[segments_[i].position]; }
  [[nodiscard]] model::ElementKind kind(std::size_t i) const { return surface(i).element_kind[segments_[i].position]; }
  [[nodiscard]] PartIndex part(std::size_t i) const { return part_of(model_.mesh, surface(i), segments_[i].position); }
  /// The first contact that has the segment; one that ties only if no other has it.
  [[nodiscard]] ContactIndex contact(std::size_t i) const { return sources_[segments_[i].source].contact; }
  /// No contact has the segment but ties, which look at it once.
  [[nodiscard]] bool only_tied(std::size_t i) const { return sources_[segments_[i].source].ties; }
  /// The same element (or none is known, and then never).
  [[nodiscard]] bool same_element(std::size_t i, std::size_t j) const {
    return element(i) != no_position && element(i) == element(j) && kind(i) == kind(j);
  }

  /// Shapes of the segments, in the same order.
  [[nodiscard]] const std::vector<SegmentQuality>& quality();
  /// Nodes that some segment has, ascending.
  [[nodiscard]] const std::vector<NodeIndex>& corners();
  /// All uses of edges whose lower node is the given one. Needs build_edges().
  [[nodiscard]] std::span<const EdgeUse> edges_at(std::size_t node) const {
    return {edges_.data() + edge_start_[node], edges_.data() + edge_start_[node + 1]};
  }
  void build_edges();
  [[nodiscard]] const model::Model& model() const { return model_; }

 private:
  struct Source {
    const Segments* segments;
    ContactIndex contact;
    bool ties;
  };
  struct Segment {
    std::uint32_t source, position;
  };
  [[nodiscard]] const Segments& surface(std::size_t i) const { return *sources_[segments_[i].source].segments; }

  const model::Model& model_;
  std::vector<Source> sources_;
  std::vector<Segment> segments_;
  std::vector<SegmentQuality> quality_;
  std::vector<NodeIndex> corners_;
  std::vector<std::uint32_t> edge_start_;
  std::vector<EdgeUse> edges_;
};

}  // namespace gapcheck::contact
