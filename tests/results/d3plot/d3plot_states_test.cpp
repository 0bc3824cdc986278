#include "results/d3plot/d3plot_states.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "folder_test.hpp"
#include "results/d3plot/d3plot_write.hpp"
#include "results/d3plot_sample.hpp"

namespace gapcheck::results::d3plot_states_test {
namespace {

namespace fs = std::filesystem;

class D3plotFamily : public FolderTest {
 protected:
  [[nodiscard]] std::string path() const { return (folder_ / "d3plot").string(); }
};

std::string contents(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const std::vector<LegendEntry> parts{{7, "solids"}, {3, "plate"}, {5, "beams and thick shells"}};

D3plot sample_mesh() {
  D3plot mesh;
  mesh.title = "a small model";
  for (int i = 0; i < 9; ++i) {
    mesh.node_ids.push_back(100 - 7 * i);
    mesh.coordinates.push_back({0.5 * i, -1.0 * i, 0.125});
  }
  mesh.solids.ids = {11};
  mesh.solids.nodes = {{0, 1, 2, 3, 4, 5, 6, 7}};
  mesh.solids.parts = {7};
  mesh.thick_shells.ids = {21};
  mesh.thick_shells.nodes = {{7, 6, 5, 4, 3, 2, 1, 0}};
  mesh.thick_shells.parts = {5};
  mesh.beams.ids = {31};
  mesh.beams.nodes = {{0, 8}};
  mesh.beams.parts = {5};
  mesh.shells.ids = {41, 40};
  mesh.shells.nodes = {{0, 1, 2, 3}, {4, 5, 6, 6}};
  mesh.shells.parts = {3, 3};
  return mesh;
}

/// Every value is another one, and none is lost in single precision.
D3plotState sample_state(double time) {
  D3plotState state;
  double next = 0.25 + time;
  const auto value = [&] { return next += 0.5; };
  state.time = time;
  for (double* one : {&state.kinetic, &state.internal, &state.total}) *one = value();
  for (double& v : state.velocity) v = value();
  state.parts.resize(parts.size());
  for (PartValues& part : state.parts) part = {value(), value(), value(), value(), {value(), value(), value()}};
  for (int i = 0; i < 9; ++i) {
    state.coordinates.push_back({value(), value(), value()});
    state.velocities.push_back({value(), value(), value()});
  }
  const auto point = [&] {
    StressPoint p;
    for (double& s : p.stress) s = value();
    p.plastic_strain = value();
    return p;
  };
  state.solids = {point()};
  state.beams = {{value(), value(), value(), value(), value(), value()}};
  for (int i = 0; i < 6; ++i) state.shell_points.push_back(point());
  state.shells.resize(2);
  for (ShellValues& shell : state.shells) {
    for (double& r : shell.resultants) r = value();
    shell.thickness = value();
    shell.internal_energy = value();
  }
  return state;
}

void expect_equal(const StressPoint& a, const StressPoint& b) {
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(a.plastic_strain, b.plastic_strain);
}

void expect_equal(const D3plotState& a, const D3plotState& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.kinetic, b.kinetic);
  EXPECT_EQ(a.internal, b.internal);
  EXPECT_EQ(a.total, b.total);
  EXPECT_EQ(a.velocity, b.velocity);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    EXPECT_EQ(a.parts[i].internal, b.parts[i].internal);
    EXPECT_EQ(a.parts[i].kinetic, b.parts[i].kinetic);
    EXPECT_EQ(a.parts[i].mass, b.parts[i].mass);
    EXPECT_EQ(a.parts[i].hourglass, b.parts[i].hourglass);
    EXPECT_EQ(a.parts[i].velocity, b.parts[i].velocity);
  }
  EXPECT_EQ(a.coordinates, b.coordinates);
  EXPECT_EQ(a.velocities, b.velocities);
  ASSERT_EQ(a.solids.size(), b.solids.size());
  for (std::size_t i = 0; i < a.solids.size(); ++i) expect_equal(a.solids[i], b.solids[i]);
  EXPECT_EQ(a.beams, b.beams);
  ASSERT_EQ(a.layers, b.layers);
  ASSERT_EQ(a.shell_points.size(), b.shell_points.size());
  for (std::size_t i = 0; i < a.shell_points.size(); ++i) expect_equal(a.shell_points[i], b.shell_points[i]);
  ASSERT_EQ(a.shells.size(), b.shells.size());
  for (std::size_t i = 0; i < a.shells.size(); ++i) {
    EXPECT_EQ(a.shells[i].resultants, b.shells[i].resultants);
    EXPECT_EQ(a.shells[i].thickness, b.shells[i].thickness);
    EXPECT_EQ(a.shells[i].internal_energy, b.shells[i].internal_energy);
  }
}

void write(const std::string& path, std::size_t states, const D3plotWriteSettings& settings) {
  auto writer = D3plotWriter::create(path, sample_mesh(), parts, settings);
  ASSERT_TRUE(writer.ok()) << (writer.ok() ? "" : writer.error().message);
  for (std::size_t i = 0; i < states; ++i) {
    const Status appended = writer.value().append(sample_state(static_cast<double>(i)));
    ASSERT_TRUE(appended.ok()) << appended.error().message;
  }
}

// A table of deleted elements behind each state (MDLOPT = 2).
TEST_F(D3plotFamily, DeletedElements) {
  D3plotState state = sample_state(1);
  state.deleted_solids = {true};
  state.deleted_shells = {false, true};
  state.deleted_beams = {true};
  D3plotWriteSettings settings;
  auto plain = D3plotWriter::create(path(), sample_mesh(), parts, settings);
  ASSERT_TRUE(plain.ok());
  EXPECT_FALSE(plain.value().append(state).ok());
  settings.deletion = true;
  for (const int word_bytes : {4, 8}) {
    settings.word_bytes = word_bytes;
    auto writer = D3plotWriter::create(path(), sample_mesh(), parts, settings);
    ASSERT_TRUE(writer.ok());
    ASSERT_TRUE(writer.value().append(sample_state(0)).ok());
    ASSERT_TRUE(writer.value().append(state).ok());
    const auto read = D3plotStates::open(path());
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read.value().size(), 2u);
    EXPECT_EQ(read.value().read(0).deleted_solids, std::vector<bool>{false});
    EXPECT_EQ(read.value().read(0).deleted_shells, (std::vector<bool>{false, false}));
    const D3plotState back = read.value().read(1);
    expect_equal(back, state);
    EXPECT_EQ(back.deleted_solids, state.deleted_solids);
    EXPECT_EQ(back.deleted_shells, state.deleted_shells);
    EXPECT_EQ(back.deleted_beams, state.deleted_beams);
  }
  state.deleted_shells = {true};
  auto writer = D3plotWriter::create(path(), sample_mesh(), parts, settings);
  ASSERT_TRUE(writer.ok());
  EXPECT_FALSE(writer.value().append(state).ok());
}

