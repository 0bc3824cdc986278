#include "results/d3plot/intfor.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "results/curves/run_results.hpp"
#include "results/d3plot/intfor_write.hpp"

namespace gapcheck::results::intfor_test {
namespace {

namespace fs = std::filesystem;

class IntforFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("gapcheck_intfor_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path() const { return (folder_ / "intfor").string(); }
  static std::string bytes_of(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write(const IntforWriteSettings& settings, int states);

  fs::path folder_;
};

/// A quad on side A of contact 80085, a quad and a triangle on side B of it, a quad of contact 7.
InterfaceMesh sample_mesh() {
  InterfaceMesh mesh;
  mesh.title = "interfaces";
  for (std::int64_t i = 1; i <= 6; ++i) {
    mesh.node_ids.push_back(10 * i);
    mesh.coordinates.push_back({static_cast<double>(i), 0.5, -static_cast<double>(i)});
  }
  mesh.surfaces = {{80085, 0, "lid"}, {80085, 1, "lid"}, {7, 0, ""}};
  mesh.segments = {{0, 1, 2, 3}, {2, 3, 4, 5}, {0, 1, 5, 5}, {3, 2, 1, 0}};
  mesh.surface_of = {0, 1, 1, 2};
  return mesh;
}

InterfaceForces sample_state(int number) {
  InterfaceForces state;
  state.time = 0.25 * number;
  float value = 100.0F * static_cast<float>(number);  // float: as the file keeps it
  const auto next = [&] { return static_cast<double>(value += 0.5F); };
  for (int i = 0; i < 6; ++i) {
    state.coordinates.push_back({next(), next(), next()});
    state.velocities.push_back({next(), next(), next()});
  }
  for (int i = 0; i < 4; ++i) {
    SegmentForce& segment = state.segments.emplace_back();
    segment = {next(), next(), next(), next(), {}};
    for (auto& corner : segment.force) corner = {next(), next(), next()};
  }
  return state;
}

void IntforFile::write(const IntforWriteSettings& settings, int states) {
  auto writer = IntforWriter::create(path(), sample_mesh(), settings);
  ASSERT_TRUE(writer) << writer.error().message;
  for (int i = 0; i < states; ++i) ASSERT_TRUE(writer.value().append(sample_state(i)).ok());
  EXPECT_TRUE(writer.value().check_names().ok());
}

// Words: 64 of control, 6 nodes, 4 segments, numbering, titles; then 1 + 6 + 7 * 3 + 2 * 18 + 4 * 16 by state.
TEST_F(IntforFile, EveryNumberComesBack) {
  for (const int word_bytes : {4, 8})
    for (const std::uint64_t member_words : {std::uint64_t{1'000'000}, std::uint64_t{300}}) {
      write({word_bytes, member_words}, 5);
      const auto intfor = Intfor::open(path());
      ASSERT_TRUE(intfor) << intfor.error().message;
      const InterfaceMesh written = sample_mesh(), &mesh = intfor.value().mesh();
      EXPECT_EQ(mesh.title, written.title);
      EXPECT_EQ(mesh.node_ids, written.node_ids);
      EXPECT_EQ(mesh.coordinates, written.coordinates);
      EXPECT_EQ(mesh.segments, written.segments);
      EXPECT_EQ(mesh.surface_of, written.surface_of);
      ASSERT_EQ(mesh.surfaces.size(), 3u);
      EXPECT_EQ(mesh.surfaces[1].contact, 80085);
      EXPECT_EQ(mesh.surfaces[1].side, 1u);
      EXPECT_EQ(mesh.surfaces[1].title, "lid");
      EXPECT_EQ(mesh.surfaces[2].contact, 7);
      ASSERT_EQ(intfor.value().times().size(), 5u);
      EXPECT_TRUE(intfor.value().has_forces());
      for (std::size_t i = 0; i < 5; ++i) {
        const InterfaceForces state = intfor.value().read(i), expected = sample_state(static_cast<int>(i));
        EXPECT_EQ(state.time, expected.time);
        EXPECT_EQ(state.coordinates, expected.coordinates);
        EXPECT_EQ(state.velocities, expected.velocities);
        ASSERT_EQ(state.segments.size(), 4u);
        for (std::size_t k = 0; k < 4; ++k) {
          EXPECT_EQ(state.segments[k].pressure, expected.segments[k].pressure);
          EXPECT_EQ(state.segments[k].shear, expected.segments[k].shear);
          EXPECT_EQ(state.segments[k].shear_r, expected.segments[k].shear_r);
          EXPECT_EQ(state.segments[k].shear_s, expected.segments[k].shear_s);
          EXPECT_EQ(state.segments[k].force, expected.segments[k].force);
        }
      }
      constexpr std::uintmax_t state_words = 1 + 6 + 7 * 3 + 2 * 18 + 4 * 16;
      const std::uintmax_t states_in_first = member_words == 300 ? 2 : 5;
      EXPECT_EQ(fs::file_size(path() + "01"),
                (states_in_first * state_words + 1 + 511) / 512 * 512 * static_cast<std::uintmax_t>(word_bytes));
    }
}

TEST_F(IntforFile, CurvesOfARun) {
  write({}, 3);
  Diagnostics diagnostics;
  const RunResults run = read_run_results(folder_.string(), true, diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty());
  ASSERT_EQ(run.intfor.surfaces.size(), 3u);
  EXPECT_EQ(run.intfor.surfaces[1].contact, 80085);
  EXPECT_EQ(run.intfor.surfaces[1].side, 1u);
  EXPECT_TRUE(run.intfor.forces);
  ASSERT_EQ(run.intfor.states.size(), 3u);
  const SurfaceForce& b = run.intfor.states[2].rows.at(1);
  const InterfaceForces state = sample_state(2);
  EXPECT_EQ(b.largest_pressure, std::max(state.segments[1].pressure, state.segments[2].pressure));
  double y = 0;
  for (const std::size_t segment : {1u, 2u})
    for (const auto& corner : state.segments[segment].force) y += corner[1];
  EXPECT_DOUBLE_EQ(b.force[1], y);
}

// Wrong databases, and any damage: an error or fewer states, never more than the file holds.
TEST_F(IntforFile, HostileFiles) {
  write({}, 3);
  const std::string whole = bytes_of(path());
  const auto opened = [&](const std::string& bytes) {
    std::ofstream(path(), std::ios::binary) << bytes;
    return Intfor::open(path());
  };
  EXPECT_FALSE(opened("").ok());
  std::string plot = whole;
  plot[11 * 4] = 1;
  const auto wrong = opened(plot);
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().message.find("type 1"), std::string::npos) << wrong.error().message;
  std::string narrow = whole;
  narrow[33 * 4] = 3;
  EXPECT_FALSE(opened(narrow).ok()) << "three values for a segment";
  for (std::size_t size = 1; size < 64 * 4 + 6 * 12 + 4 * 20; size += 7)
    EXPECT_FALSE(opened(whole.substr(0, size)).ok());
  std::mt19937 random(5);
  for (int scene = 0; scene < 300; ++scene) {
    std::string bytes = whole;
    for (int change = 0; change < 2; ++change)
      bytes[random() % std::min<std::size_t>(bytes.size(), 1200)] = static_cast<char>(random() % 256);
    SCOPED_TRACE(scene);
    const auto intfor = opened(bytes);
    const std::size_t states = intfor.ok() ? intfor.value().times().size() : 0;
    for (std::size_t i = 0; i < states; ++i)
      EXPECT_LE(surface_forces(intfor.value().mesh(), intfor.value().read(i)).size(), 4u);
  }
}

TEST_F(IntforFile, WhatCannotBeWritten) {
  InterfaceMesh empty = sample_mesh();
  empty.segments.clear();
  EXPECT_FALSE(IntforWriter::create(path(), empty).ok());
  auto writer = IntforWriter::create(path(), sample_mesh());
  ASSERT_TRUE(writer);
  InterfaceForces other = sample_state(1);
  other.segments.pop_back();
  EXPECT_FALSE(writer.value().append(other).ok());
  EXPECT_FALSE(IntforWriter::create((folder_ / "none" / "intfor").string(), sample_mesh()).ok());
}

TEST(SurfaceTitle, NamesContactAndSide) {
  for (const InterfaceSurface& surface : {InterfaceSurface{3, 0, "lid"}, {80086, 1, ""}, {1, 1, "a: b"}}) {
    const InterfaceSurface back = surface_of_title(surface_title(surface));
    EXPECT_EQ(back.contact, surface.contact);
    EXPECT_EQ(back.side, surface.side);
    EXPECT_EQ(back.title, surface.title);
  }
  for (const char* other : {"", "contact", "contact x side A", "contact 3", "contact 3 side C", "contact 3 side "})
    EXPECT_EQ(surface_of_title(other).contact, 0) << other;
}

}  // namespace
}  // namespace gapcheck::results::intfor_test
