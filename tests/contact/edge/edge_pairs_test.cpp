#include "contact/edge/edge_pairs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <set>
#include <utility>

#include "base/parallel.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::edge_pairs_test {
namespace {

const Vector ex = Vector::UnitX(), ey = Vector::UnitY();

/// Adds a beam part of a radius.
PartIndex beam_part(Scene& scene, std::int64_t id, double radius) {
  const PartIndex part = scene.part(id, 0);
  scene.model.sections.back().kind = model::SectionKind::beam;
  scene.model.sections.back().beam_radius = radius;
  return part;
}

void beam(Scene& scene, PartIndex part, NodeIndex a, NodeIndex b) {
  auto& beams = scene.model.mesh.beams;
  beams.id.push_back(static_cast<std::int64_t>(beams.size()) + 1);
  beams.nodes.push_back({a, b});
  beams.part.push_back(part);
  beams.line.push_back(0);
}

/// The edges that the first contact of a scene looks at.
struct Edges {
  explicit Edges(const model::Model& model)
      : surfaces(SurfaceStore(model).at(ContactIndex{0})),
        neighbours(surfaces.a.selection.segments, model.mesh, true),
        scene{model,
              model.contacts[0],
              surfaces.type,
              surfaces.settings,
              model.mesh.nodes.x,
              surfaces.a.selection.segments,
              surfaces.a.nodes,
              neighbours,
              2,
              {},
              {},
              -1,
              geometry::Mode::filtered},
        list(surface_edges(scene, surfaces.type.interior_edges)) {}
  ContactSurfaces surfaces;
  Neighbours neighbours;
  PairScene scene;
  std::vector<SurfaceEdge> list;
};

using NodePair = std::pair<std::uint32_t, std::uint32_t>;
std::set<NodePair> node_pairs(const std::vector<SurfaceEdge>& edges) {
  std::set<NodePair> pairs;
  for (const SurfaceEdge& e : edges)
    EXPECT_TRUE(pairs.insert(std::minmax(e.a.value, e.b.value)).second) << e.a.value << ' ' << e.b.value;
  return pairs;
}

TEST(EdgePairs, FreeEdgesAndWithInteriorAllOfThem) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, ex, ey, 3, 2);  // 12 nodes, 17 edges, 10 of them free
  scene.contact("AUTOMATIC_GENERAL");
  const auto free = node_pairs(Edges(scene.model).list);
  EXPECT_EQ(free.size(), 10U);
  EXPECT_FALSE(free.contains({1, 5}));
  set_name("CONTACT_AUTOMATIC_GENERAL_INTERIOR", scene.model.contacts[0]);
  const auto all = node_pairs(Edges(scene.model).list);
  EXPECT_EQ(all.size(), 17U);
  EXPECT_TRUE(all.contains({1, 5}));
}

TEST(EdgePairs, TheThickerShellOfTwoCounts) {
  Scene scene;
  const PartIndex thin = scene.part(1, 0.1), thick = scene.part(2, 0.3);
  const auto n = scene.plate(thin, {0, 0, 0}, ex, ey, 1, 1);
  scene.shell(thick, {n[1], scene.node({2, 0, 0}), scene.node({2, 1, 0}), n[3]});
  scene.contact("AUTOMATIC_GENERAL_INTERIOR");
  std::size_t seen = 0;
  for (const SurfaceEdge& e : Edges(scene.model).list) {
    if (std::minmax(e.a.value, e.b.value) != std::minmax(n[1].value, n[3].value)) continue;
    EXPECT_DOUBLE_EQ(e.half, 0.15);
    ++seen;
  }
  EXPECT_EQ(seen, 1U);
}

TEST(EdgePairs, TrianglesHaveThreeEdgesAndBeamsOne) {
  Scene scene;
  const PartIndex shell = scene.part(1, 1), rod = beam_part(scene, 2, 1);
  const NodeIndex a = scene.node({0, 0, 0}), b = scene.node({1, 0, 0}), c = scene.node({0, 1, 0});
  scene.shell(shell, {a, b, c, c});
  beam(scene, rod, a, b);  // does not make the shell's edge an inner one
  scene.contact("AUTOMATIC_GENERAL");
  const auto edges = Edges(scene.model).list;
  ASSERT_EQ(edges.size(), 4U);
  EXPECT_DOUBLE_EQ(edges[3].half, 1);
}

/// Many short beams in a box, of which some penetrate.
Scene hay(std::uint64_t seed) {
  Scene scene;
  const PartIndex part = beam_part(scene, 1, 0.1);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> at(0, 4), reach(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const Vector x(at(random), at(random), at(random));
    const NodeIndex a = scene.node(x), b = scene.node(x + Vector(reach(random), reach(random), reach(random)));
    beam(scene, part, a, b);
  }
  scene.contact("AUTOMATIC_GENERAL").ignore = 1;
  return scene;
}

