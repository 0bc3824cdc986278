#include "audit/fix/fix.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"
#include "audit/run.hpp"
#include "base/parallel.hpp"
#include "model/model.hpp"

namespace gapcheck::audit_test::fix_test {
namespace {

constexpr double clear = 1.002;  ///< what is moved, in penetrations

std::size_t penetrations(const std::string& text) {
  audit::AuditOptions options;
  options.select = {"GC101", "GC102"};
  const AuditRun run = run_text(text, options);
  EXPECT_TRUE(clean(run));
  return run.report.penetrations.size();
}

TEST(Fix, TwoEqualPlatesShareTheWay) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.7};
  const FixRun run = fix_text(plates_deck(lower, upper));
  EXPECT_TRUE(complete(run.report()));
  EXPECT_EQ(run.report().moved.size(), 32u);
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) {
      EXPECT_NEAR(run.move(upper.node(i, j)).z(), clear * 0.15, 1e-6);
      EXPECT_NEAR(run.move(lower.node(i, j)).z(), -clear * 0.15, 1e-6);
      EXPECT_LT(run.move(lower.node(i, j)).head<2>().norm(), 1e-6);
    }
  EXPECT_NEAR(run.report().total_move, 32 * clear * 0.15, 1e-4);
  EXPECT_NEAR(run.report().largest_move, clear * 0.15, 1e-6);
  EXPECT_EQ(penetrations(run.text), 0u);
}

TEST(Fix, OneLockedTheOtherGoesAllTheWay) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.7};
  audit::FixOptions options;
  options.locks = {{false, 1, 1}};
  const FixRun run = fix_text(plates_deck(lower, upper), options);
  EXPECT_TRUE(complete(run.report()));
  EXPECT_EQ(run.report().moved.size(), 16u);
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) EXPECT_NEAR(run.move(upper.node(i, j)).z(), clear * 0.3, 1e-6);
  EXPECT_EQ(penetrations(run.text), 0u);
}

// Plates that are thin and near to each other need moves that are as exact, compared with their thickness.
TEST(Fix, AsExactForThinPlates) {
  const auto moves = [](double scale) {
    const Plate lower{.id = 1, .thickness = scale},
        upper{.id = 2, .z = 0.7 * scale, .x = 1.3, .y = 2.1, .thickness = scale};
    const FixRun run = fix_text(plates_deck(lower, upper));
    EXPECT_TRUE(complete(run.report()));
    std::vector<double> list;
    for (const Plate& plate : {lower, upper})
      for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 3; ++i) list.push_back(run.move(plate.node(i, j)).z() / scale);
    return list;
  };
  const auto thin = moves(1e-3), thinner = moves(1e-5);
  for (std::size_t i = 0; i < thin.size(); ++i) EXPECT_NEAR(thinner[i], thin[i], 1e-6) << i;
}

/// Two plates of thickness 1; the middle of the upper one is beside its nodes (NLOC), and contact knows it (CNTCO).
std::string with_offset(const Plate& lower, const Plate& upper, const char* nloc) {
  std::string text = plates_deck(lower, upper);
  const std::string thicknesses = fmt::format("{:10}{:10}{:10}{:10}\n", 1.0, 1.0, 1.0, 1.0);
  const std::size_t second = text.find(thicknesses, text.find(thicknesses) + 1);
  text.insert(second + thicknesses.size() - 1, nloc);
  return text.replace(text.find("*END"), 4, "*CONTROL_SHELL\n\n\n         0         0         1\n*END");
}

// Nodes on the lower side of the upper shells, whose middle is half their thickness higher: 0.8 above the lower one's.
TEST(Fix, ShellsBesideTheirNodes) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.3};
  const std::string offset = with_offset(lower, upper, "       -1.");
  EXPECT_EQ(penetrations(offset), 32u);
  const FixRun run = fix_text(offset);
  EXPECT_TRUE(complete(run.report()));
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) EXPECT_NEAR(run.move(upper.node(i, j)).z(), clear * 0.1, 1e-3);
  EXPECT_EQ(penetrations(run.text), 0u);
}

