#include "results/curves/binout.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>

#include "results/curves/lsda.hpp"
#include "results/curves/sample_lsda.hpp"

namespace gapcheck::results::binout_test {
namespace {

namespace fs = std::filesystem;
using Type = LsdaArray::Type;

class Binout : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("gapcheck_binout_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  RunResults read(const std::string& bytes, bool nodes = true) {
    std::ofstream(folder_ / "binout0000", std::ios::binary) << bytes;
    diagnostics_ = std::make_unique<Diagnostics>();
    return read_run_results(folder_.string(), nodes, *diagnostics_);
  }
  std::string said() {
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics_->sorted()) all += diagnostic.message + "\n";
    return all;
  }

  fs::path folder_;
  std::unique_ptr<Diagnostics> diagnostics_ = std::make_unique<Diagnostics>();
};

void write_rcforc(SampleLsda& file) {
  file.change("/rcforc/metadata");
  file.array<std::int64_t>("ids", Type::int64, {3, 3, 8});
  file.array<std::int64_t>("side", Type::int64, {0, 1, 0});
  for (int state = 1; state <= 2; ++state) {
    file.change("/rcforc/d00000" + std::to_string(state));
    file.array<float>("time", Type::float32, {0.5F * static_cast<float>(state)});
    file.array<float>("x_force", Type::float32, {1.0F * static_cast<float>(state), -1, 7});
    file.array<double>("y_force", Type::float64, {2, -2, 8});
    file.array<double>("z_force", Type::float64, {3, -3, 9});
    file.array<double>("z_moment", Type::float64, {5, -5, 0});
  }
}

TEST_F(Binout, ForcesOfBothSidesInEveryForm) {
  for (const bool swapped : {false, true})
    for (const std::size_t length_bytes : {4u, 8u})
      for (const std::size_t command_bytes : {1u, 4u}) {
        SampleLsda file(swapped, length_bytes, command_bytes);
        file.record(7, std::string(8, '\0'));  // where the symbol table is
        write_rcforc(file);
        file.record(5, std::string(20, 'x'));
        const RunResults run = read(file.bytes);
        EXPECT_EQ(said(), "");
        ASSERT_EQ(run.rcforc.states.size(), 2u);
        const InterfaceStates& state = run.rcforc.states[1];
        EXPECT_EQ(state.time, 1);
        ASSERT_EQ(state.contacts.size(), 2u);
        EXPECT_EQ(state.contacts[0].contact, 3);
        EXPECT_EQ(state.contacts[0].force[0], Vector(2, 2, 3));
        EXPECT_EQ(state.contacts[0].force[1], Vector(-1, -2, -3));
        EXPECT_EQ(state.contacts[0].moment[1], Vector(0, 0, -5));
        EXPECT_EQ(state.contacts[1].force[0], Vector(7, 8, 9));
        EXPECT_EQ(std::count(run.missing.begin(), run.missing.end(), "rcforc"), 0);
        EXPECT_EQ(std::count(run.missing.begin(), run.missing.end(), "glstat"), 1);
      }
}