std::vector<Penetration> edge_findings(Scene& scene, InitialOptions options = {}) {
  options.edges = true;
  std::vector<Penetration> found;
  for (const Penetration& p : scene.run(options).penetrations)
    if (p.kind == PenetrationKind::edge) found.push_back(p);
  return found;
}

bool same(const std::vector<Penetration>& a, const std::vector<Penetration>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Penetration& l, const Penetration& r) {
    return l.node == r.node && l.segment == r.segment && l.depth == r.depth && l.point == r.point;
  });
}

TEST(EdgePairs, EveryPairIsFoundHoweverItIsSearched) {
  Scene scene = hay(1);
  const auto fast = edge_findings(scene);
  InitialOptions slow, exact;
  slow.brute_force = true;
  exact.mode = geometry::Mode::exact;
  EXPECT_GT(fast.size(), 50U);
  EXPECT_TRUE(same(fast, edge_findings(scene, slow)));
  EXPECT_TRUE(same(fast, edge_findings(scene, exact)));
  const JobLimit one(1);
  EXPECT_TRUE(same(fast, edge_findings(scene)));
}

TEST(EdgePairs, TurningByARightAngleAndMovingChangeNothing) {
  Scene scene = hay(2), turned = scene;
  for (Vector& x : turned.model.mesh.nodes.x) x = Vector(-x.y(), x.x(), x.z()) + Vector(64, -32, 16);
  const auto a = edge_findings(scene), b = edge_findings(turned);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].node, b[i].node);
    EXPECT_EQ(a[i].segment, b[i].segment);
    EXPECT_NEAR(a[i].depth, b[i].depth, 1e-12);
  }
}

TEST(EdgePairs, OnlyWhereAskedForAndNothingIsMoved) {
  Scene scene;
  const PartIndex part = beam_part(scene, 1, 1);
  beam(scene, part, scene.node({-9, 0, 0}), scene.node({9, 0, 0}));
  beam(scene, part, scene.node({0, -9, 1.5}), scene.node({0, 9, 1.5}));
  scene.contact("AUTOMATIC_GENERAL");
  EXPECT_TRUE(scene.run().penetrations.empty());
  InitialOptions options;
  options.edges = true;
  const InitialState state = scene.run(options);
  EXPECT_EQ(state.penetrations.size(), 1U);
  EXPECT_EQ(state.contacts[0].edge_penetrations, 1U);
  EXPECT_EQ(state.x, scene.model.mesh.nodes.x);
}

// Every pair whose nearest points are within both edges is one decision, of the stage that reached it.
TEST(EdgePairs, DecisionsAreCountedByTheirStage) {
  Scene scene;
  const PartIndex part = beam_part(scene, 1, 1);
  beam(scene, part, scene.node({-9, 0, 0}), scene.node({9, 0, 0}));
  beam(scene, part, scene.node({0, -9, 1.5}), scene.node({0, 9, 1.5}));
  scene.contact("AUTOMATIC_GENERAL");
  for (const auto mode : {geometry::Mode::filtered, geometry::Mode::exact}) {
    InitialOptions options;
    options.edges = true;
    options.mode = mode;
    InitialCounters counters;
    SurfaceStore surfaces(scene.model);
    EXPECT_EQ(initialise_contacts(scene.model, surfaces, options, counters).penetrations.size(), 1U);
    EXPECT_EQ(counters.decisions.filter, mode == geometry::Mode::filtered ? 1U : 0U);
    EXPECT_EQ(counters.decisions.exact, mode == geometry::Mode::exact ? 1U : 0U);
    EXPECT_EQ(counters.decisions.interval + counters.decisions.triangulated, 0U);
    EXPECT_EQ(counters.edges, 2U);
  }
}

TEST(EdgePairs, NumbersThatAreNoneAndBeamsWithoutLengthMeetNothing) {
  Scene scene;
  const PartIndex part = beam_part(scene, 1, 1);
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  beam(scene, part, scene.node({nan, 0, 0}), scene.node({9, 0, 0}));
  beam(scene, part, scene.node({0, -9, inf}), scene.node({0, 9, 1}));
  beam(scene, part, scene.node({0, 0, 0}), scene.node({0, 0, 0}));
  beam(scene, part, scene.node({-1e300, 0, 0}), scene.node({1e300, 0, 0}));
  scene.contact("AUTOMATIC_GENERAL").ignore = 1;
  EXPECT_TRUE(edge_findings(scene).empty());
}

}  // namespace
}  // namespace gapcheck::contact::edge_pairs_test