// Nodes on the upper side: the middle of the upper shells is 0.15 below the lower ones, though their nodes are above.
TEST(Fix, ShellsThatLieBelowThoughTheirNodesDoNot) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.35};
  const std::string text = with_offset(lower, upper, "        1.");
  const FixRun run = fix_text(text);
  EXPECT_TRUE(complete(run.report()));
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) {
      EXPECT_NEAR(run.move(upper.node(i, j)).z(), -clear * 0.425, 2e-3);
      EXPECT_NEAR(run.move(lower.node(i, j)).z(), clear * 0.425, 2e-3);
    }
  EXPECT_EQ(penetrations(run.text), 0u);
}

/// Two plates, 0.7 apart, and a third one that nothing touches, in a contact with this IGNORE.
std::string plates_with_ignore(const char* ignore) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.7, .x = 2}, far{.id = 3, .z = 9};
  std::string deck = plates_deck(lower, upper, far);
  return deck.replace(deck.find("*END"), 4, std::string("*CONTROL_CONTACT\n\n\n\n") + ignore + "\n*END");
}

TEST(Fix, AsTheSolverRecommends) {
  audit::FixOptions options;
  options.recommended = true;
  const FixRun run = fix_text(plates_with_ignore("         2"), options);
  EXPECT_TRUE(complete(run.report()));
  const Plate lower{.id = 1}, upper{.id = 2};
  // The plates overlap where 2 <= x <= 15: three columns of nodes of each.
  EXPECT_EQ(run.report().moved.size(), 24U);
  for (int j = 0; j <= 3; ++j) {
    for (int i = 0; i < 3; ++i) EXPECT_LT((run.move(upper.node(i, j)) - Vector(0, 0, clear * 0.3)).norm(), 1e-6);
    for (int i = 1; i <= 3; ++i) EXPECT_LT((run.move(lower.node(i, j)) - Vector(0, 0, -clear * 0.3)).norm(), 1e-6);
    EXPECT_EQ(run.moved(lower.node(0, j)), nullptr);
  }
  EXPECT_EQ(penetrations(run.text), 0U);
}

TEST(Fix, RecommendsNothingWithoutIgnore2) {
  audit::FixOptions options;
  options.recommended = true;
  const FixRun run = fix_text(plates_with_ignore("         1"), options);
  EXPECT_TRUE(run.report().moved.empty());
  EXPECT_EQ(run.report().unfixed.size(), 24U);
}

TEST(Fix, RecommendedNodesThatAreHeldStay) {
  audit::FixOptions options;
  options.recommended = true;
  options.locks = {{false, 1, 1}};
  const FixRun run = fix_text(plates_with_ignore("         2"), options);
  EXPECT_EQ(run.report().moved.size(), 12U);
  // Above x = 15 the upper plate rises towards its edge, which nothing was below: the others have left the lower one.
  ASSERT_EQ(run.report().unfixed.size(), 4U);
  for (const UnfixedNode& node : run.report().unfixed) EXPECT_EQ((node.node - 1001) % 4, 3) << node.node;
}

TEST(Fix, PriorityHoldsAPartBack) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.7};
  audit::FixOptions options;
  options.priorities = {{1, 3.0}};
  const FixRun run = fix_text(plates_deck(lower, upper), options);
  EXPECT_NEAR(run.move(lower.node(1, 1)).z(), -clear * 0.075, 1e-6);
  EXPECT_NEAR(run.move(upper.node(1, 1)).z(), clear * 0.225, 1e-6);
  EXPECT_EQ(penetrations(run.text), 0u);
}

