#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "audit/untangle/cut_surface.hpp"
#include "contact/search/search.hpp"
#include "geometry/closest_point.hpp"

namespace gapcheck::audit {

/// A segment, and the side of it on which nodes belong: 1 in front of its normal, -1 behind it.
struct FaceSide {
  SegmentIndex segment;
  double side = 1;
};

/// The segment of a region that is nearest to a node.
struct NearestFace {
  FaceSide face;
  double distance = 0;   ///< from its mid-surface; infinite: there is none
  bool in_band = false;  ///< the node is above or below the segment, or beside it by no more than a quarter
  bool above = false;    ///< the nearest point is not on an edge where the surface ends
};

/// Part of a surface that is connected over edges with two segments. It carries a side along: neighbours that run
/// through their common edge in opposite directions have their normals on the same side.
class FaceRegion {
 public:
  /// The surface must outlive it.
  explicit FaceRegion(const CutSurface& surface) : surface_(surface) {}
  /// Grows from these segments over those that meet the box. False if that takes more than `work` steps, which are
  /// taken off it.
  [[nodiscard]] bool grow(std::span<const FaceSide> from, const contact::Bounds& box, std::uint64_t& work);
  /// In the order in which they were reached.
  [[nodiscard]] const std::vector<FaceSide>& faces() const { return faces_; }
  /// Among segments without this node; linear in faces().
  [[nodiscard]] NearestFace nearest(NodeIndex node) const;

 private:
  void pass(const FaceSide& face, NodeIndex a, NodeIndex b, const contact::Bounds& box);
  [[nodiscard]] bool at_end(SegmentIndex segment, const geometry::ClosestPoint& closest) const;
  void add(const FaceSide& face);
  [[nodiscard]] contact::Bounds bounds(SegmentIndex segment) const;

  const CutSurface& surface_;
  std::map<std::uint32_t, double> side_;
  std::vector<FaceSide> faces_;
  std::vector<contact::Bounds> boxes_;  ///< beside faces_
};

}  // namespace gapcheck::audit
