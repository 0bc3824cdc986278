// Whole models in other guises, with nodes on the bound to the last bit: what is found stays the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "contact/scene.hpp"

namespace gapcheck::contact::stress_test {
namespace {

/// A model as lists that a test can shuffle before it is built.
struct Plates {
  struct Shell {
    std::array<std::size_t, 4> corners;  ///< positions in `nodes`; triangles repeat the last one
    std::size_t part;
    [[nodiscard]] bool triangle() const { return corners[2] == corners[3]; }
  };
  std::vector<Vector> nodes;
  std::vector<std::int64_t> ids;
  std::vector<Shell> shells;
  std::vector<double> thickness;  ///< of the parts
  std::string keyword;
};

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  /// Plates over one another at multiples of 1/8, so that many nodes lie at the contact distance to the last bit; some
  /// are warped and shaken. All coordinates are multiples of 2^-20.
  Plates make() {
    static const char* const keywords[] = {"AUTOMATIC_SINGLE_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE",
                                           "AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_GENERAL"};
    Plates plates;
    plates.keyword = keywords[integer(0, 3)];
    const bool shaken = integer(0, 1) == 0;
    for (std::size_t part = 0; part < 2; ++part) {
      plates.thickness.push_back(integer(2, 6) / 8.0);
      add_plate(plates, part, part == 0 ? 0 : integer(1, 8) / 8.0, shaken ? 0.1 : 0);
    }
    plates.ids.resize(plates.nodes.size());
    std::iota(plates.ids.begin(), plates.ids.end(), 1);
    return plates;
  }

  template <class List>
  void shuffle(List& list) {
    std::shuffle(list.begin(), list.end(), random_);
  }

 private:
  void add_plate(Plates& plates, std::size_t part, double height, double shake) {
    const int n = integer(2, 6), m = integer(2, 6);
    const std::size_t first = plates.nodes.size(), row = static_cast<std::size_t>(n) + 1;
    const Vector corner(integer(-8, 8) / 4.0, integer(-8, 8) / 4.0, height);
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) {
        Vector x = corner + Vector(2 * i, 2 * j, 0);
        for (double& value : x) value = std::round((value + uniform(-shake, shake)) * 0x1p20) * 0x1p-20;
        plates.nodes.push_back(x);
      }
    for (std::size_t j = 0; j < static_cast<std::size_t>(m); ++j)
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        const std::size_t a = first + j * row + i;
        if (integer(0, 3) == 0) {
          plates.shells.push_back({{a, a + 1, a + row + 1, a + row + 1}, part});
          plates.shells.push_back({{a, a + row + 1, a + row, a + row}, part});
        } else {
          plates.shells.push_back({{a, a + 1, a + row + 1, a + row}, part});
        }
      }
  }

  std::mt19937_64 random_;
};

struct Found {
  PenetrationKind kind = PenetrationKind::initial;
  double depth = 0, contact_distance = 0;
};
using Record = std::map<std::int64_t, Found>;  ///< by node id

Record found(const Plates& plates, InitialCounters* counters = nullptr) {
  Scene scene;
  std::vector<PartIndex> parts;
  for (std::size_t i = 0; i < plates.thickness.size(); ++i)
    parts.push_back(scene.part(static_cast<std::int64_t>(i) + 1, plates.thickness[i]));
  std::vector<NodeIndex> nodes;
  for (const Vector& x : plates.nodes) nodes.push_back(scene.node(x));
  scene.model.mesh.nodes.id = plates.ids;
  for (const Plates::Shell& shell : plates.shells) {
    model::SegmentNodes corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = nodes[shell.corners[k]];
    scene.shell(parts[shell.part], corners);
  }
  scene.model.controls.ssthk = 1;
  model::Contact& contact = scene.contact(plates.keyword);
  if (plates.keyword.find("_TO_") != std::string::npos) {
    contact.a = {2, 3, 0, true};
    contact.b = {1, 3, 0, true};
  }
  InitialOptions options;
  options.nodes_stay = true;
  options.tolerance = 0;
  InitialCounters own;
  SurfaceStore surfaces(scene.model);
  Record record;
  for (const Penetration& p :
       initialise_contacts(scene.model, surfaces, options, counters ? *counters : own).penetrations)
    record[p.node] = {p.kind, p.depth, p.contact_distance};
  return record;
}

/// `factor`: of all lengths. `to`: the id that a node of the first model has in the second.
template <class To>
void expect_same(const Record& first, const Record& second, double factor, const To& to) {
  EXPECT_EQ(first.size(), second.size());
  for (const auto& [node, what] : first) {
    const auto other = second.find(to(node));
    if (other == second.end()) {
      ADD_FAILURE() << "node " << node << " is lost, depth " << what.depth;
      continue;
    }
    EXPECT_EQ(other->second.kind, what.kind) << "node " << node;
    EXPECT_NEAR(other->second.depth, factor * what.depth, 1e-14 * factor) << "node " << node;
    EXPECT_EQ(other->second.contact_distance, factor * what.contact_distance) << "node " << node;
  }
}
void expect_same(const Record& first, const Record& second, double factor = 1) {
  expect_same(first, second, factor, [](std::int64_t id) { return id; });
}

