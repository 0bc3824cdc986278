#include "keyword/transformation.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "keyword/upper_case.hpp"

namespace gapcheck::keyword {
namespace {

/// Reader at the card with the id.
CardReader at_first_card(const Deck& deck, const Block& block, Diagnostics& diagnostics) {
  CardReader reader(deck, block, diagnostics);
  if (block.name.ends_with("_TITLE")) reader.skip();
  return reader;
}

class TransformationRows {
 public:
  TransformationRows(CardReader reader, Diagnostics& diagnostics) : reader_(reader), diagnostics_(diagnostics) {}

  std::optional<Placement> read() {
    reader_.skip();
    const CardLayout& layout = card_layout("DEFINE_TRANSFORMATION", "card2");
    while (!reader_.at_end() && valid_) {
      const Card row = reader_.next(layout);
      const std::string option = upper_case(row.text("option"));
      for (std::size_t i = 0; i < 7; ++i) a_[i] = option.empty() ? 0 : row.real(i + 1);
      line_ = row.line();
      if (!option.empty()) apply(option);
    }
    if (!valid_) return std::nullopt;
    return placement_;
  }

 private:
  void apply(const std::string& option) {
    if (option == "POINT")
      points_[std::llround(a_[0])] = {a_[1], a_[2], a_[3]};
    else if (option == "TRANSL")
      add(Eigen::Matrix3d::Identity(), {a_[0], a_[1], a_[2]});
    else if (option == "TRANSL2ND")
      translate_between_points();
    else if (option == "SCALE")
      scale();
    else if (option == "ROTATE")
      rotate();
    else if (option == "MIRROR")
      mirror();
    else if (option == "MATRIX")
      matrix();
    else if (option == "POS6P")
      position();
    else
      fail("the option " + option +
           " is not supported; use POINT with TRANSL2ND, ROTATE or POS6P, or TRANSL, SCALE, MIRROR or MATRIX");
  }

  void add(const Eigen::Matrix3d& matrix, const Vector& shift) {
    placement_.matrix = matrix * placement_.matrix;
    placement_.shift = matrix * placement_.shift + shift;
    if (!placement_.matrix.allFinite() || !placement_.shift.allFinite())
      fail("the transformation has no finite values");
  }

  void add_around(const Eigen::Matrix3d& matrix, const Vector& center) { add(matrix, center - matrix * center); }

  void fail(const std::string& problem) {
    if (valid_)
      diagnostics_.error(
          reader_.file(), line_,
          "*DEFINE_TRANSFORMATION: " + problem + "; until then what it places stays where its file says");
    valid_ = false;
  }

  const Vector* point(double id, const char* option) {
    const auto found = points_.find(std::llround(id));
    if (found != points_.end()) return &found->second;
    fail(std::string(option) + " refers to " + std::to_string(std::llround(id)) +
         ", which no POINT row of this transformation defines; references to nodes are not supported, use POINT rows");
    return nullptr;
  }

  void translate_between_points() {
    const Vector* from = point(a_[0], "TRANSL2ND");
    const Vector* to = valid_ ? point(a_[1], "TRANSL2ND") : nullptr;
    if (to == nullptr) return;
    const Vector direction = *to - *from;
    if (direction.norm() == 0) return fail("the two points of TRANSL2ND are the same");
    add(Eigen::Matrix3d::Identity(), direction.normalized() * a_[2]);
  }

  void scale() {
    const Vector factors(a_[0] == 0 ? 1 : a_[0], a_[1] == 0 ? 1 : a_[1], a_[2] == 0 ? 1 : a_[2]);
    add(factors.asDiagonal(), Vector::Zero());
  }

  void rotate() {
    Vector axis(a_[0], a_[1], a_[2]), center(a_[3], a_[4], a_[5]);
    double angle = a_[6];
    if (a_[3] == 0 && a_[4] == 0 && a_[5] == 0 && a_[6] == 0) {
      // The short form is two points and an angle; without ids of points it is an axis and no angle.
      if (a_[0] < 1 || a_[1] < 1) return;
      const Vector* from = point(a_[0], "ROTATE");
      const Vector* to = valid_ ? point(a_[1], "ROTATE") : nullptr;
      if (to == nullptr) return;
      axis = *to - *from;
      center = *from;
      angle = a_[2];
    }
    if (axis.norm() == 0) return fail("the axis of ROTATE has no length");
    const Eigen::AngleAxisd rotation(angle * std::numbers::pi / 180, axis.normalized());
    add_around(rotation.toRotationMatrix(), center);
  }

  void mirror() {
    const Vector center(a_[0], a_[1], a_[2]), head(a_[3], a_[4], a_[5]);
    if (head == center) return fail("the normal of MIRROR has no length");
    const Vector normal = (head - center).normalized();
    add_around(Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose(), center);
  }

  /// The axes of three points: along the first two, across in their plane, and normal to it. False: they have none.
  static bool axes_of(const Vector& a, const Vector& b, const Vector& c, Eigen::Matrix3d& axes) {
    const Vector along = b - a, normal = along.cross(c - a);
    if (!(along.norm() > 0) || !(normal.norm() > 0)) return false;
    axes.col(0) = along.normalized();
    axes.col(2) = normal.normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return true;
  }

  /// POS6P: moves the first of three points onto the fourth, turns the line to the second onto that to the fifth, and
  /// the plane of the three onto that of the last three.
  void position() {
    std::array<Vector, 6> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector* found = point(a_[i], "POS6P");
      if (found == nullptr) return;
      points[i] = *found;
    }
    Eigen::Matrix3d from, to;
    if (!axes_of(points[0], points[1], points[2], from) || !axes_of(points[3], points[4], points[5], to))
      return fail("three points of POS6P lie in one line");
    const Eigen::Matrix3d rotation = to * from.transpose();
    add(rotation, points[3] - rotation * points[0]);
  }

  void matrix() {
    std::array<double, 16> m{};
    for (std::size_t card = 0; card < 2; ++card) {
      const Card row = reader_.next(card_layout("DEFINE_TRANSFORMATION", card == 0 ? "card3" : "card4"));
      if (!row.present()) return fail("the two lines behind MATRIX are missing");
      for (std::size_t i = 0; i < 8; ++i) m[card * 8 + i] = row.real(i);
    }
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || (m[15] != 0 && m[15] != 1))
      return fail("the last row of MATRIX must be 0, 0, 0, 1");
    Eigen::Matrix3d linear;
    linear << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    add(linear, {m[3], m[7], m[11]});
  }

  CardReader reader_;
  Diagnostics& diagnostics_;
  std::array<double, 7> a_{};
  std::uint32_t line_ = 0;
  std::map<long long, Vector> points_;
  Placement placement_;
  bool valid_ = true;
};

}  // namespace

std::int64_t transformation_id(const Deck& deck, const Block& block, Diagnostics& diagnostics) {
  return at_first_card(deck, block, diagnostics).next(card_layout("DEFINE_TRANSFORMATION", "card1")).integer("tranid");
}

std::optional<Placement> read_transformation(const Deck& deck, const Block& block, Diagnostics& diagnostics) {
  return TransformationRows(at_first_card(deck, block, diagnostics), diagnostics).read();
}

}  // namespace gapcheck::keyword
