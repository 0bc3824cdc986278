#include "audit/mesh/scene_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "audit/run.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::audit::scene_mesh_test {
namespace {

constexpr const char* data = GAPCHECK_ROOT "/data/";

/// A model and what the audit finds in it.
struct Subject {
  model::Model model;
  Report report;
};

Subject read(const std::string& name) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck(data + name, {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  return {std::move(model).value(), audit_test::run_file(data + name).report};
}

/// A flat sheet of n by n squares of length 1 in the plane z.
struct Sheet {
  std::vector<SceneFace> faces;
  std::vector<Vector> x;
  void add(std::uint32_t n, double z, std::uint32_t part) {
    const auto first = static_cast<std::uint32_t>(x.size());
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t i = 0; i <= n; ++i) x.emplace_back(i, j, z);
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + j * (n + 1) + i;
        faces.push_back({{a, a + 1, a + n + 2, a + n + 1}, PartIndex(part)});
      }
  }
  [[nodiscard]] SceneMesh outline(std::size_t limit = 1'000'000) const {
    SceneMesh scene;
    add_outline(faces, x, scene_frame(x), limit, scene);
    return scene;
  }
};

void expect_sound(const SceneMesh& scene) {
  std::uint32_t faces = 0;
  std::set<std::uint32_t> of_earlier_parts;
  for (const SceneMesh::Part& part : scene.parts) {
    EXPECT_EQ(part.first_face, faces);
    faces += part.faces;
    std::set<std::uint32_t> own;
    for (std::uint32_t f = part.first_face; f < faces; ++f)
      for (const std::uint32_t point : scene.faces[f]) {
        ASSERT_LT(point, scene.points.size());
        EXPECT_FALSE(of_earlier_parts.contains(point)) << "two parts share a point";
        own.insert(point);
      }
    of_earlier_parts.merge(own);
  }
  EXPECT_EQ(faces, scene.faces.size());
  for (const auto& edge : scene.outline)
    for (const std::uint32_t point : edge) EXPECT_LT(point, scene.outline_points.size());
  for (const auto& list : {scene.points, scene.outline_points})
    for (const SceneMesh::Point& point : list)
      for (const float value : point) EXPECT_TRUE(std::isfinite(value));
}

TEST(SceneMesh, HoldsBothSidesOfAPenetration) {
  const Subject subject = read("two_plates.k");
  ASSERT_FALSE(subject.report.penetrations.empty());
  const SceneMesh scene = scene_mesh(subject.model, subject.report);
  expect_sound(scene);
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[0].title, "lower plate");
  EXPECT_EQ(scene.model_faces, subject.model.mesh.shells.size());
  EXPECT_FALSE(scene.faces_cut);
  const auto near = [&](const Vector& x) {
    return std::any_of(scene.points.begin(), scene.points.end(), [&](const SceneMesh::Point& point) {
      return (Vector(point[0], point[1], point[2]) + scene.origin - x).norm() < 1e-4;
    });
  };
  for (const Penetration& record : subject.report.penetrations) {
    EXPECT_TRUE(near(record.original)) << record.node;
    for (const std::int64_t node : record.segment)
      EXPECT_TRUE(near(subject.model.mesh.nodes.x[*subject.model.mesh.nodes.lookup.find(node)])) << node;
  }
}

TEST(SceneMesh, IsAskedForByAnOption) {
  EXPECT_FALSE(audit_test::run_file(std::string(data) + "two_plates.k").report.scene);
  AuditOptions options;
  options.scene = true;
  EXPECT_TRUE(audit_test::run_file(std::string(data) + "two_plates.k", options).report.scene);
}

