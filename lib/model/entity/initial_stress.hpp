#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// The start of one integration point, in the model's units. Components xx yy zz xy yz zx in global axes.
struct StressPoint {
  double place = 0;  ///< T of shells: −1 at the lower, 1 at the upper side
  std::array<double, 6> stress{};
  double plastic_strain = 0;  ///< EPS
};

/// *INITIAL_STRESS_SHELL, _SOLID and their sets (Keyword User's Manual, Vol. I): what one element, or each of a set,
/// begins with.
struct InitialStress {
  enum class Kind : std::uint8_t { shell, shell_set, solid, solid_set } kind = Kind::shell;
  std::int64_t id = 0;        ///< of the element or set
  std::int64_t in_plane = 0;  ///< NPLANE; of solids all points, NINT
  std::int64_t layers = 1;    ///< NTHICK; 1 for solids
  // As written.
  std::int64_t history = 0, tensors = 0, thermal = 0;  ///< NHISV, NTENSR, NTHINT · NTHHSV
  std::int64_t large = 0, volume_flag = 0, group = 0;  ///< LARGE, IVEFLG, IALEGP
  bool history_used = false;                           ///< one of the history variables is not zero
  bool turned = false;                                 ///< an *INCLUDE_TRANSFORM turns or mirrors the mesh
  std::vector<StressPoint> points;                     ///< in_plane of the first layer, then those of the next
  Place place;

  /// The cards give a number of points and a form that can be read.
  [[nodiscard]] bool readable() const {
    constexpr std::int64_t most_points = 100, most_history = 1000;
    const bool counts = in_plane >= 1 && in_plane <= most_points && layers >= 1 && layers <= most_points;
    return counts && (large == 0 || large == 1) && history >= 0 && history <= most_history && tensors == 0 &&
           thermal == 0 && volume_flag == 0;
  }
  /// The deck has all its points.
  [[nodiscard]] bool complete() const {
    return static_cast<std::int64_t>(points.size()) == in_plane * layers && readable();
  }
};

}  // namespace gapcheck::model