TEST_F(D3plotFamily, WhatIsWrittenIsRead) {
  for (const int word_bytes : {4, 8})
    for (const std::uint64_t member_words : {1u, 512u, 1u << 20}) {
      SCOPED_TRACE(testing::Message() << word_bytes << " " << member_words);
      ASSERT_NO_FATAL_FAILURE(write(path(), 5, {word_bytes, member_words}));
      const auto read = D3plotStates::open(path());
      ASSERT_TRUE(read.ok()) << read.error().message;
      const D3plot& mesh = read.value().mesh();
      const D3plot wanted = sample_mesh();
      EXPECT_EQ(mesh.title, wanted.title);
      EXPECT_EQ(mesh.word_bytes, word_bytes);
      EXPECT_EQ(mesh.node_ids, wanted.node_ids);
      EXPECT_EQ(mesh.coordinates, wanted.coordinates);
      EXPECT_EQ(mesh.solids.ids, wanted.solids.ids);
      EXPECT_EQ(mesh.solids.nodes, wanted.solids.nodes);
      EXPECT_EQ(mesh.solids.parts, wanted.solids.parts);
      EXPECT_EQ(mesh.thick_shells.parts, wanted.thick_shells.parts);
      EXPECT_EQ(mesh.beams.nodes, wanted.beams.nodes);
      EXPECT_EQ(mesh.beams.parts, wanted.beams.parts);
      EXPECT_EQ(mesh.shells.ids, wanted.shells.ids);
      EXPECT_EQ(mesh.shells.nodes, wanted.shells.nodes);
      EXPECT_EQ(mesh.shells.parts, wanted.shells.parts);
      ASSERT_EQ(read.value().size(), 5u);
      for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(read.value().times()[i], static_cast<double>(i));
        expect_equal(read.value().read(i), sample_state(static_cast<double>(i)));
      }
      const bool one_each = member_words == 1;
      EXPECT_EQ(fs::exists(path() + "05"), one_each);
      EXPECT_EQ(fs::exists(path() + "02"), member_words < 1000);
      EXPECT_EQ(fs::file_size(path() + "01") % (512 * static_cast<std::size_t>(word_bytes)), 0u);
    }
}

