// Random sheets through a plate: what crosses is parted or named, and nothing new crosses or penetrates.
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string_view>
#include <utility>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"
#include "audit/run.hpp"
#include "audit/untangle/crossing_pairs.hpp"

namespace gapcheck::audit_test::random_crossing_test {
namespace {

constexpr std::uint64_t scenes = 500;

/// Contacts between the plate, part 1, and the sheets, parts 2 and 3 (set 9), or among all: every kind that keeps
/// surfaces apart.
constexpr std::array<std::string_view, 13> contacts{
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n\n\n",
    "*CONTACT_AUTOMATIC_GENERAL\n         0         0         5\n\n\n",
    "*CONTACT_AUTOMATIC_GENERAL_INTERIOR\n         0         0         5\n\n\n",
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n\n\n         2\n",
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n\n\n         2         0         0         0   "
    "      5\n",
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR\n         0         0         5\n\n\n",
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n         9         1         2         3\n\n\n",
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n         9         1         2         3\n\n\n",
    "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n         9         1         2         3\n\n\n",
    "*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE\n         9         1         2         3\n\n\n",
    "*CONTACT_SURFACE_TO_SURFACE\n         9         1         2         3\n\n\n",
    "*CONTACT_ONE_WAY_SURFACE_TO_SURFACE\n         9         1         2         3\n\n\n         2\n",
    "*CONTACT_SINGLE_SURFACE\n         0         0         5\n\n\n"};

/// A plate, and one or two sheets of random size, place and tilt, each with an end or corner below it.
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
  text += "*SET_PART_LIST\n         9\n         2         3\n";
  // The wall cuts into the ends below the plate.
  if (seed % 5 == 0) text += "*RIGIDWALL_PLANAR\n\n        0.        0.      -1.5        0.        0.        0.\n";
  return text + std::string(contacts[seed % contacts.size()]) + "*END\n";
}

bool moves_first_side(std::uint64_t seed) {
  return contacts[seed % contacts.size()].starts_with("*CONTACT_SURFACE_TO_SURFACE");
}

/// Contact and node of what the audit lists.
std::set<std::pair<int, std::int64_t>> listed_nodes(const std::string& text) {
  audit::AuditOptions options;
  options.select = {"GC101", "GC102", "GC107", "GC108", "GC109", "GC110"};
  std::set<std::pair<int, std::int64_t>> nodes;
  const Report report = run_text(text, options).report;
  for (const Penetration& p : report.penetrations) nodes.emplace(p.contact, p.node);
  return nodes;
}

TEST(FixRandomCrossing, IsPartedOrNamed) {
  std::uint64_t crossing = 0, parted = 0, before_all = 0, left = 0;
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
    expect_only_listed_lines(text, run);
    EXPECT_EQ(penetrating_before(again), penetrating_after(report)) << "seed " << seed;
    EXPECT_LE(penetrating_before(again), penetrating_before(report)) << "seed " << seed;
    std::set<std::pair<int, std::int64_t>> named_nodes;
    for (const UnfixedNode& node : report.unfixed) named_nodes.emplace(node.contact, node.node);
    // Of a two-way contact that moves nodes the audit judges the second side after the nodes of the first have moved.
    if (named_nodes.empty() || !moves_first_side(seed)) {
      EXPECT_EQ(listed_nodes(run.text), named_nodes) << "seed " << seed;
    }
    std::uint64_t named = 0;
    for (const LeftCrossing& c : report.crossings) named += c.pairs;
    EXPECT_EQ(named, after.size()) << "seed " << seed;
    crossing += before.empty() ? 0 : 1;
    parted += !before.empty() && after.empty() ? 1 : 0;
    before_all += penetrating_before(report);
    left += penetrating_after(report);
  }
  RecordProperty("crossing", std::to_string(crossing));
  RecordProperty("parted", std::to_string(parted));
  RecordProperty("before", std::to_string(before_all));
  RecordProperty("left", std::to_string(left));
  EXPECT_GT(crossing, scenes * 9 / 10);
  EXPECT_GT(parted, crossing * 85 / 100);
  EXPECT_LT(10 * left, before_all);
}

}  // namespace
}  // namespace gapcheck::audit_test::random_crossing_test