TEST(Fix, SeveralPlatesSpreadOut) {
  const Plate a{.id = 1}, b{.id = 2, .z = 0.8}, c{.id = 3, .z = 1.6};
  const FixRun run = fix_text(plates_deck(a, b, c));
  EXPECT_TRUE(complete(run.report()));
  EXPECT_NEAR(run.move(a.node(1, 1)).z(), -clear * 0.2, 1e-5);
  EXPECT_NEAR(run.move(b.node(1, 1)).z(), 0, 1e-5);
  EXPECT_NEAR(run.move(c.node(1, 1)).z(), clear * 0.2, 1e-5);
  EXPECT_EQ(penetrations(run.text), 0u);
}

TEST(Fix, NothingToDoChangesNothing) {
  const FixRun run = fix_text(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 1.5}));
  EXPECT_TRUE(complete(run.report()));
  EXPECT_TRUE(run.report().moved.empty());
  EXPECT_TRUE(run.fix.files.empty());
}

TEST(Fix, ThreadsChangeNothing) {
  const std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7, .x = 1.3, .y = 2.1});
  std::string one;
  {
    const JobLimit limit(1);
    one = fix_text(text).text;
  }
  EXPECT_EQ(one, fix_text(text).text);
}

TEST(Fix, BoundaryConditionsHoldTheirDirections) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.7};
  const std::string spc = "*BOUNDARY_SPC_NODE\n" + [&] {
    std::string rows;
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 3; ++i)
        rows += fmt::format("{:10}         0         0         0         1\n", lower.node(i, j));
    return rows;
  }();
  const FixRun run =
      fix_text("*KEYWORD\n" + elastic_steel + lower.deck() + upper.deck() + single_surface + spc + "*END\n");
  EXPECT_TRUE(complete(run.report()));
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) {
      EXPECT_EQ(run.move(lower.node(i, j)).z(), 0);
      EXPECT_NEAR(run.move(upper.node(i, j)).z(), clear * 0.3, 1e-6);
    }
}

std::vector<std::filesystem::path> decks() {
  std::vector<std::filesystem::path> list;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(GAPCHECK_ROOT) / "data"))
    if (entry.path().extension() == ".k") list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Fix, DecksOfTheProjectAreFreeAfterwards) {
  std::size_t corrected = 0;
  for (const auto& path : decks()) {
    const FixRun run = fix_file(path.string());
    EXPECT_EQ(run.errors, 0u) << path;
    if (!run.report().moved.empty()) ++corrected;
    if (path.stem() == "include_parameter") continue;  // its main file has no nodes: the tests of the program have it
    EXPECT_TRUE(complete(run.report())) << path;
    audit::AuditOptions options;
    options.select = {"GC101", "GC102", "GC107", "GC108", "GC109", "GC110"};
    const AuditRun after = run_text(run.text, options);
    EXPECT_TRUE(clean(after)) << path;
    EXPECT_TRUE(after.report.penetrations.empty()) << path;
    EXPECT_LE(run.report().crossings_after, run.report().crossings_before) << path;
    expect_only_listed_lines(content(path), run);
  }
  EXPECT_GT(corrected, 25u);
}

/// The least Σ w z² with A z >= b, by trying sets of active rows until the conditions of Karush, Kuhn and Tucker hold.
Eigen::VectorXd plane_optimum(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weight) {
  const Eigen::MatrixXd q = a * weight.cwiseInverse().asDiagonal() * a.transpose();
  std::set<int> active;
  Eigen::VectorXd lambda = Eigen::VectorXd::Zero(b.size());
  for (int step = 0; step < 10000; ++step) {
    const std::vector<int> rows(active.begin(), active.end());
    lambda.setZero();
    if (!rows.empty()) {
      const Eigen::MatrixXd part = q(rows, rows);
      const Eigen::VectorXd right = b(rows);
      const Eigen::VectorXd solution = part.completeOrthogonalDecomposition().solve(right);
      lambda(rows) = solution;
    }
    int worst = -1;
    for (const int r : rows)
      if (lambda[r] < -1e-10 && (worst < 0 || lambda[r] < lambda[worst])) worst = r;
    if (worst >= 0) {
      active.erase(worst);
      continue;
    }
    Eigen::Index most = 0;
    if ((b - q * lambda).maxCoeff(&most) < 1e-9) break;
    active.insert(static_cast<int>(most));
  }
  EXPECT_GE(lambda.minCoeff(), -1e-9);
  EXPECT_LT((b - q * lambda).maxCoeff(), 1e-8);
  return weight.cwiseInverse().asDiagonal() * (a.transpose() * lambda);
}

