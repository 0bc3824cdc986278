#pragma once
#include <optional>
#include <vector>

#include "contact/mesh/rigid_nodes.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// How deep a point lies in a rigid wall, in deck units, and the point of the wall's surface that is nearest to it.
struct WallPenetration {
  double depth = 0;
  Vector surface = Vector::Zero();
  Vector normal = Vector::Zero();  ///< normal of the wall there, away from its material
};

/// Nothing if the point is outside, touches (up to 1e-9 of the coordinates' size), or is not finite. Behind a plane
/// every depth counts; behind a rectangle only points along its normal. In a prism, cylinder or sphere the depth is the
/// distance to the nearest of its faces that is not at infinity.
[[nodiscard]] std::optional<WallPenetration> wall_penetration(const model::RigidWall& wall, const Vector& x);

/// The same where a point touches up to the depth `tolerance`.
[[nodiscard]] std::optional<WallPenetration> wall_penetration(const model::RigidWall& wall, const Vector& x,
                                                              double tolerance);

/// The nodes that rigid walls stop. What all walls share is computed once.
class WallNodes {
 public:
  /// The model must outlive it.
  explicit WallNodes(const model::Model& model);
  /// Ascending: those of the wall's set (without a set: all that an element uses), without those of its exempted set,
  /// those of rigid bodies (unless RWPNAL is set) and those outside its box or offset.
  [[nodiscard]] std::vector<NodeIndex> of(const model::RigidWall& wall);

 private:
  const model::Model& model_;
  std::optional<RigidNodes> rigid_;  ///< none: nodes of rigid bodies count
  std::vector<NodeIndex> all_;       ///< what walls without a set stop; filled for the first one
};

}  // namespace gapcheck::contact
