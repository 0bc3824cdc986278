// Meshes that never were a deck: the deck made of them gives every number back, and faults name array and row.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <gapcheck/arrays.hpp>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace gapcheck::api_test::arrays_test {
namespace {

/// Two plates of part 1 and 2, z apart, of 3 x 3 quads.
struct Plates {
  std::vector<double> points;
  std::vector<std::int64_t> shells, parts;

  explicit Plates(double z) {
    for (const int plate : {0, 1}) {
      const std::int64_t first = static_cast<std::int64_t>(points.size()) / 3;
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) points.insert(points.end(), {5. * i + plate, 5. * j + plate, plate * z});
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
          const std::int64_t n = first + 4 * j + i;
          shells.insert(shells.end(), {n, n + 1, n + 5, n + 4});
          parts.push_back(plate + 1);
        }
    }
  }
  [[nodiscard]] api::ShellMesh mesh(double thickness = 1) const {
    return {.points = points, .shells = shells, .parts = parts, .thickness = thickness};
  }
};

TEST(ApiArrays, PlatesPenetrateByWhatTheyAreTooNear) {
  const Plates plates(0.7);
  const auto report = api::audit_arrays(plates.mesh());
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report.value().complete);
  EXPECT_EQ(report.value().input, "arrays");
  const api::Penetrations& p = report.value().penetrations;
  ASSERT_EQ(p.size(), 18u);  // nine nodes of each plate lie over the other one
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.depth[i], 0.3, 1e-15);
    const std::size_t row = static_cast<std::size_t>(p.node[i]) - 1;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(p.position[3 * i + k], plates.points[3 * row + k]);
    EXPECT_EQ(p.part[i], row < 16 ? 1 : 2);
  }
}

TEST(ApiArrays, ThicknessByPart) {
  const Plates plates(0.7);
  api::ShellMesh mesh = plates.mesh();
  mesh.part_thickness = {{2, 0.5}};
  auto report = api::audit_arrays(mesh);
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report.value().penetrations.size(), 18u);
  EXPECT_NEAR(report.value().penetrations.depth[0], 0.05, 1e-15);
  mesh.thickness = 0;  // not needed if all parts have their own
  mesh.part_thickness = {{1, 0.6}, {2, 0.6}};
  report = api::audit_arrays(mesh);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report.value().penetrations.size(), 0u);
}

TEST(ApiArrays, TrianglesWithoutParts) {
  const std::vector<double> points{0, 0, 0, 9, 0, 0, 9, 9, 0, 0, 0, 0.5, 9, 0, 0.5, 9, 9, 0.5};
  const std::vector<std::int64_t> shells{0, 1, 2, 2, 3, 4, 5, 5};
  const auto report = api::audit_arrays({.points = points, .shells = shells, .thickness = 0.8});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report.value().model.shells, 2u);
  EXPECT_EQ(report.value().model.parts, 1u);
  ASSERT_EQ(report.value().penetrations.size(), 6u);
  for (const double depth : report.value().penetrations.depth) EXPECT_NEAR(depth, 0.3, 1e-15);
}

TEST(ApiArrays, OneSideOfTheContact) {
  const Plates plates(0.7);
  api::ShellMesh mesh = plates.mesh();
  mesh.contact = "AUTOMATIC_NODES_TO_SURFACE";
  mesh.tracked = {2};
  mesh.reference = {1};
  auto report = api::audit_arrays(mesh);
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report.value().penetrations.size(), 9u);
  for (const std::int64_t part : report.value().penetrations.part) EXPECT_EQ(part, 2);
  mesh.contact = "AUTOMATIC_SINGLE_SURFACE";
  mesh.tracked = {1};
  mesh.reference = {};
  report = api::audit_arrays(mesh);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report.value().penetrations.size(), 0u);
  EXPECT_EQ(report.value().contacts[0].tracked_nodes, 16u);
}

