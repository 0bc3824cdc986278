// The movement of a correction against the optimum of a quadratic program that is set up and solved in another way: all
// pairs of nodes and segments that are near each other afterwards, and block principal pivoting instead of sweeps.
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "audit/fix/element_bounds.hpp"
#include "audit/fix/freedoms.hpp"
#include "audit/fix/run_fix.hpp"
#include "audit/untangle/crossing_pairs.hpp"
#include "base/quad.hpp"
#include "contact/initial.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "geometry/closest_point.hpp"

namespace gapcheck::audit_test::optimum_test {
namespace {

const std::string folder = std::string(GAPCHECK_ROOT) + "/data/fix/";

/// direction . (u of the node - sum of share u of the corners) >= bound.
struct Row {
  NodeIndex node;
  model::SegmentNodes corners{};
  std::array<double, 4> share{};
  Vector direction = Vector::Zero();
  double bound = 0;
};

/// The way out of a solid's face: away from the middle of its element.
Vector outward(const model::Mesh& mesh, std::uint32_t solid, const Vector& point, const Vector& normal,
               const std::vector<Vector>& x) {
  Vector middle = Vector::Zero();
  for (const NodeIndex n : mesh.solids.nodes[solid]) middle += x[n.value] / 8;
  return normal.dot(point - middle) < 0 ? Vector(-normal) : normal;
}

/// What keeps the corrected model's nodes out of each segment of another part that is near.
void add_rows(const model::Model& model, const std::vector<Vector>& before, const contact::ContactSide& tracked,
              const contact::ContactSide& reference, std::vector<Row>& rows) {
  const model::Mesh& mesh = model.mesh;
  const std::vector<Vector>& x = mesh.nodes.x;
  const contact::Segments& segments = reference.selection.segments;
  std::vector<PartIndex> part_of(x.size(), none<PartIndex>);
  for (std::size_t e = 0; e < mesh.shells.size(); ++e)
    for (const NodeIndex n : mesh.shells.nodes[e]) part_of[n.value] = mesh.shells.part[e];
  for (std::size_t e = 0; e < mesh.solids.size(); ++e)
    for (const NodeIndex n : mesh.solids.nodes[e]) part_of[n.value] = mesh.solids.part[e];
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto& c = segments.nodes[s];
    const PartIndex own = contact::part_of(mesh, segments, s);
    for (std::size_t slot = 0; slot < tracked.nodes.size(); ++slot) {
      const NodeIndex node = tracked.nodes.node[slot];
      if (part_of[node.value] == own) continue;
      const geometry::Facet facet{{x[c[0].value], x[c[1].value], x[c[2].value], x[c[3].value]}, c[2] == c[3]};
      const auto closest = geometry::closest_point(facet, x[node.value]);
      const double h = tracked.nodes.half[slot] + segments.half[s];
      const Vector away = x[node.value] - closest.point;
      const double distance = away.norm(), near = h > 0 ? 1.2 * h : 0.2;
      if (!closest.in_band || distance > near) continue;
      Row row{node, c, quad_weights(closest.s, closest.t), {}, h};
      row.direction =
          h > 0 ? Vector(away / distance) : outward(mesh, segments.element[s], closest.point, closest.normal, x);
      row.bound -= row.direction.dot(before[node.value]);
      for (std::size_t i = 0; i < 4; ++i) row.bound += row.share[i] * row.direction.dot(before[c[i].value]);
      rows.push_back(row);
    }
  }
}

/// Multipliers >= 0 with slack K m - b >= 0 and m . slack = 0.
Eigen::VectorXd complementary(const Eigen::MatrixXd& k, const Eigen::VectorXd& b) {
  const Eigen::Index n = b.size();
  std::vector<std::uint8_t> active(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) active[static_cast<std::size_t>(i)] = b[i] > 0;
  Eigen::VectorXd m = Eigen::VectorXd::Zero(n);
  Eigen::Index fewest = n + 1;
  int patience = 3;
  for (int round = 0; round < 1000; ++round) {
    std::vector<Eigen::Index> on;
    for (Eigen::Index i = 0; i < n; ++i)
      if (active[static_cast<std::size_t>(i)] != 0) on.push_back(i);
    m.setZero();
    const Eigen::MatrixXd k_on = k(on, on);
    const Eigen::VectorXd b_on = b(on), m_on = k_on.ldlt().solve(b_on);
    m(on) = m_on;
    const Eigen::VectorXd slack = k * m - b;
    const double small = 1e-9 * b.cwiseAbs().maxCoeff();
    std::vector<Eigen::Index> wrong;
    for (Eigen::Index i = 0; i < n; ++i)
      if (active[static_cast<std::size_t>(i)] != 0 ? m[i] < 0 : slack[i] < -small) wrong.push_back(i);
    if (wrong.empty()) return m;
    const auto count = static_cast<Eigen::Index>(wrong.size());
    if (count < fewest) {
      fewest = count;
      patience = 3;
    } else if (patience-- <= 0) {
      wrong = {wrong.back()};  // Murty's rule ends
    }
    for (const Eigen::Index i : wrong) active[static_cast<std::size_t>(i)] ^= 1;
  }
  ADD_FAILURE() << "the quadratic program is not solved";
  return m;
}

struct Movement {
  double largest = 0, weighted = 0;
  std::vector<Vector> moves;
};

Movement optimum(const std::vector<Row>& rows, const std::vector<Vector>& mobility) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(3 * mobility.size()));
  Eigen::VectorXd b(n), free(a.cols());
  for (std::size_t i = 0; i < mobility.size(); ++i) free.segment<3>(static_cast<Eigen::Index>(3 * i)) = mobility[i];
  for (Eigen::Index r = 0; r < n; ++r) {
    const Row& row = rows[static_cast<std::size_t>(r)];
    const auto add = [&](NodeIndex node, double share) {
      a.row(r).segment<3>(3 * static_cast<Eigen::Index>(node.value)) += share * row.direction.transpose();
    };
    add(row.node, 1);
    for (std::size_t i = 0; i < 4; ++i) add(row.corners[i], -row.share[i]);
    b[r] = row.bound;
  }
  Eigen::MatrixXd k = a * free.asDiagonal() * a.transpose();
  k.diagonal().array() += 1e-10 * k.diagonal().maxCoeff();  // conditions that say the same twice
  const Eigen::VectorXd m = complementary(k, b);
  const Eigen::VectorXd u = free.cwiseProduct(a.transpose() * m);
  Movement movement;
  for (Eigen::Index i = 0; i < u.size(); i += 3) {
    movement.moves.emplace_back(u.segment<3>(i));
    movement.largest = std::max(movement.largest, movement.moves.back().norm());
  }
  movement.weighted = m.dot(k * m);
  return movement;
}