TEST_F(D3plotFamily, AnOlderFamilyIsRemoved) {
  write(path(), 5, {4, 1});
  EXPECT_TRUE(fs::exists(path() + "05"));
  write(path(), 2, {4, 1});
  EXPECT_FALSE(fs::exists(path() + "03"));
  EXPECT_EQ(D3plotStates::open(path()).value().size(), 2u);
}

TEST_F(D3plotFamily, LongIdsTakeWideWords) {
  D3plot mesh = sample_mesh();
  mesh.shells.ids[0] = 5'000'000'000;
  auto writer = D3plotWriter::create(path(), mesh, parts);
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer.value().append(sample_state(0)).ok());
  const auto read = D3plotStates::open(path());
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value().mesh().word_bytes, 8);
  EXPECT_EQ(read.value().mesh().shells.ids[0], 5'000'000'000);
}

TEST_F(D3plotFamily, NumbersBeyondSinglePrecisionAreItsEnds) {
  auto writer = D3plotWriter::create(path(), sample_mesh(), parts);
  ASSERT_TRUE(writer.ok());
  D3plotState state = sample_state(0);
  state.coordinates[2] = {1e300, -1e300, std::nan("")};
  ASSERT_TRUE(writer.value().append(state).ok());
  const auto x = D3plotStates::open(path()).value().read(0).coordinates[2];
  EXPECT_EQ(x[0], static_cast<double>(std::numeric_limits<float>::max()));
  EXPECT_EQ(x[1], -x[0]);
  EXPECT_TRUE(std::isnan(x[2]));
}

TEST_F(D3plotFamily, WrongSizesAndPlacesAreTold) {
  D3plot mesh = sample_mesh();
  mesh.shells.parts[0] = 99;
  EXPECT_FALSE(D3plotWriter::create(path(), mesh, parts).ok());
  EXPECT_FALSE(D3plotWriter::create((folder_ / "none" / "d3plot").string(), sample_mesh(), parts).ok());
  auto writer = D3plotWriter::create(path(), sample_mesh(), parts);
  ASSERT_TRUE(writer.ok());
  D3plotState state = sample_state(0);
  state.velocities.pop_back();
  EXPECT_FALSE(writer.value().append(state).ok());
}

TEST_F(D3plotFamily, StatesMayFollowInTheFirstFile) {
  write(path(), 2, {4, 1u << 20});
  std::string all = contents(path());
  all.resize(4 * D3plotStates::open(path()).value().mesh().geometry_words);
  std::ofstream(path(), std::ios::binary) << all << contents(path() + "01");
  fs::remove(path() + "01");
  const auto read = D3plotStates::open(path());
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read.value().size(), 2u);
  expect_equal(read.value().read(1), sample_state(1));
}

TEST_F(D3plotFamily, AStateThatIsCutOffIsNone) {
  write(path(), 3, {4, 1u << 20});
  const std::string states = contents(path() + "01");
  const std::size_t full = states.size();
  // Time, six global values and seven of each of three parts; nine nodes; a solid, a thick shell and two shells of
  // three layers, and a beam.
  constexpr std::size_t state = 4 * (1 + 6 + 7 * 3 + 9 * 6 + 7 + 3 * 7 + 6 + 2 * (3 * 7 + 8 + 4));
  for (std::size_t size = full; size > 0; size -= std::min<std::size_t>(size, 100)) {
    std::ofstream(path() + "01", std::ios::binary) << states.substr(0, size);
    const auto read = D3plotStates::open(path());
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read.value().size(), std::min<std::size_t>(size / state, 3)) << size << " of " << full;
    for (std::size_t i = 0; i < read.value().size(); ++i)
      expect_equal(read.value().read(i), sample_state(static_cast<double>(i)));
  }
}