constexpr int scenes = 1000;

template <class Check>
void for_all_scenes(std::uint64_t seed, const Check& check) {
  std::size_t penetrations = 0;
  for (int i = 0; i < scenes && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("scene " + std::to_string(i));
    Maker maker(seed + static_cast<std::uint64_t>(i));
    const Plates plates = maker.make();
    const Record record = found(plates);
    penetrations += record.size();
    check(maker, plates, record);
  }
  EXPECT_GT(penetrations, 1000u);
}

TEST(StressInitial, NodesAndElementsInAnotherOrder) {
  for_all_scenes(1000, [](Maker& maker, const Plates& plates, const Record& record) {
    Plates other = plates;
    std::vector<std::size_t> order(plates.nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    maker.shuffle(order);
    for (std::size_t i = 0; i < order.size(); ++i) {
      other.nodes[order[i]] = plates.nodes[i];
      other.ids[order[i]] = plates.ids[i];
    }
    for (Plates::Shell& shell : other.shells)
      for (std::size_t& corner : shell.corners) corner = order[corner];
    maker.shuffle(other.shells);
    expect_same(record, found(other));
  });
}

TEST(StressInitial, OtherIds) {
  for_all_scenes(2000, [](Maker&, const Plates& plates, const Record& record) {
    const auto renumber = [](std::int64_t id) { return 8'000'017 - 13 * id; };
    Plates other = plates;
    for (std::int64_t& id : other.ids) id = renumber(id);
    expect_same(record, found(other), 1, renumber);
  });
}

TEST(StressInitial, AnotherCornerFirstAndTheOtherWayRound) {
  for_all_scenes(3000, [](Maker& maker, const Plates& plates, const Record& record) {
    Plates other = plates;
    for (Plates::Shell& shell : other.shells) {
      const auto end = shell.corners.begin() + (shell.triangle() ? 3 : 4);
      std::rotate(shell.corners.begin(), shell.corners.begin() + maker.integer(0, 2), end);
      if (maker.integer(0, 1) == 0) std::reverse(shell.corners.begin(), end);
      if (end != shell.corners.end()) shell.corners[3] = shell.corners[2];
    }
    expect_same(record, found(other));
  });
}

TEST(StressInitial, AnotherPlaceAndAnotherScale) {
  for_all_scenes(4000, [](Maker& maker, const Plates& plates, const Record& record) {
    Plates other = plates;
    const Vector way(maker.integer(-1'000'000'000, 1'000'000'000) * 0x1p-3, maker.integer(-1000, 1000) * 0x1p-20, 4096);
    for (Vector& x : other.nodes) x += way;
    expect_same(record, found(other));
    const double factor = std::ldexp(1.0, maker.integer(-30, 30));
    for (Vector& x : other.nodes) x *= factor;
    for (double& thickness : other.thickness) thickness *= factor;
    expect_same(record, found(other), factor);
  });
}

TEST(StressInitial, AThickerShellLosesNoPenetration) {
  for_all_scenes(5000, [](Maker& maker, const Plates& plates, const Record& record) {
    Record before = record;
    Plates thicker = plates;
    for (int step = 0; step < 4; ++step) {
      for (double& thickness : thicker.thickness)
        thickness =
            step < 2 ? std::nextafter(thickness, 100.0) : thickness * (1 + std::ldexp(1.0, -maker.integer(4, 50)));
      Record after = found(thicker);
      for (const auto& [node, what] : before)
        EXPECT_TRUE(after.contains(node)) << "node " << node << " is lost, depth " << what.depth;
      before = std::move(after);
    }
  });
}

TEST(StressInitial, OneBitDecides) {
  std::size_t tied = 0;
  for (int i = 0; i < scenes; ++i) {
    SCOPED_TRACE("scene " + std::to_string(i));
    Maker maker(6000 + static_cast<std::uint64_t>(i));
    Plates plates = maker.make();
    // Two parallel plates at their contact distance.
    const double gap = std::ldexp(maker.integer(1 << 19, 1 << 20), -20);
    for (Vector& x : plates.nodes) x.z() = 0;
    for (const Plates::Shell& shell : plates.shells)
      if (shell.part == 1)
        for (const std::size_t corner : shell.corners) plates.nodes[corner].z() = gap;
    plates.thickness = {gap, gap};
    EXPECT_TRUE(found(plates).empty()) << "touching is not penetrating";
    plates.thickness = {std::nextafter(gap, 100.0), std::nextafter(gap, 100.0)};
    InitialCounters counters;
    tied += found(plates, &counters).size();
    EXPECT_EQ(counters.decisions.triangulated, 0u);
  }
  EXPECT_GT(tied, 1000u) << "one bit more of thickness, and the nodes above the other plate penetrate";
}

}  // namespace
}  // namespace gapcheck::contact::stress_test
