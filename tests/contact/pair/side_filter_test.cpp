#include "contact/pair/side_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "contact/pair/side_scene.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::side_filter_test {
namespace {

/// Numbers from -1 to 1.
double number(std::mt19937_64& random) { return static_cast<double>(random() % 2000001) / 1e6 - 1; }

/// Nodes of a grid of 3 x 3 x 3, each out of place by up to `rough`, at `place`.
std::vector<NodeIndex> grid(Scene& scene, std::mt19937_64& random, double rough, const Vector& place) {
  std::vector<NodeIndex> nodes;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const Vector out{number(random), number(random), number(random)};
        nodes.push_back(scene.node(place + Vector(i, j, 0.7 * k) + rough * out));
      }
  return nodes;
}

/// Three bricks and a wedge around an edge, with convex and concave edges between their faces; shells of a second part
/// below; and a brick of a third part, whose nodes are the probes.
struct Around {
  Scene scene;
  std::size_t probes;
  Around(std::mt19937_64& random, double rough, const Vector& place, const char* keyword) {
    const PartIndex bricks = scene.part(1, 0), shells = scene.part(2, 0.3), probe = scene.part(3, 0);
    scene.model.sections[0].kind = scene.model.sections[2].kind = model::SectionKind::solid;
    const std::vector<NodeIndex> n = grid(scene, random, rough, place);
    const auto at = [&](int i, int j, int k) { return n[static_cast<std::size_t>(i + 3 * j + 9 * k)]; };
    const auto brick = [&](int i, int j, int k) {
      scene.solid(bricks, {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
                           at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)});
    };
    brick(0, 0, 0);
    brick(1, 0, 0);
    brick(0, 0, 1);
    scene.solid(bricks, {at(0, 1, 0), at(1, 1, 0), at(1, 2, 0), at(0, 2, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 1),
                         at(0, 1, 1)});
    scene.plate(shells, place + Vector(0, 0, -0.4), Vector(1, 0.1, 0), Vector(0.2, 1, 0.05), 2, 2);
    probes = scene.model.mesh.nodes.size();
    scene.brick(probe, place + Vector(20, 0, 0), {1, 1, 1});
    model::Contact& contact = scene.contact(keyword);
    if (contact.keyword.find("SINGLE") != std::string::npos) return;
    // Of the old types, shells have a front too; they need two sides.
    contact.a = {3, 3, 0, true};
    contact.b = {2, 3, 0, true};
  }
};

struct Tally {
  std::size_t pairs = 0, proven = 0, hits = 0, shells = 0;
};

/// Compares the filter with decide_pair() for random places of a probe around every oriented segment.
void compare(PairScene& scene, std::vector<Vector>& x, NodeIndex probe, std::mt19937_64& random, Tally& tally) {
  SlotIndex slot = none<SlotIndex>;
  for (const SlotIndex i : positions<SlotIndex>(scene.nodes.size()))
    if (scene.nodes.node[i.value] == probe) slot = i;
  ASSERT_NE(slot, none<SlotIndex>);
  for (const SegmentIndex s : positions<SegmentIndex>(scene.segments.size())) {
    if (!scene.oriented(s) || is_corner(scene.segments.nodes[s.value], probe)) continue;
    const geometry::Facet facet = scene.facet(s);
    if ((facet.x[0] - x[probe.value]).norm() > 10) continue;  // the probe's own brick
    const SideFilter filter(scene, s, facet);
    const Vector middle = (facet.x[0] + facet.x[1] + facet.x[2] + facet.x[3]) / 4;
    for (int i = 0; i < 30; ++i) {
      const double reach = i % 3 == 0 ? 0.4 : i % 3 == 1 ? 1.0 : 2.0;
      const Vector query = middle + reach * Vector(number(random), number(random), number(random));
      x[probe.value] = query;
      ++tally.pairs;
      tally.shells += scene.segments.kind[s.value] == SegmentKind::shell ? 1 : 0;
      const bool penetrates = decide_pair(scene, slot, s).penetrates;
      tally.hits += penetrates ? 1 : 0;
      if (!filter.apart(query, penetration_bound(scene, slot, s, facet, query))) continue;
      ++tally.proven;
      ASSERT_FALSE(penetrates) << "segment " << s.value << ", query " << query.transpose();
    }
  }
}

// What the filter proves is what decide_pair() says, for bricks that are warped, tapered and skew, at any place.
TEST(SideFilter, ProvesNoNodeApartThatPenetrates) {
  std::mt19937_64 random(23);
  for (const char* keyword : {"AUTOMATIC_SINGLE_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE"}) {
    for (const double far : {0.0, 3e6}) {
      Tally flat, all;
      for (int round = 0; round < 120; ++round) {
        const double rough = round % 4 == 0 ? 0 : 0.08 * (round % 4);
        Around around(random, rough, Vector(far, -far, 0.5 * far), keyword);
        SurfaceStore surfaces(around.scene.model);
        std::vector<Vector>& x = around.scene.model.mesh.nodes.x;
        SideScene side(around.scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), false, x);
        const NodeIndex probe{static_cast<std::uint32_t>(around.probes)};
        x[probe.value] = around.scene.model.mesh.nodes.x[0];
        // Shells of old types may be turned round.
        if (round % 2 == 1)
          for (const SegmentIndex s : positions<SegmentIndex>(side.scene().segments.size()))
            side.scene().flipped.push_back(side.scene().segments.kind[s.value] == SegmentKind::shell &&
                                           random() % 2 == 0);
        compare(side.scene(), x, probe, random, rough == 0 ? flat : all);
        if (HasFatalFailure()) return;
      }
      EXPECT_EQ(all.shells > 0, keyword[0] == 'O');
      EXPECT_GT(flat.hits, flat.pairs / 50);
      EXPECT_GT(all.hits, all.pairs / 50);
      // A filter that proves nothing would agree too.
      EXPECT_GT(flat.proven, flat.pairs * 6 / 10) << keyword;
      EXPECT_GT(all.proven, all.pairs * 4 / 10) << keyword;
    }
  }
}

// Thin, folded, huge and tiny facets and coordinates that are no numbers prove nothing wrong.
TEST(SideFilter, LeavesHostileFacetsOpenOrAgrees) {
  std::mt19937_64 random(29);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 400; ++round) {
    Around around(random, 0.1, Vector::Zero(), "AUTOMATIC_SINGLE_SURFACE");
    std::vector<Vector>& x = around.scene.model.mesh.nodes.x;
    for (std::size_t i = 0; i < 27; ++i) {
      if (round % 4 == 0) x[i] = x[i].cwiseProduct(Vector(1, 1e-7, 1));
      if (round % 4 == 1) x[i] *= std::pow(10.0, 40 * number(random));
      if (round % 4 == 2 && random() % 3 == 0) x[i] = x[random() % 27];
      if (round % 4 == 3 && random() % 5 == 0) x[i][0] = random() % 2 == 0 ? nan : infinity;
    }
    SurfaceStore surfaces(around.scene.model);
    SideScene side(around.scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), false, x);
    const NodeIndex probe{static_cast<std::uint32_t>(around.probes)};
    Tally tally;
    compare(side.scene(), x, probe, random, tally);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace gapcheck::contact::side_filter_test
