#include "contact/crossing/heights_over.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace gapcheck::contact {
namespace {

/// A convex polygon that is cut smaller. Each of three cuts of a triangle adds one corner; where rounding makes it
/// more, as on triangles without an area, corners beyond that are left out.
class Polygon {
 public:
  explicit Polygon(const geometry::Triangle& t) { std::copy(t.begin(), t.end(), corners_.begin()); }
  /// Keeps what has a distance of at least 0: distance(x), linear.
  template <class Distance>
  void cut(const Distance& distance) {
    const Polygon whole = *this;
    count_ = 0;
    for (std::size_t i = 0; i < whole.count_; ++i) {
      const Vector &from = whole.corners_[i], &to = whole.corners_[(i + 1) % whole.count_];
      const double a = distance(from), b = distance(to);
      if (a >= 0) add(from);
      if ((a >= 0) != (b >= 0)) add(from + a / (a - b) * (to - from));
    }
  }
  [[nodiscard]] const Vector* begin() const { return corners_.data(); }
  [[nodiscard]] const Vector* end() const { return corners_.data() + count_; }

 private:
  void add(const Vector& corner) {
    if (count_ < corners_.size()) corners_[count_++] = corner;
  }

  std::array<Vector, 8> corners_;
  std::size_t count_ = 3;
};

}  // namespace

Heights heights_over(const geometry::Triangle& base, const geometry::Triangle& t, double slack, const Vector& up) {
  Vector normal = (base[1] - base[0]).cross(base[2] - base[0]).stableNormalized();
  Polygon rest(t);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& origin = base[i];
    const Vector inward = normal.cross(base[(i + 1) % 3] - origin).stableNormalized();
    rest.cut([&](const Vector& x) { return inward.dot(x - origin) + slack; });
  }
  if (normal.dot(up) < 0) normal = -normal;
  Heights heights;
  for (const Vector& x : rest) {
    const double height = normal.dot(x - base[0]);
    heights.low = std::min(heights.low, height);
    heights.high = std::max(heights.high, height);
  }
  return heights;
}

}  // namespace gapcheck::contact
