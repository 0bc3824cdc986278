#pragma once
#include <array>
#include <cstdint>

#include "base/ids.hpp"
#include "base/vector.hpp"

namespace gapcheck::keyword {

using TransformIndex = Typed<struct TransformIndexTag, std::uint32_t>;

/// The families of ids that *INCLUDE_TRANSFORM shifts apart.
enum class IdKind : std::uint8_t { plain, node, element, part, material, set, function, define, other };

/// Offsets, scale and placement of one *INCLUDE_TRANSFORM, all enclosing ones included.
struct Transform {
  std::array<std::int64_t, 9> offset{};  ///< by IdKind; `plain` stays 0
  double length_factor = 1;              ///< FCTLEN; applied to coordinates before the placement
  double mass_factor = 1, time_factor = 1;
  bool automatic = false;  ///< offsets of nodes and elements include those of *INCLUDE_AUTO_OFFSET
  bool places = false;     ///< false: matrix and shift are the identity
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Vector shift = Vector::Zero();
  /// The position in the model of a point of the included file.
  [[nodiscard]] Vector apply(const Vector& x) const { return places ? matrix * x + shift : x; }
};

}  // namespace gapcheck::keyword
