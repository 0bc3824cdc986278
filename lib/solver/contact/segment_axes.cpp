#include "solver/contact/segment_axes.hpp"

#include <cmath>

namespace gapcheck::solver {
namespace {

/// Below it the diagonals are parallel within the accuracy of doubles.
constexpr double least_sine = 1e-10;

}  // namespace

SegmentAxes::SegmentAxes(const model::SegmentNodes& nodes, const std::vector<Vector>& x)
    : SegmentAxes({x[nodes[0].value], x[nodes[1].value], x[nodes[2].value], x[nodes[3].value]}, nodes[2] == nodes[3]) {}

SegmentAxes::SegmentAxes(const model::SegmentNodes& nodes, const std::vector<Vector>& x, const std::vector<Vector>& v,
                         double time)
    : SegmentAxes({x[nodes[0].value] + time * v[nodes[0].value], x[nodes[1].value] + time * v[nodes[1].value],
                   x[nodes[2].value] + time * v[nodes[2].value], x[nodes[3].value] + time * v[nodes[3].value]},
                  nodes[2] == nodes[3]) {}

SegmentAxes::SegmentAxes(const std::array<Vector, 4>& at, bool triangle) : SegmentAxes() {
  const Vector first = triangle ? at[1] - at[0] : at[2] - at[0], second = triangle ? at[2] - at[0] : at[3] - at[1];
  const Vector cross = first.cross(second);
  const double size = cross.norm(), lengths = first.norm() * second.norm();
  if (!(size > least_sine * lengths) || !std::isfinite(lengths)) return;
  sound = true;
  const Vector normal = cross / size;
  const Vector along = (first.normalized() + second.normalized()).normalized();
  axes << along, normal.cross(along), normal;
  // The normal turns with the slopes of both lines, the bisector with the mean of their turns about the normal.
  const Vector dual_first = second.cross(normal) / size, dual_second = normal.cross(first) / size;
  const auto part = [&](const Vector& line, const Vector& dual) -> Matrix {
    return normal * normal.cross(line).transpose() / (2 * line.squaredNorm()) - normal.cross(dual) * normal.transpose();
  };
  const Matrix of_first = part(first, dual_first), of_second = part(second, dual_second);
  if (triangle)
    turn = {-of_first - of_second, of_first, of_second, Matrix::Zero()};
  else
    turn = {-of_first, -of_second, of_first, of_second};
}

Vector SegmentAxes::spin(const model::SegmentNodes& nodes, const std::vector<Vector>& v) const {
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < 4; ++i) sum += turn[i] * v[nodes[i].value];
  return sum;
}

}  // namespace gapcheck::solver