/// Whether the moves, taken a little farther, free the nodes, part the elements and keep their shape: the program knows
/// neither edges nor shapes, nor how far its linear gaps hold.
bool is_solution(model::Model model, const std::vector<Vector>& moves) {
  const std::vector<Vector> deck = model.mesh.nodes.x;
  audit::ElementBounds bounds(model, deck, {});
  std::vector<NodeIndex> moved;
  for (std::uint32_t n = 0; n < moves.size(); ++n) {
    if (moves[n].isZero()) continue;
    model.mesh.nodes.x[n] += 1.01 * moves[n];
    moved.emplace_back(n);
  }
  if (!bounds.broken(model.mesh.nodes.x, moved).empty()) return false;
  contact::SurfaceStore surfaces(model);
  contact::InitialOptions options;
  options.nodes_stay = true;
  contact::InitialCounters counters;
  return contact::initialise_contacts(model, surfaces, options, counters).penetrations.empty() &&
         audit::crossing_pairs(model).empty();
}

/// Where `exists` is false, the optimum of nodes and segments alone would cross edges or spoil the shape of elements.
struct OptimumScene {
  const char* name;
  bool exists = true;
};

class FixOptimum : public testing::TestWithParam<OptimumScene> {};

TEST_P(FixOptimum, IsReached) {
  const std::string path = folder + GetParam().name + ".k";
  const FixRun run = fix_file(path);
  ASSERT_TRUE(complete(run.report()));
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck(path, {}, diagnostics);
  const model::Model before = model::read_model(deck.value(), diagnostics).value(), after = model_of(run.text);
  contact::SurfaceStore surfaces(after);
  const contact::ContactSurfaces& sides = surfaces.at(ContactIndex{0});
  std::vector<Row> rows;
  add_rows(after, before.mesh.nodes.x, sides.a, sides.two_sided() ? sides.b : sides.a, rows);
  if (sides.type.treatment == contact::Treatment::two_way) add_rows(after, before.mesh.nodes.x, sides.b, sides.a, rows);
  ASSERT_GT(rows.size(), 1u);
  const std::vector<Vector> mobility = audit::find_freedoms(before, {}, {}).mobility;
  const Movement best = optimum(rows, mobility);
  double weighted = 0;
  for (std::size_t n = 0; n < mobility.size(); ++n) {
    const Vector u = after.mesh.nodes.x[n] - before.mesh.nodes.x[n];
    for (int axis = 0; axis < 3; ++axis)
      if (u[axis] != 0) weighted += u[axis] * u[axis] / mobility[n][axis];
  }
  RecordProperty("rows", std::to_string(rows.size()));
  RecordProperty("largest", fmt::format("{:.4g} of {:.4g}", run.report().largest_move, best.largest));
  RecordProperty("weighted", fmt::format("{:.4g} of {:.4g}", weighted, best.weighted));
  EXPECT_GT(weighted, 0.98 * best.weighted);  // it cannot be less, but for what the deck's digits round off
  ASSERT_EQ(is_solution(before, best.moves), GetParam().exists);
  if (!GetParam().exists) return;
  EXPECT_LT(weighted, 1.05 * best.weighted);
  EXPECT_LT(run.report().largest_move, 1.05 * best.largest);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FixOptimum,
                         testing::Values(OptimumScene{"plates"}, OptimumScene{"sandwich"}, OptimumScene{"t_joint"},
                                         OptimumScene{"press_fit"}, OptimumScene{"foam"}, OptimumScene{"bolt"},
                                         OptimumScene{"dome"}, OptimumScene{"crossed_05"}, OptimumScene{"crossed_15"},
                                         OptimumScene{"crossed_30"}, OptimumScene{"crossed_45"},
                                         OptimumScene{"one_way"}, OptimumScene{"three_sheets"},
                                         OptimumScene{"block_in_block", false}, OptimumScene{"gears", false},
                                         OptimumScene{"block_in_sheet", false}, OptimumScene{"corner", false},
                                         OptimumScene{"crossed_60", false}, OptimumScene{"crossed_90", false},
                                         OptimumScene{"crossed_aside", false}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace gapcheck::audit_test::optimum_test
