// Random sheets through a plate: what crosses is parted or named, and nothing new crosses or penetrates.
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"
#include "audit/untangle/crossing_pairs.hpp"

namespace gapcheck::audit_test::random_crossing_test {
namespace {

constexpr std::uint64_t scenes = 500;

/// A plate, and two or three sheets of random size, place and tilt, each with an end or corner below it.
std::string scene(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const Plate ground{.id = 1, .nx = 12, .ny = 12};
  std::string text = "*KEYWORD\n" + elastic_steel + ground.deck();
  const int sheets = 1 + static_cast<int>(random() % 2);
  for (int s = 0; s < sheets; ++s) {
    const int part = 2 + s, nx = 2 + static_cast<int>(random() % 5), ny = 2 + static_cast<int>(random() % 4);
    const double turn = between(0, 2 * std::numbers::pi), tilt = between(0.05, 1.5), size = between(3.0, 6.0);
    const double x = between(15, 45), y = between(15, 45), deep = between(0.2, 2.0);
    const Vector along(std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt));
    Vector across(-std::sin(turn), std::cos(turn), random() % 2 == 0 ? 0.0 : 0.3);
    across.normalize();
    std::string nodes, elements;
    const auto node = [&](int i, int j) { return 1000 * part + 1 + j * (nx + 1) + i; };
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const Vector p = Vector(x, y, -deep) + size * (i * along + j * across);
        nodes += fmt::format("{:8}{:16.9f}{:16.9f}{:16.9f}\n", node(i, j), p.x(), p.y(), p.z());
      }
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        elements += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", 1000 * part + 1 + j * nx + i, part, node(i, j),
                                node(i + 1, j), node(i + 1, j + 1), node(i, j + 1));
    text += fmt::format("*PART\nsheet\n{:10}{:10}{:10}\n*NODE\n", part, 1, 1) + nodes + "*ELEMENT_SHELL\n" + elements;
  }
  return text + single_surface + "*END\n";
}

std::uint64_t penetrating(const FixReport& report) {
  std::uint64_t count = 0;
  for (const FixContact& c : report.contacts) count += c.before.penetrations + c.before.released;
  return count;
}

TEST(FixRandomCrossing, IsPartedOrNamed) {
  std::uint64_t crossing = 0, parted = 0, penetrating_before = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const std::string text = scene(seed);
    const FixRun run = fix_text(text);
    ASSERT_EQ(run.errors, 0u) << "seed " << seed;
    const FixReport& report = run.report();
    const auto before = audit::crossing_pairs(model_of(text)), after = audit::crossing_pairs(model_of(run.text));
    EXPECT_EQ(before.size(), report.crossings_before) << "seed " << seed;
    EXPECT_EQ(after.size(), report.crossings_after) << "seed " << seed;
    for (const audit::ElementPair& pair : after) EXPECT_TRUE(before.contains(pair)) << "seed " << seed;
    const FixReport again = fix_text(run.text).report();
    EXPECT_EQ(penetrating(again), report.unfixed.size()) << "seed " << seed;
    EXPECT_LE(penetrating(again), penetrating(report)) << "seed " << seed;
    std::uint64_t named = 0;
    for (const LeftCrossing& c : report.crossings) named += c.pairs;
    EXPECT_EQ(named, after.size()) << "seed " << seed;
    crossing += before.empty() ? 0 : 1;
    parted += !before.empty() && after.empty() ? 1 : 0;
    penetrating_before += penetrating(report);
    left += report.unfixed.size();
  }
  RecordProperty("crossing", std::to_string(crossing));
  RecordProperty("parted", std::to_string(parted));
  RecordProperty("before", std::to_string(penetrating_before));
  RecordProperty("left", std::to_string(left));
  EXPECT_GT(crossing, scenes * 9 / 10);
  EXPECT_GT(parted, crossing * 85 / 100);
  EXPECT_LT(10 * left, penetrating_before);
}

}  // namespace
}  // namespace gapcheck::audit_test::random_crossing_test
