#include "keyword/transformation.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "keyword/upper_case.hpp"

namespace gapcheck::keyword {
namespace {

/// Reader at the card with the id.
CardReader at_first_card(const Deck& deck, const Block& block, Diagnostics& diagnostics) {
  CardReader reader(deck, block, diagnostics);
  if (block.name.ends_with("_TITLE")) reader.skip();
  return reader;
}

/// A field with an id; 0: it has none.
std::int64_t id_in(double field) {
  constexpr double largest = 1e15;
  return std::abs(field) <= largest && field == std::floor(field) ? std::llround(field) : 0;
}

/// How many fields of a row are ids of nodes.
std::size_t node_fields(const std::string& option) {
  return option == "TRANSL2ND" ? 2 : option == "ROTATE3NA" ? 3 : option == "POS6N" ? 6 : 0;
}

/// The id of a node in a field of a block.
std::int64_t node_in(const Deck& deck, const Block& block, double field) {
  const std::int64_t id = id_in(field);
  std::int64_t shifted = 0;
  const std::int64_t offset = deck.transform(block.transform).offset[static_cast<std::size_t>(IdKind::node)];
  return id == 0 || __builtin_add_overflow(id, offset, &shifted) ? 0 : shifted;
}

class TransformationRows {
 public:
  TransformationRows(CardReader reader, const Deck& deck, const NodePosition& node, Diagnostics& diagnostics)
      : reader_(reader), deck_(deck), node_(node), diagnostics_(diagnostics) {}

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
      points_[id_in(a_[0])] = {a_[1], a_[2], a_[3]};
    else if (option == "TRANSL")
      add(Eigen::Matrix3d::Identity(), {a_[0], a_[1], a_[2]});
    else if (option == "TRANSL2ND")
      translate_between_nodes();
    else if (option == "SCALE")
      scale();
    else if (option == "ROTATE")
      rotate();
    else if (option == "ROTATE3NA")
      rotate_about_nodes();
    else if (option == "MIRROR")
      mirror();
    else if (option == "MATRIX")
      matrix();
    else if (option == "POS6P" || option == "POS6N")
      position(option);
    else
      fail("the option " + option +
           " is not supported; use TRANSL, TRANSL2ND, SCALE, ROTATE, ROTATE3NA, MIRROR, MATRIX, POS6P, POS6N or POINT");
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

  void warn(const std::string& text) { diagnostics_.warning(reader_.file(), line_, "*DEFINE_TRANSFORMATION: " + text); }

  [[nodiscard]] bool moves_nothing() const {
    return placement_.matrix == Eigen::Matrix3d::Identity() && placement_.shift == Vector::Zero();
  }

  /// A POINT row, moved by all rows so far: its place among them does not matter.
  std::optional<Vector> point(double field, const std::string& option) {
    const auto found = points_.find(id_in(field));
    if (found != points_.end()) return placement_.matrix * found->second + placement_.shift;
    fail(option + " refers to point " + std::to_string(id_in(field)) +
         ", which no POINT row before it in this transformation defines" +
         (option == "ROTATE"  ? "; ROTATE3NA takes nodes"
          : option == "POS6P" ? "; POS6N takes nodes"
                              : ""));
    return std::nullopt;
  }

  /// A node, where the deck defines it.
  std::optional<Vector> node(double field, const std::string& option) {
    const std::int64_t id = node_in(deck_, reader_.block(), field);
    if (id <= 0) {
      fail(option + " needs the ids of " + std::to_string(node_fields(option)) + " nodes");
      return std::nullopt;
    }
    auto found = node_(id);
    if (!found) {
      fail(option + ": " + found.error().message);
      return std::nullopt;
    }
    return std::move(found).value();
  }

  void translate_between_nodes() {
    // Two POINT rows are not what the manual has here, but leave no doubt where there are no such nodes.
    const bool points = points_.contains(id_in(a_[0])) && points_.contains(id_in(a_[1])) &&
                        !node_(node_in(deck_, reader_.block(), a_[0])).ok();
    if (points) warn("TRANSL2ND takes nodes; as there are none with these ids, the POINT rows are taken");
    const auto end = [&](double field) { return points ? point(field, "TRANSL2ND") : node(field, "TRANSL2ND"); };
    const std::optional<Vector> from = end(a_[0]), to = valid_ ? end(a_[1]) : std::nullopt;
    if (!to) return;
    const Vector direction = *to - *from;
    if (direction.norm() == 0) return fail("the two nodes of TRANSL2ND lie at one place");
    if (a_[2] == 0)
      warn("TRANSL2ND without a distance moves by that of its nodes, as newer releases of the solver do; give it");
    add(Eigen::Matrix3d::Identity(), a_[2] == 0 ? direction : direction.normalized() * a_[2]);
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
      const std::optional<Vector> from = point(a_[0], "ROTATE"), to = valid_ ? point(a_[1], "ROTATE") : std::nullopt;
      if (!to) return;
      axis = *to - *from;
      center = *from;
      angle = a_[2];
    }
    turn(axis, center, angle, "ROTATE");
  }

