// Search, audit and solver on several threads: the same results as on one, and, built with the thread sanitizer, no
// race.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

#include "audit/audit.hpp"
#include "base/parallel.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::threads_test {
namespace {

/// Two plates of n × n shells of thickness 1, the second one shifted by (0.3, 0.3, 0.7) and slightly waved.
std::string two_plates(int n) {
  std::string text = "*KEYWORD\n*CONTROL_TERMINATION\n1.\n*PART\nlower\n1,1,1\n*PART\nupper\n2,1,1\n";
  text += "*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n*MAT_ELASTIC\n1,7.8e-6,210.,0.3\n";
  text += "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n1,all\n0,0,5\n0.1\n0.,0.,1.,1.\n*NODE\n";
  for (int plate = 0; plate < 2; ++plate)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        text += fmt::format("{},{},{},{}\n", 1 + plate * 100'000 + j * (n + 1) + i, i + 0.3 * plate, j + 0.3 * plate,
                            plate * (0.7 + 0.05 * ((i + j) % 7)));
  text += "*ELEMENT_SHELL\n";
  for (int plate = 0; plate < 2; ++plate)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int first = 1 + plate * 100'000 + j * (n + 1) + i;
        text += fmt::format("{},{},{},{},{},{}\n", 1 + plate * 100'000 + j * n + i, plate + 1, first, first + 1,
                            first + n + 2, first + n + 1);
      }
  return text + "*END\n";
}

using Listed = std::tuple<std::int64_t, std::int64_t, double, int>;

std::vector<Listed> audited(const std::string& path, std::size_t jobs) {
  const JobLimit limit(jobs);
  Diagnostics diagnostics;
  const auto report = audit::audit_deck(path, {}, diagnostics);
  EXPECT_TRUE(report.ok());
  std::vector<Listed> list;
  if (!report.ok()) return list;
  for (const Penetration& p : report.value().penetrations)
    list.emplace_back(p.node, p.element, p.depth, static_cast<int>(p.kind));
  for (const Finding& finding : report.value().findings)
    list.emplace_back(finding.node, finding.element, finding.penetration, -1);
  return list;
}

TEST(Threads, AuditFindsTheSame) {
  const auto path = std::filesystem::temp_directory_path() / "gapcheck_threads_test.k";
  std::ofstream(path) << two_plates(40);
  const std::vector<Listed> alone = audited(path.string(), 1);
  EXPECT_GT(alone.size(), 1500U);
  EXPECT_EQ(alone, audited(path.string(), 4));
  std::filesystem::remove(path);
}

TEST(Threads, RunsToTheSameBits) {
  const std::string text = two_plates(24);
  solver::RunSettings settings;
  settings.cycles = 6;
  const auto places = [&](std::size_t jobs) {
    const JobLimit limit(jobs);
    solver::RunScene scene(text, settings);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    if (scene.prepared()) scene.go();
    return scene.state().x;
  };
  const std::vector<Vector> alone = places(1);
  EXPECT_EQ(alone.size(), 2U * 25 * 25);
  EXPECT_EQ(alone, places(4));
}

}  // namespace
}  // namespace gapcheck::threads_test
