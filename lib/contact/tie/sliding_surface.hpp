#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/surface/surface.hpp"

namespace gapcheck::contact {

/// Follows nodes that slide along a surface without leaving it.
class SlidingSurface {
 public:
  /// The segments must outlive it.
  explicit SlidingSurface(const Segments& segments);

  /// The nearest point of the surface.
  struct Foot {
    SegmentIndex segment;
    double s = 0, t = 0;
    Vector point = Vector::Zero(), normal = Vector::Zero();  ///< unit, zero: the segment has no area
    /// The node is beside the surface: the way to it is not along the normal, by more than 0.1 of the segment's size.
    bool off = false;
  };
  /// Of a segment and those that share a node with it: the nearest one, of equally near ones the first.
  [[nodiscard]] Foot nearest(SegmentIndex from, const Vector& node, const std::vector<Vector>& x) const;
  [[nodiscard]] const Segments& segments() const { return segments_; }

 private:
  [[nodiscard]] std::span<const std::uint32_t> segments_at(NodeIndex node) const;

  const Segments& segments_;
  std::vector<NodeIndex> nodes_;  // ascending
  std::vector<std::uint32_t> first_, segments_at_;
};

}  // namespace gapcheck::contact