/// Random bit patterns of numbers are the same after writing and reading, bit for bit.
TEST(ApiArrays, NoDigitIsLost) {
  std::mt19937_64 random(20261127);
  std::vector<double> points{0,
                             -0.0,
                             0.1,
                             1. / 3,
                             std::numeric_limits<double>::denorm_min(),
                             -1e30,
                             2.2250738585072014e-308,
                             123456789.123456789,
                             1e-7};
  while (points.size() < 30000)
    if (const double x = std::bit_cast<double>(random()); std::abs(x) <= 1e30) points.push_back(x);
  std::vector<std::int64_t> shells;
  for (std::int64_t row = 0; row + 4 <= 10000; row += 4) shells.insert(shells.end(), {row, row + 1, row + 2, row + 3});
  api::AuditOptions options;
  options.mesh = true;
  options.select = {"GC501"};  // no contact has to be built of such points
  const auto report = api::audit_arrays({.points = points, .shells = shells, .thickness = 1. / 3}, options);
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_TRUE(report.value().mesh.has_value());
  const api::Mesh& mesh = *report.value().mesh;
  ASSERT_EQ(mesh.points.size(), points.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    different += std::bit_cast<std::uint64_t>(points[i]) == std::bit_cast<std::uint64_t>(mesh.points[i]) ? 0 : 1;
  EXPECT_EQ(different, 0u);
}

TEST(ApiArrays, FaultsNameArrayAndRow) {
  const Plates plates(0.7);
  const auto message = [&](const auto& change) {
    Plates changed = plates;
    api::ShellMesh mesh;
    mesh.thickness = 1;
    change(changed, mesh);
    mesh.points = changed.points;
    mesh.shells = changed.shells;
    mesh.parts = changed.parts;
    const auto report = api::audit_arrays(mesh);
    return report.ok() ? std::string("accepted") : report.error().message;
  };
  EXPECT_EQ(message([](Plates&, api::ShellMesh&) {}), "accepted");
  EXPECT_EQ(message([](Plates& p, auto&) { p.points[13] = std::numeric_limits<double>::quiet_NaN(); }),
            "points, row 4: nan is not a number from -1e+30 to 1e+30");
  EXPECT_EQ(message([](Plates& p, auto&) { p.points[0] = -std::numeric_limits<double>::infinity(); }),
            "points, row 0: -inf is not a number from -1e+30 to 1e+30");
  EXPECT_EQ(message([](Plates& p, auto&) { p.points[95] = 1.1e30; }),
            "points, row 31: 1.1e+30 is not a number from -1e+30 to 1e+30");
  EXPECT_EQ(message([](auto&, auto& m) { m.thickness = 1e31; }), "thickness: 1e+31 is not a length above 0");
  EXPECT_EQ(message([](Plates& p, auto&) { p.points.pop_back(); }), "points: 95 numbers are not rows of 3");
  EXPECT_EQ(message([](Plates& p, auto&) { p.shells.pop_back(); }), "shells: 71 numbers are not rows of 4");
  EXPECT_EQ(message([](Plates& p, auto&) { p.shells.clear(), p.parts.clear(); }), "shells: there are none");
  EXPECT_EQ(message([](Plates& p, auto&) { p.parts.pop_back(); }), "parts: 17 ids for 18 shells");
  EXPECT_EQ(message([](Plates& p, auto&) { p.shells[5] = 32; }),
            "shells, row 1: 32 is not one of the 32 rows of points, which count from 0");
  EXPECT_EQ(message([](Plates& p, auto&) { p.shells[71] = -1; }),
            "shells, row 17: -1 is not one of the 32 rows of points, which count from 0");
  EXPECT_EQ(message([](Plates& p, auto&) { p.parts[3] = 0; }), "parts, row 3: 0 is not an id of 1 or more");
  EXPECT_EQ(message([](auto&, auto& m) { m.thickness = -1; }), "thickness: -1 is not a length above 0");
  EXPECT_EQ(message([](auto&, auto& m) {
              m.part_thickness = {{2, 0}};
            }),
            "part_thickness, part 2: 0 is not a length above 0");
  EXPECT_EQ(message([](auto&, auto& m) { m.part_thickness = {{3, 1}}; }), "part_thickness: part 3 has no shells");
  EXPECT_EQ(message([](auto&, auto& m) { m.tracked = {1, 7}; }), "tracked: part 7 has no shells");
  EXPECT_EQ(message([](auto&, auto& m) { m.reference = {1}; }), "reference: a single surface has no reference side");
  for (const char* type : {"AUTOMATIC", "ERODING_SINGLE_SURFACE", "FORCE_TRANSDUCER", "AUTOMATIC_SINGLE_SURFACE_ID",
                           "AUTOMATIC_SINGLE_SURFACE\n*NODE", "2D_AUTOMATIC_SINGLE_SURFACE", "DRAWBEAD"})
    EXPECT_EQ(message([&](auto&, auto& m) { m.contact = type; }),
              fmt::format("contact: '{}' is not a type of contact between shells that has no cards of its own", type));
}

TEST(ApiArrays, OptionsOfAuditsHold) {
  const Plates plates(0.7);
  api::AuditOptions options;
  options.ptol = 0.31;
  const auto none = api::audit_arrays(plates.mesh(), options);
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(none.value().penetrations.size(), 0u);
}

}  // namespace
}  // namespace gapcheck::api_test::arrays_test