/// Sum of the moves of the optimum for two parallel plates of rectangles, at right angles to z, with penetration p.
double plane_total(const std::filesystem::path& path, double p) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck(path.string(), {}, diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  const model::Mesh& mesh = model.value().mesh;
  const auto count = static_cast<Eigen::Index>(mesh.nodes.size());
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(count);
  std::vector<PartIndex> part(mesh.nodes.size());
  std::vector<Eigen::VectorXd> rows;
  for (std::size_t e = 0; e < mesh.shells.size(); ++e)
    for (const NodeIndex n : mesh.shells.nodes[e]) {
      weight[n.value] += 25.0 / 4;
      part[n.value] = mesh.shells.part[e];
    }
  for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i)
    for (std::size_t e = 0; e < mesh.shells.size(); ++e) {
      const auto& n = mesh.shells.nodes[e];
      Vector low = mesh.nodes.x[n[0].value], high = low;
      for (const NodeIndex k : n) {
        low = low.cwiseMin(mesh.nodes.x[k.value]);
        high = high.cwiseMax(mesh.nodes.x[k.value]);
      }
      const Vector& x = mesh.nodes.x[i];
      if (part[i] == mesh.shells.part[e] || x.x() < low.x() || x.x() > high.x() || x.y() < low.y() || x.y() > high.y())
        continue;
      Eigen::VectorXd row = Eigen::VectorXd::Zero(count);
      const double side = x.z() > low.z() ? 1 : -1;
      row[i] += side;
      for (const NodeIndex k : n) {
        const Vector& c = mesh.nodes.x[k.value];
        row[k.value] -= side * (1 - std::abs(c.x() - x.x()) / (high.x() - low.x())) *
                        (1 - std::abs(c.y() - x.y()) / (high.y() - low.y()));
      }
      rows.push_back(row);
    }
  Eigen::MatrixXd a(static_cast<Eigen::Index>(rows.size()), count);
  for (std::size_t r = 0; r < rows.size(); ++r) a.row(static_cast<Eigen::Index>(r)) = rows[r].transpose();
  return plane_optimum(a, Eigen::VectorXd::Constant(a.rows(), p), weight).cwiseAbs().sum();
}

TEST(Fix, MovesNoMoreThanTheOptimumOfParallelPlates) {
  const std::vector<std::pair<std::string, double>> plates{
      {"two_plates", 0.3},        {"ignore_0", 0.3},       {"ignore_1", 0.3},           {"ignore_2", 0.3},
      {"ignore_mpp", 0.3},        {"snlog_1", 0.3},        {"two_way_order", 0.3},      {"thickness_sst", 0.5},
      {"thickness_th", 0.5},      {"thickness_sfst", 0.3}, {"thickness_shlthk_1", 0.3}, {"thickness_ssthk_1", 0.3},
      {"element_thickness", 0.1}, {"stray_part", 0.3}};
  for (const auto& [name, p] : plates) {
    const auto path = std::filesystem::path(GAPCHECK_ROOT) / "data" / (name + ".k");
    const double optimum = plane_total(path, p), total = fix_file(path.string()).report().total_move;
    EXPECT_LT(std::abs(total / optimum - 1), 0.05) << name << ": " << total << " against " << optimum;
    RecordProperty(name, fmt::format("{:.4f}", total / optimum));
  }
}

}  // namespace
}  // namespace gapcheck::audit_test::fix_test