TEST(SceneMesh, RingsGrowUntilTheLimit) {
  Subject subject = read("two_plates.k");
  // One of the last nodes, so that the first face is not among the first that are reached.
  auto& records = subject.report.penetrations;
  const auto by_node = [](const Penetration& a, const Penetration& b) { return a.node < b.node; };
  records = {*std::max_element(records.begin(), records.end(), by_node)};
  subject.report.findings.clear();
  const auto faces = [&](std::uint32_t rings, std::size_t limit) {
    SceneLimits limits;
    limits.rings = rings;
    limits.faces = limit;
    limits.whole = 0;
    const SceneMesh scene = scene_mesh(subject.model, subject.report, limits);
    expect_sound(scene);
    return std::pair(scene.faces.size(), scene.faces_cut);
  };
  EXPECT_EQ(faces(0, 100), (std::pair<std::size_t, bool>(0, false)));
  // The slow twin: shells at the nodes, then those at the nodes of these.
  const model::Mesh& mesh = subject.model.mesh;
  const Penetration& record = subject.report.penetrations[0];
  std::set<std::uint32_t> nodes{*mesh.nodes.lookup.find(record.node)};
  for (const std::int64_t node : record.segment) nodes.insert(*mesh.nodes.lookup.find(node));
  for (std::uint32_t rings = 1; rings <= 3; ++rings) {
    std::set<std::uint32_t> grown = nodes;
    std::size_t count = 0;
    for (const auto& shell : mesh.shells.nodes) {
      if (std::none_of(shell.begin(), shell.end(), [&](NodeIndex n) { return nodes.contains(n.value); })) continue;
      ++count;
      for (const NodeIndex n : shell) grown.insert(n.value);
    }
    EXPECT_EQ(faces(rings, 100), (std::pair<std::size_t, bool>(count, false))) << rings;
    nodes = grown;
  }
  EXPECT_EQ(faces(2, 5), (std::pair<std::size_t, bool>(5, true)));
}

TEST(SceneMesh, ASmallMeshIsThereAsAWhole) {
  const Subject subject = read("two_plates.k");
  const SceneMesh scene = scene_mesh(subject.model, Report{});
  expect_sound(scene);
  EXPECT_EQ(scene.faces.size(), subject.model.mesh.shells.size()) << "although nothing is found";
  SceneLimits limits;
  limits.whole = scene.faces.size() - 1;
  EXPECT_TRUE(scene_mesh(subject.model, Report{}, limits).faces.empty());
}

TEST(SceneMesh, FacesKnowTheirElementsNodesAndContactThickness) {
  const Subject subject = read("two_plates.k");
  AuditOptions options;
  options.scene = true;
  const SceneMesh scene = *audit_test::run_file(std::string(data) + "two_plates.k", options).report.scene;
  expect_sound(scene);
  const model::Shells& shells = subject.model.mesh.shells;
  ASSERT_EQ(scene.faces.size(), shells.size());
  ASSERT_EQ(scene.point_nodes.size(), scene.points.size());
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    const auto shell = shells.lookup.find(scene.face_elements[f]);
    ASSERT_TRUE(shell);
    for (std::size_t corner = 0; corner < 4; ++corner)
      EXPECT_EQ(scene.point_nodes[scene.faces[f][corner]],
                subject.model.mesh.nodes.id[shells.nodes[*shell][corner].value]);
    EXPECT_FLOAT_EQ(scene.face_thickness[f], 1);
  }
}

TEST(SceneMesh, ParticlesAndThickShellsAreDrawn) {
  Subject subject = read("solid_on_solid.k");
  model::Mesh& mesh = subject.model.mesh;
  std::swap(mesh.thick_shells, mesh.solids);
  mesh.particles.id = {7, 8};
  mesh.particles.nodes = {{NodeIndex(0)}, {NodeIndex(3)}};
  mesh.particles.part = {PartIndex(0), PartIndex(1)};
  const SceneMesh scene = scene_mesh(subject.model, Report{});
  expect_sound(scene);
  EXPECT_EQ(scene.faces.size(), scene.model_faces);
  EXPECT_GT(scene.faces.size(), 2u) << "outer faces of thick shells";
  const auto particles = std::count_if(scene.faces.begin(), scene.faces.end(), [](const auto& face) {
    return face[0] == face[1] && face[1] == face[2] && face[2] == face[3];
  });
  EXPECT_EQ(particles, 2);
}

TEST(SceneMesh, SolidsShowTheirOuterFaces) {
  const Subject subject = read("solid_on_solid.k");
  const SceneMesh scene = scene_mesh(subject.model, subject.report);
  expect_sound(scene);
  EXPECT_GT(scene.faces.size(), 0u);
  EXPECT_LT(scene.model_faces, 6 * subject.model.mesh.solids.size());
}

