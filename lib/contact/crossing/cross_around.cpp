#include "contact/crossing/cross_around.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gapcheck::contact {
namespace {

/// A way away from the line, as a direction across it.
struct Way {
  double angle = 0;   ///< about the line, 0 to 2 π
  double length = 0;  ///< of the triangle across the line
};

/// Measures angles about a line.
class AroundLine {
 public:
  explicit AroundLine(const geometry::Line& line)
      : origin_(line.from), along_((line.to - line.from).stableNormalized()), first_(along_.unitOrthogonal()) {}

  /// The ways of triangles: one each, or two of one that lies across the line.
  [[nodiscard]] std::vector<Way> ways_of(std::span<const geometry::Triangle> triangles, double tolerance) const {
    std::vector<Way> ways;
    for (const geometry::Triangle& t : triangles) {
      const Vector farthest = *std::max_element(t.begin(), t.end(), [&](const Vector& p, const Vector& q) {
        return across(p).squaredNorm() < across(q).squaredNorm();
      });
      add(across(farthest), tolerance, ways);
      const Vector back = *std::min_element(t.begin(), t.end(), [&](const Vector& p, const Vector& q) {
        return across(p).dot(across(farthest)) < across(q).dot(across(farthest));
      });
      if (across(back).dot(across(farthest)) < 0) add(across(back), tolerance, ways);
    }
    return ways;
  }

 private:
  [[nodiscard]] Vector across(const Vector& x) const { return x - origin_ - along_ * along_.dot(x - origin_); }

  void add(const Vector& way, double tolerance, std::vector<Way>& ways) const {
    const double length = way.norm();
    if (!(length > tolerance)) return;
    const double angle = std::atan2(way.dot(along_.cross(first_)), way.dot(first_));
    ways.push_back({angle < 0 ? angle + 2 * std::numbers::pi : angle, length});
  }

  Vector origin_, along_, first_;
};

/// From one angle on to another, 0 to 2 π.
double turn(double from, double to) { return to < from ? to - from + 2 * std::numbers::pi : to - from; }

/// Two ways are the same within the tolerance.
bool meet(const Way& a, const Way& b, double tolerance) {
  const double angle = std::abs(a.angle - b.angle), between = std::min(angle, 2 * std::numbers::pi - angle);
  return between < std::numbers::pi / 2 && std::sin(between) * std::min(a.length, b.length) <= tolerance;
}

}  // namespace

bool cross_around(const geometry::Line& line, std::span<const geometry::Triangle> a,
                  std::span<const geometry::Triangle> b, double tolerance) {
  const AroundLine around(line);
  const std::vector<Way> of_a = around.ways_of(a, tolerance);
  std::vector<Way> of_b = around.ways_of(b, tolerance);
  std::erase_if(of_b, [&](const Way& way) {
    return std::any_of(of_a.begin(), of_a.end(), [&](const Way& other) { return meet(way, other, tolerance); });
  });
  // Some pair of a's ways has ways of b on both sides.
  for (const Way& from : of_a)
    for (const Way& to : of_a) {
      const double sector = turn(from.angle, to.angle);
      const auto within = [&](const Way& way) { return turn(from.angle, way.angle) < sector; };
      if (sector > 0 && std::any_of(of_b.begin(), of_b.end(), within) && !std::all_of(of_b.begin(), of_b.end(), within))
        return true;
    }
  return false;
}

}  // namespace gapcheck::contact