TEST_F(Binout, EnergiesAndNodesWithOldAndNewWords) {
  for (const auto& [a, b] : {std::pair("slave", "master"), {"surfa", "surfb"}}) {
    SampleLsda file;
    file.change("/sleout/metadata");
    file.array<std::int32_t>("ids", Type::int32, {11, 12});
    file.change("../d000001");
    file.array<double>("time", Type::float64, {0.25});
    file.array<double>(a, Type::float64, {1, 2});
    file.array<double>(b, Type::float64, {3, 4});
    file.array<double>("friction_energy", Type::float64, {5, 6});
    file.change("/nodout/metadata");
    file.array<std::int64_t>("ids", Type::int64, {70, 5'000'000'000});
    file.change("/nodout/d000001");
    file.array<double>("time", Type::float64, {0.25});
    for (const char* name : {"x_displacement", "y_displacement", "z_displacement", "x_velocity", "rz_displacement"})
      file.array<double>(name, Type::float64, {static_cast<double>(name[0]), static_cast<double>(name[1])});
    const RunResults run = read(file.bytes);
    EXPECT_EQ(said(), "");
    ASSERT_EQ(run.sleout.states.size(), 1u);
    EXPECT_EQ(run.sleout.states[0].contacts[1].energy, (std::array<double, 2>{2, 4}));
    EXPECT_EQ(run.sleout.states[0].contacts[1].friction, 6);
    ASSERT_EQ(run.nodout.states.size(), 1u);
    const NodeState& node = run.nodout.states[0].nodes[1];
    EXPECT_EQ(node.node, 5'000'000'000);
    EXPECT_EQ(node.displacement, Vector('_', '_', '_'));
    EXPECT_EQ(node.velocity, Vector('_', 0, 0));
    EXPECT_EQ(node.rotation, Vector(0, 0, 'z'));
    EXPECT_TRUE(read(file.bytes, false).nodout.states.empty());
  }
}

TEST_F(Binout, TextFilesComeFirst) {
  SampleLsda file;
  write_rcforc(file);
  std::ofstream(folder_ / "rcforc") << "\n";
  EXPECT_TRUE(read(file.bytes).rcforc.states.empty());
}

TEST_F(Binout, IncompleteStatesAreCounted) {
  SampleLsda file;
  write_rcforc(file);
  file.change("/rcforc/d000003");
  file.array<double>("time", Type::float64, {3});
  file.array<double>("x_force", Type::float64, {1, 2});
  file.change("/rcforc/d000004");
  file.array<double>("x_force", Type::float64, {1, 2, 3});
  EXPECT_EQ(read(file.bytes).rcforc.states.size(), 2u);
  EXPECT_NE(said().find("2 states without"), std::string::npos) << said();
}

// A few bytes of ids must not ask for the memory of as many nodes in each of many tiny states.
TEST_F(Binout, AStateHasNoMoreNodesThanValues) {
  SampleLsda file;
  file.change("/nodout/metadata");
  file.array<std::int8_t>("ids", Type::int8, std::vector<std::int8_t>(100'000, 1));
  for (int state = 0; state < 10'000; ++state) {
    file.change("/nodout/d" + std::to_string(state));
    file.array<double>("time", Type::float64, {1.0});
  }
  EXPECT_TRUE(read(file.bytes).nodout.states.empty());
  EXPECT_NE(said().find("10000 states"), std::string::npos) << said();
}

TEST_F(Binout, WhatIsNoBinout) {
  for (const std::string& bytes :
       {std::string(), std::string("text"), std::string(64, '\0'), std::string("\x08\x03\x08\x01\x01\x01\0\0", 8)}) {
    EXPECT_EQ(read(bytes).missing.size(), 5u);
    EXPECT_NE(said().find("not a binout"), std::string::npos) << said();
  }
}

TEST_F(Binout, CutOffAnywhereAndDamagedAnyhow) {
  SampleLsda file;
  write_rcforc(file);
  const auto states = [](const std::string& bytes, Diagnostics& diagnostics) {
    std::size_t times = 0;
    EXPECT_TRUE(read_lsda(
                    bytes, "binout", [&](const LsdaArray& array) { times += array.name() == "time"; }, diagnostics)
                    .ok());
    return times;
  };
  std::size_t warned = 0;
  for (std::size_t size = 8; size < file.bytes.size(); ++size) {
    Diagnostics diagnostics;
    EXPECT_LE(states(file.bytes.substr(0, size), diagnostics), 2u);
    warned += diagnostics.sorted().size();
  }
  EXPECT_GT(warned, file.bytes.size() - 40) << "all but the cuts between records";
  std::mt19937 random(3);
  for (int scene = 0; scene < 400; ++scene) {
    std::string bytes = file.bytes;
    for (int change = 0; change < 3; ++change)
      bytes[8 + random() % (bytes.size() - 8)] = static_cast<char>(random() % 256);
    SCOPED_TRACE(scene);
    read(bytes);
  }
}

// The same run as text and as binout: every number of the text is the binout's, rounded to what is printed.
TEST_F(Binout, AgreesWithTheTextFilesOfAPublishedRun) {
  const fs::path published = fs::path(GAPCHECK_ROOT) / "../shared/decks/tied_plate_with_run";
  if (!fs::exists(published / "binout")) GTEST_SKIP() << "no decks beside the project";
  fs::copy(published / "binout", folder_ / "binout");
  const RunResults binary = read_run_results(folder_.string(), true, *diagnostics_);
  const RunResults text = read_run_results(published.string(), true, *diagnostics_);
  EXPECT_EQ(said(), "");
  const auto same = [](double printed, double value) {
    return std::abs(printed - value) <= 0.6e-5 * std::abs(value) + 1e-30;
  };
  ASSERT_FALSE(text.glstat.empty());
  ASSERT_GE(binary.glstat.size(), text.glstat.size());
  for (std::size_t i = 0; i < text.glstat.size(); ++i) {
    const GlobalState &a = text.glstat[i], &b = binary.glstat[i];
    for (const auto member :
         {&GlobalState::time, &GlobalState::time_step, &GlobalState::kinetic, &GlobalState::internal,
          &GlobalState::sliding, &GlobalState::external, &GlobalState::total, &GlobalState::ratio})
      EXPECT_TRUE(same(a.*member, b.*member)) << i << ": " << a.*member << ' ' << b.*member;
    EXPECT_EQ(a.cycle, b.cycle);
  }
  ASSERT_FALSE(text.rcforc.states.empty());
  ASSERT_GE(binary.rcforc.states.size(), text.rcforc.states.size());
  for (std::size_t i = 0; i < text.rcforc.states.size(); ++i) {
    const auto &a = text.rcforc.states[i].contacts, &b = binary.rcforc.states[i].contacts;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].contact, b[k].contact);
      for (const std::size_t side : {0u, 1u})
        for (const Eigen::Index axis : {0, 1, 2})
          EXPECT_TRUE(same(a[k].force[side][axis], b[k].force[side][axis])) << i << ' ' << k;
    }
  }
  ASSERT_FALSE(text.matsum.states.empty());
  for (std::size_t k = 0; k < text.matsum.states[0].parts.size(); ++k)
    EXPECT_TRUE(same(text.matsum.states.back().parts[k].internal,
                     binary.matsum.states[text.matsum.states.size() - 1].parts[k].internal));
}

}  // namespace
}  // namespace gapcheck::results::binout_test