TEST(SceneMesh, NodesOfTiesAreKnown) {
  Subject subject = read("two_plates.k");
  TieFailure failure;
  failure.node = subject.model.mesh.nodes.id[3];
  subject.report.tie_failures = {failure, failure};
  failure.node = 123456789;
  subject.report.tie_failures.push_back(failure);
  const SceneMesh scene = scene_mesh(subject.model, subject.report);
  ASSERT_EQ(scene.nodes.size(), 1u);
  EXPECT_EQ(scene.nodes[0].second, subject.model.mesh.nodes.x[3]);
}

TEST(SceneMesh, EmptyModelsGiveEmptyScenes) {
  const SceneMesh scene = scene_mesh(model::Model{}, Report{});
  EXPECT_TRUE(scene.faces.empty());
  EXPECT_TRUE(scene.outline.empty());
}

TEST(SceneMesh, OutlineOfASheetIsItsBorder) {
  Sheet sheet;
  sheet.add(10, 0, 0);
  SceneMesh scene = sheet.outline();
  EXPECT_EQ(scene.outline.size(), 40u);
  // The line between two parts counts too; and so does a fold.
  for (std::size_t f = 0; f < 50; ++f) sheet.faces[f].part = PartIndex(1);
  EXPECT_EQ(sheet.outline().outline.size(), 50u);
  for (std::size_t f = 0; f < 50; ++f) sheet.faces[f].part = PartIndex(0);
  for (Vector& x : sheet.x)
    if (x[1] > 5) x[2] = x[1] - 5;
  EXPECT_EQ(sheet.outline().outline.size(), 50u);
}

TEST(SceneMesh, OutlineOfTriangles) {
  Sheet sheet;
  sheet.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  sheet.faces = {{{0, 1, 2, 2}, PartIndex(0)}};
  EXPECT_EQ(sheet.outline().outline.size(), 3u);
  sheet.faces.push_back({{1, 3, 2, 2}, PartIndex(0)});
  EXPECT_EQ(sheet.outline().outline.size(), 4u) << "not the common edge";
}

TEST(SceneMesh, BeamsAreInTheOutline) {
  Sheet sheet;
  sheet.x = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  sheet.faces = {{{0, 1, 1, 1}, PartIndex(0)}, {{1, 2, 2, 2}, PartIndex(0)}};
  EXPECT_EQ(sheet.outline().outline.size(), 2u);
}

TEST(SceneMesh, OutlineIsMergedUntilItIsSmallEnough) {
  Sheet sheet;
  for (std::uint32_t k = 0; k < 20; ++k) sheet.add(30, k, k);
  ASSERT_EQ(sheet.outline().outline.size(), 20u * 120);
  for (const std::size_t limit : {1000, 100, 5, 0}) {
    const SceneMesh scene = sheet.outline(limit);
    EXPECT_LE(scene.outline.size(), limit);
    for (const auto& edge : scene.outline) EXPECT_NE(edge[0], edge[1]);
  }
  float low = 0, high = 0;
  for (const SceneMesh::Point& point : sheet.outline(100).outline_points) {
    low = std::min(low, point[0]);
    high = std::max(high, point[0]);
  }
  EXPECT_GT(high - low, 20) << "the outline has shrunk";
}

TEST(SceneMesh, StrayAndImpossibleNodesDoNotEmptyThePicture) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector& stray : {Vector(1e20, 0, 0), Vector(-1e300, 1e300, 0), Vector(nan, 0, 0)}) {
    Sheet sheet;
    sheet.add(10, 0, 0);
    const auto last = static_cast<std::uint32_t>(sheet.x.size());
    sheet.x.push_back(stray);
    sheet.faces.push_back({{0, last, last, last}, PartIndex(0)});
    const SceneFrame frame = scene_frame(sheet.x);
    EXPECT_LT((frame.high - frame.low).maxCoeff(), 100);
    const SceneMesh scene = sheet.outline();
    EXPECT_EQ(scene.outline.size(), 40u);
    EXPECT_EQ(scene.outline_left_out, 1u);
  }
}

}  // namespace
}  // namespace gapcheck::audit::scene_mesh_test
