// Random scenes: forces, moves and states of every node in every cycle are those of the slow twin.
#include "solver/contact/contact_twin.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "solver/contact_scene.hpp"

namespace gapcheck::solver::contact_twin_test {
namespace {

using Start = ContactTwin::Start;
constexpr double bulk = 1000 / 1.5, scale = 0.1;  // E = 1000, ν = 0.25; SLSFAC

/// A deck, and what the twin knows of it.
struct RandomScene {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n", solids = "*ELEMENT_SOLID\n", cards;
  std::vector<Vector> x;
  std::vector<int> body;
  std::vector<ContactTwin::Facet> facets;
  int elements = 0;

  std::size_t add_node(const Vector& at, int part) {
    x.push_back(at);
    body.push_back(part);
    nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", x.size(), at.x(), at.y(), at.z());
    return x.size() - 1;
  }
  [[nodiscard]] double area(const std::array<std::size_t, 4>& n) const {
    return (x[n[2]] - x[n[0]]).cross(x[n[3]] - x[n[1]]).norm() / 2;
  }
  void add_shell(const std::array<std::size_t, 4>& n, int part, double thickness) {
    shells += fmt::format("{},{},{},{},{},{}\n", ++elements, part, n[0] + 1, n[1] + 1, n[2] + 1, n[3] + 1);
    double longest = std::max((x[n[2]] - x[n[0]]).norm(), (x[n[3]] - x[n[1]]).norm());
    if (n[2] == n[3]) longest = std::max(longest, (x[n[1]] - x[n[0]]).norm());
    ContactTwin::Facet facet{n, part, false, thickness / 2, scale * bulk * area(n) / longest, 0, area(n) * thickness};
    facets.push_back(facet);
  }
  /// n x m shells, jittered; every third quad is cut into triangles.
  void add_plate(int part, int n, int m, double size, double z, double thickness, std::mt19937& random) {
    std::uniform_real_distribution<double> jitter(-1, 1);
    const std::size_t first = x.size();
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i)
        add_node(
            {size * (i + 0.15 * jitter(random)) / n, size * (j + 0.15 * jitter(random)) / m, z + 0.01 * jitter(random)},
            part);
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const std::size_t a = first + static_cast<std::size_t>(j * (n + 1) + i), b = a + 1,
                          d = a + static_cast<std::size_t>(n) + 1, c = d + 1;
        if ((i + 2 * j) % 3 == 0) {
          add_shell({a, b, c, c}, part, thickness);
          add_shell({a, c, d, d}, part, thickness);
        } else {
          add_shell({a, b, c, d}, part, thickness);
        }
      }
    cards += fmt::format("*PART\nplate\n{0},{0},1\n*SECTION_SHELL\n{0},2\n{1},\n", part, thickness);
  }
  /// n x n x 1 bricks with their top near z = 0.
  void add_block(int part, int n, double size, double height, std::mt19937& random) {
    std::uniform_real_distribution<double> jitter(-1, 1);
    const std::size_t first = x.size();
    const auto row = static_cast<std::size_t>(n) + 1;
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          add_node({size * (i + 0.1 * jitter(random)) / n - 0.1, size * (j + 0.1 * jitter(random)) / n - 0.1,
                    height * (k - 1) + 0.005 * jitter(random)},
                   part);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const std::size_t a = first + static_cast<std::size_t>(j) * row + static_cast<std::size_t>(i);
        const std::array<std::size_t, 8> c{a,
                                           a + 1,
                                           a + 1 + row,
                                           a + row,
                                           a + row * row,
                                           a + 1 + row * row,
                                           a + 1 + row + row * row,
                                           a + row + row * row};
        solids += fmt::format("{},{}", ++elements, part);
        for (const std::size_t node : c) solids += fmt::format(",{}", node + 1);
        solids += "\n";
        std::array<Vector, 8> corners;
        for (std::size_t s = 0; s < 8; ++s) corners[s] = x[c[s]];
        const double volume = brick_volume(corners);
        const auto face = [&](bool outer, std::size_t p, std::size_t q, std::size_t r, std::size_t s) {
          if (!outer) return;
          const std::array<std::size_t, 4> nodes_of{c[p], c[q], c[r], c[s]};
          const double k = scale * bulk * area(nodes_of) * area(nodes_of) / volume;
          facets.push_back({nodes_of, part, true, 0, k, 1, volume / 2});
        };
        face(true, 3, 2, 1, 0);
        face(true, 4, 5, 6, 7);
        face(j == 0, 0, 1, 5, 4);
        face(j == n - 1, 2, 3, 7, 6);
        face(i == 0, 0, 4, 7, 3);
        face(i == n - 1, 1, 2, 6, 5);
      }
    cards += fmt::format("*PART\nblock\n{0},{0},1\n*SECTION_SOLID\n{0},1\n", part);
  }
  [[nodiscard]] std::string deck(const std::string& contact) const {
    return nodes + (facets.empty() ? "" : shells) + (solids.size() > 15 ? solids : "") + cards +
           "*MAT_ELASTIC\n1,1.,1000.,0.25\n" + contact;
  }
};

struct Case {
  const char* name;
  bool single;
  Start start;
  bool block;
};