  /// ROTATE3NA: an axis along two nodes through a third one.
  void rotate_about_nodes() {
    std::array<Vector, 3> nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::optional<Vector> found = node(a_[i], "ROTATE3NA");
      if (!found) return;
      nodes[i] = *found;
    }
    turn(nodes[1] - nodes[0], nodes[2], a_[3], "ROTATE3NA");
  }

  void turn(const Vector& axis, const Vector& center, double degrees, const std::string& option) {
    if (axis.norm() == 0) return fail("the axis of " + option + " has no length");
    const Eigen::AngleAxisd rotation(degrees * std::numbers::pi / 180, axis.normalized());
    add_around(rotation.toRotationMatrix(), center);
  }

  void mirror() {
    const Vector center(a_[0], a_[1], a_[2]), head(a_[3], a_[4], a_[5]);
    if (head == center) return fail("the normal of MIRROR has no length");
    const Vector normal = (head - center).normalized();
    add_around(Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose(), center);
  }

  /// The axes of three points: along the first two, across in their plane, and normal to it. False: they have none,
  /// but for rounding.
  static bool axes_of(const Vector& a, const Vector& b, const Vector& c, Eigen::Matrix3d& axes) {
    constexpr double least_sine = 1e-9;
    const Vector along = b - a, other = c - a, normal = along.cross(other);
    if (!(along.norm() > 0) || !(normal.norm() > least_sine * along.norm() * other.norm())) return false;
    axes.col(0) = along.normalized();
    axes.col(2) = normal.normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return true;
  }

  /// POS6P, POS6N: moves the first of three points or nodes onto the fourth, turns the line to the second onto that to
  /// the fifth, and the plane of the three onto that of the last three.
  void position(const std::string& option) {
    const bool of_nodes = option == "POS6N";
    if (std::exchange(positioned_[of_nodes ? 1 : 0], true))
      return fail("it has a second row " + option + "; the solver permits one");
    if (!of_nodes && !moves_nothing()) warn("POS6P has rows before it, which move its six points too");
    std::array<Vector, 6> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::optional<Vector> found = of_nodes ? node(a_[i], option) : point(a_[i], option);
      if (!found) return;
      points[i] = *found;
    }
    Eigen::Matrix3d from, to;
    if (!axes_of(points[0], points[1], points[2], from) || !axes_of(points[3], points[4], points[5], to))
      return fail("three " + std::string(of_nodes ? "nodes" : "points") + " of " + option + " lie in one line");
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
  const Deck& deck_;
  const NodePosition& node_;
  Diagnostics& diagnostics_;
  std::array<double, 7> a_{};
  std::uint32_t line_ = 0;
  std::map<long long, Vector> points_;
  Placement placement_;
  std::array<bool, 2> positioned_{};  ///< by POS6P, by POS6N
  bool valid_ = true;
};

}  // namespace

bool is_transformation(std::string_view keyword) {
  for (const std::string_view name : {"DEFINE_TRANSFORMATION", "DEFINE_TRANSFORM"})
    if (keyword == name || (keyword.starts_with(name) && keyword.substr(name.size()) == "_TITLE")) return true;
  return false;
}

std::int64_t transformation_id(const Deck& deck, const Block& block, Diagnostics& diagnostics) {
  return at_first_card(deck, block, diagnostics).next(card_layout("DEFINE_TRANSFORMATION", "card1")).integer("tranid");
}

std::vector<std::int64_t> transformation_nodes(const Deck& deck, const Block& block) {
  std::vector<std::int64_t> ids;
  Diagnostics unused;
  CardReader reader = at_first_card(deck, block, unused);
  reader.skip();
  while (!reader.at_end()) {
    const Card row = reader.next(card_layout("DEFINE_TRANSFORMATION", "card2"));
    const std::size_t fields = node_fields(upper_case(row.text("option")));
    for (std::size_t i = 0; i < fields; ++i)
      if (const std::int64_t id = node_in(deck, block, row.real(i + 1)); id > 0) ids.push_back(id);
  }
  return ids;
}

std::optional<Placement> read_transformation(const Deck& deck, const Block& block, const NodePosition& node,
                                             Diagnostics& diagnostics) {
  return TransformationRows(at_first_card(deck, block, diagnostics), deck, node, diagnostics).read();
}

}  // namespace gapcheck::keyword