// Random control words: no crash, no memory beyond what the files can fill.
TEST_F(D3plotFamily, DamagedControlWords) {
  write(path(), 2, {4, 1u << 20});
  const std::string good = contents(path());
  std::mt19937 random(5);
  std::size_t read_states = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string bad = good;
    for (int change = 0; change < 1 + trial % 3; ++change) {
      const std::size_t word = 11 + random() % 53;
      const auto value = static_cast<std::int32_t>(trial % 2 == 0 ? random() % 200 : random());
      std::memcpy(bad.data() + 4 * word, &value, 4);
    }
    std::ofstream(path(), std::ios::binary) << bad;
    const auto states = D3plotStates::open(path());
    if (!states.ok()) continue;
    for (std::size_t i = 0; i < states.value().size() && i < 3; ++i) {
      const D3plotState state = states.value().read(i);
      EXPECT_LE(state.shell_points.size(), 6u);
      ++read_states;
    }
  }
  EXPECT_GT(read_states, 50u);
}

fs::path real(const std::string& name) { return fs::path(GAPCHECK_ROOT) / ".." / "shared" / "decks" / name; }

TEST(RealD3plot, StatesOfAnImpact) {
  const fs::path path = real("d3plot_examples/result_files/d3plot_projectile/d3plot");
  if (!fs::exists(path)) GTEST_SKIP() << "no real result files here";
  const auto plot = D3plotStates::open(path.string());
  ASSERT_TRUE(plot.ok()) << plot.error().message;
  ASSERT_EQ(plot.value().size(), 4u);
  const D3plotState first = plot.value().read(0), later = plot.value().read(3);
  EXPECT_EQ(first.coordinates, plot.value().mesh().coordinates);
  EXPECT_NEAR(first.kinetic, 0.27597541, 1e-8);
  EXPECT_NEAR(plot.value().times()[1], 4.976857, 1e-6);
  ASSERT_EQ(first.parts.size(), 2u);
  EXPECT_NEAR(first.parts[0].kinetic + first.parts[1].kinetic, first.kinetic, 1e-6);
  EXPECT_NEAR(later.parts[0].internal + later.parts[1].internal, later.internal, 1e-3 * later.internal);
  // Plastic strain grows, and nodes move about as far as their velocities say.
  double strain = 0;
  for (const StressPoint& solid : later.solids) strain = std::max(strain, solid.plastic_strain);
  EXPECT_GT(strain, 0.05);
  EXPECT_LT(strain, 2);
  const D3plotState second = plot.value().read(1);
  const double step = second.time - first.time;
  std::size_t close = 0;
  for (std::size_t i = 0; i < first.coordinates.size(); ++i) {
    const double way = second.coordinates[i][2] - first.coordinates[i][2];
    const double mean = (second.velocities[i][2] + first.velocities[i][2]) / 2;
    if (std::abs(way - mean * step) < 0.05) ++close;
  }
  EXPECT_GT(close, first.coordinates.size() * 9 / 10);
}

TEST(RealD3plot, StatesOfShells) {
  for (const char* name :
       {"d3plot_lasso/test/test_data/d3plot_solid_int/d3plot", "d3plot_lasso/test/test_data/simple_d3plot/d3plot",
        "d3plot_examples/result_files/d3plot_beam/d3plot"}) {
    const fs::path path = real(name);
    if (!fs::exists(path)) GTEST_SKIP() << "no real result files here";
    SCOPED_TRACE(name);
    const auto plot = D3plotStates::open(path.string());
    ASSERT_TRUE(plot.ok()) << plot.error().message;
    ASSERT_GE(plot.value().size(), 1u);
    const D3plotState state = plot.value().read(0);
    EXPECT_EQ(state.time, 0);
    for (std::size_t i = 0; i < state.coordinates.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(state.coordinates[i][k], plot.value().mesh().coordinates[i][k], 1e-3);
    for (std::size_t i = 1; i < plot.value().size(); ++i)
      EXPECT_GT(plot.value().times()[i], plot.value().times()[i - 1]);
    EXPECT_EQ(state.shells.empty(), std::string(name).find("d3plot_beam") != std::string::npos);
    for (const ShellValues& shell : state.shells) ASSERT_GT(shell.thickness, 0);
  }
}

}  // namespace
}  // namespace gapcheck::results::d3plot_states_test