class Twin : public testing::TestWithParam<Case> {};

TEST_P(Twin, AgreesInEveryCycle) {
  const Case& one = GetParam();
  std::size_t forced = 0, released = 0, moved = 0, passed = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-1, 1);
    RandomScene scene;
    if (one.block)
      scene.add_block(1, 3, 1.2, 0.4, random);
    else
      scene.add_plate(1, 4, 3, 1, 0, 0.03 + 0.01 * jitter(random), random);
    // Plates that jump into the contact distance from beyond what the segments have in sight.
    const bool jumps = one.start == Start::moved && seed % 3 == 0;
    const std::size_t lower = scene.x.size();
    scene.add_plate(2, 3, 4, 0.9, one.block ? 0.04 : jumps ? 0.13 : 0.07, 0.05, random);
    std::string contact =
        one.single ? "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n" : "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n";
    const bool segments = one.start == Start::segments;
    contact += segments ? "0.\n1.,1.\n2\n" : "0.\n1.,1.\n0\n";
    contact += one.start == Start::forced ? "0.,0,0,1\n" : one.start == Start::moved ? "0.\n" : "0.\n1,1\n";
    StepSettings settings;
    settings.greatest_step = one.block ? 2e-4 : 5e-4;
    settings.energy_tolerance = 0;
    // Fast plates go too deep, blocks must stay in front.
    const double speed = one.block ? 0.6 : jumps ? 220 : seed % 2 == 0 ? 1 : 12;
    ContactScene run(
        scene.deck(contact),
        [&](Structure& s) {
          for (std::size_t i = 0; i < s.state.x.size(); ++i) {
            s.state.v[i] = 0.2 * Vector(jitter(random), jitter(random), jitter(random));
            if (i >= lower) s.state.v[i].z() -= speed;
          }
        },
        settings);
    ASSERT_TRUE(run.stepper) << run.why_not;
    for (const Penetration& p : run.initial.penetrations)
      ADD_FAILURE() << "seed " << seed << " node " << p.node << " penetrates by " << p.depth << " kind " << int(p.kind);
    ContactTwin twin(scene.facets, scene.body, one.single, one.start);
    twin.set_step(settings.greatest_step);
    for (int cycle = 0; cycle < 300; ++cycle) {
      std::vector<Vector> x = run.state().x;
      const std::size_t moves = twin.moved();
      const std::vector<ContactTwin::Point> forces = twin.cycle(x);
      const SolverStatus status = run.stepper->begin_step();
      ASSERT_TRUE(status.ok()) << status.error().message;
      long double largest = 0;
      for (const auto& force : forces)
        for (const long double f : force) largest = std::max(largest, std::abs(f));
      if (largest > 0) ++forced;
      for (std::size_t n = 0; n < x.size(); ++n) {
        for (std::size_t axis = 0; axis < 3; ++axis)
          ASSERT_LE(std::abs(forces[n][axis] - run.stepper->external().force[n][static_cast<int>(axis)]),
                    1e-9L * (largest + 1e-3L))
              << "node " << n + 1 << " cycle " << cycle << " seed " << seed;
        ASSERT_LE((x[n] - run.state().x[n]).norm(), 1e-12)
            << "node " << n + 1 << " cycle " << cycle << " seed " << seed;
      }
      std::map<std::size_t, ContactNode::Kind> seen;
      for (const ContactNode& node : run.contacts->nodes(0)) seen[node.node.value] = node.kind;
      for (std::size_t n = 0; n < x.size(); ++n) {
        const auto found = seen.find(n);
        const bool lost = found != seen.end() && found->second == ContactNode::Kind::released;
        ASSERT_EQ(lost, twin.memory(n) == ContactTwin::Memory::released)
            << "node " << n + 1 << " cycle " << cycle << " seed " << seed;
        ASSERT_FALSE(found != seen.end() && twin.memory(n) == ContactTwin::Memory::apart) << "node " << n + 1;
        released += lost;
      }
      moved += twin.moved() - moves;
      run.stepper->end_step();
    }
    passed += twin.passed();
  }
  EXPECT_GT(forced, 100u);
  EXPECT_EQ(released > 0, !one.block && one.start != Start::segments);
  EXPECT_EQ(passed > 0, !one.block && one.start == Start::segments);
  EXPECT_EQ(moved > 0, one.start == Start::moved);
}

INSTANTIATE_TEST_SUITE_P(All, Twin,
                         testing::Values(Case{"two_way_forced", false, Start::forced, false},
                                         Case{"two_way_ignored", false, Start::ignored, false},
                                         Case{"two_way_moved", false, Start::moved, false},
                                         Case{"single_forced", true, Start::forced, false},
                                         Case{"single_ignored", true, Start::ignored, false},
                                         Case{"single_moved", true, Start::moved, false},
                                         Case{"block_forced", false, Start::forced, true},
                                         Case{"block_ignored", false, Start::ignored, true},
                                         Case{"two_way_segments", false, Start::segments, false},
                                         Case{"single_segments", true, Start::segments, false},
                                         Case{"block_segments", false, Start::segments, true}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace gapcheck::solver::contact_twin_test
