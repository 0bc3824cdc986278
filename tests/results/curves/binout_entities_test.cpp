#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "results/curves/run_results.hpp"
#include "results/curves/sample_lsda.hpp"

namespace gapcheck::results::binout_entities_test {
namespace {

namespace fs = std::filesystem;
using Type = LsdaArray::Type;

class BinoutEntities : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("gapcheck_binout_entities_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::vector<EntityHistory> read(const SampleLsda& file) {
    std::ofstream(folder_ / "binout0000", std::ios::binary) << file.bytes;
    Diagnostics diagnostics;
    const RunResults run = read_run_results(folder_.string(), true, diagnostics);
    said_.clear();
    for (const Diagnostic& diagnostic : diagnostics.sorted()) said_ += diagnostic.message + "\n";
    return run.entities;
  }

  fs::path folder_;
  std::string said_;
};

/// The value of a column by its name, in the last state of the only history of a file and kind.
double last(const std::vector<EntityHistory>& histories, const std::string& file, const std::string& kind,
            std::int64_t id, const std::string& name) {
  for (const EntityHistory& history : histories)
    for (std::size_t k = 0; k < history.columns.size(); ++k)
      if (history.file == file && history.kind == kind && history.columns[k].name == name)
        for (std::size_t i = 0; i < history.states.back().ids.size(); ++i)
          if (history.states.back().ids[i] == id) return history.states.back().values[i * history.columns.size() + k];
  ADD_FAILURE() << file << ' ' << kind << ' ' << id << ' ' << name << " is not there";
  return -1;
}

// The directories and names of each file as LS-DYNA's own translator of binouts reads them; in both byte orders.
TEST_F(BinoutEntities, OfAllFiles) {
  for (const bool swapped : {false, true}) {
    SampleLsda file(swapped);
    const auto metadata = [&](const std::string& branch, const std::string& name, std::vector<std::int32_t> ids) {
      file.change("/" + branch + "/metadata");
      file.array<std::int32_t>(name, Type::int32, ids);
    };
    double value = 0;
    const auto state = [&](const std::string& branch, std::size_t count, const std::vector<std::string>& names) {
      file.change("/" + branch + "/d000001");
      file.array<double>("time", Type::float64, {0.5});
      for (const std::string& name : names) {
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) values.push_back(++value);
        file.array<double>(name, Type::float64, values);
      }
    };
    metadata("secforc", "ids", {4, 9});
    state("secforc", 2, {"x_force", "y_force", "z_force", "total_force", "x_moment", "area"});  // 1 … 12
    metadata("spcforc", "force_ids", {7});
    file.array<std::int32_t>("moment_ids", Type::int32, {7, 8});
    state("spcforc", 1, {"x_force", "y_force", "z_force"});  // 13, 14, 15
    file.array<double>("x_moment", Type::float64, {100, 101});
    file.array<double>("x_resultant", Type::float64, {200});
    file.change("misc");
    file.array<double>("x_moment0", Type::float64, {0});
    metadata("bndout/velocity/nodes", "ids", {30});
    state("bndout/velocity/nodes", 1, {"x_force", "y_force", "z_force", "energy"});  // 16 … 19
    metadata("bndout/discrete/rigidbodies", "ids", {31});
    state("bndout/discrete/rigidbodies", 1, {"xforce", "yforce", "zforce", "energy"});  // 20 … 23
    metadata("rwforc/forces", "ids", {1, 2});
    state("rwforc/forces", 2, {"normal_force", "x_force"});  // 24 … 27
    metadata("rbdout", "ids", {5});
    state("rbdout", 1, {"global_x", "global_dz", "global_rdy"});  // 28, 29, 30
    metadata("swforc", "ids", {6, 6, 9});
    file.array<std::int32_t>("types", Type::int32, {2, 3, 2});
    state("swforc", 3, {"axial", "shear", "failure_time"});  // 31 … 39
    file.change("/elout/beam/d000001");
    file.array<double>("time", Type::float64, {0.5});
    file.array<std::int32_t>("ids", Type::int32, {60});
    file.array<double>("axial", Type::float64, {40});
    file.change("/elout/shell/d000001");
    file.array<double>("time", Type::float64, {0.5});
    file.array<std::int32_t>("ids", Type::int32, {70, 71});
    file.array<double>("sig_xx", Type::float64, {1, 2, 3, 4});  // two layers of either
    metadata("deforc", "ids", {80});
    state("deforc", 1, {"resultant_force"});  // 40

    const std::vector<EntityHistory> found = read(file);
    EXPECT_EQ(said_, "");
    EXPECT_EQ(last(found, "secforc", "section", 9, "x-force"), 2);
    EXPECT_DOUBLE_EQ(last(found, "secforc", "section", 4, "resultant force"), std::hypot(1, 3, 5));
    EXPECT_EQ(last(found, "secforc", "section", 9, "x-moment"), 10);
    EXPECT_EQ(last(found, "spcforc", "node", 7, "z-force"), 15);
    EXPECT_DOUBLE_EQ(last(found, "spcforc", "node", 7, "resultant force"), std::hypot(13, 14, 15));
    EXPECT_EQ(last(found, "spcforc", "node", 8, "x-moment"), 101);
    EXPECT_EQ(last(found, "spcforc", "all nodes", 0, "x-force"), 200);
    EXPECT_EQ(last(found, "bndout", "velocity node", 30, "energy"), 19);
    EXPECT_EQ(last(found, "bndout", "discrete body", 31, "y-force"), 21);
    EXPECT_DOUBLE_EQ(last(found, "bndout", "discrete body", 31, "resultant force"), std::hypot(20, 21, 22));
    EXPECT_EQ(last(found, "rwforc", "wall", 2, "normal force"), 25);
    EXPECT_EQ(last(found, "rbdout", "body", 5, "z-displacement"), 29);
    EXPECT_EQ(last(found, "rbdout", "body", 5, "y-rotation"), 30);
    EXPECT_EQ(last(found, "swforc", "spotweld beam", 6, "axial force"), 31);
    EXPECT_EQ(last(found, "swforc", "spotweld solid", 6, "axial force"), 32);
    EXPECT_EQ(last(found, "swforc", "spotweld beam", 9, "shear force"), 36);
    EXPECT_EQ(last(found, "elout", "beam", 60, "axial force"), 40);
    EXPECT_EQ(last(found, "elout", "shell", 70, "point 2 xx-stress"), 2);
    EXPECT_EQ(last(found, "elout", "shell", 71, "point 1 xx-stress"), 3);
    EXPECT_EQ(last(found, "deforc", "spring", 80, "resultant force"), 40);
  }
}

// The text file comes first, as for all other files.
TEST_F(BinoutEntities, NotBesideATextFile) {
  SampleLsda file;
  file.change("/rwforc/forces/metadata");
  file.array<std::int32_t>("ids", Type::int32, {1});
  file.change("/rwforc/forces/d000001");
  file.array<double>("time", Type::float64, {0.5});
  file.array<double>("normal_force", Type::float64, {4});
  EXPECT_EQ(read(file).size(), 1u);
  std::ofstream(folder_ / "rwforc") << "\n";
  EXPECT_TRUE(read(file).empty());
}

// Ids of nothing, values of nobody, a state without its time, one that has lost a column.
TEST_F(BinoutEntities, HostileStates) {
  SampleLsda file;
  file.change("/secforc/metadata");
  file.array<std::int8_t>("ids", Type::int8, std::vector<std::int8_t>(100'000, 1));
  for (int state = 0; state < 2000; ++state) {
    file.change("/secforc/d" + std::to_string(state));
    file.array<double>("time", Type::float64, {1.0});
    file.array<double>("x_force", Type::float64, {1.0});
  }
  file.change("/rwforc/forces/d000001");
  file.array<double>("x_force", Type::float64, {1.0});
  file.change("/rwforc/forces/metadata");
  file.array<std::int32_t>("ids", Type::int32, {1});
  for (const bool whole : {true, false}) {
    file.change(whole ? "/rwforc/forces/d000002" : "/rwforc/forces/d000003");
    file.array<double>("time", Type::float64, {2.0});
    file.array<double>("x_force", Type::float64, {1.0});
    if (whole) file.array<double>("y_force", Type::float64, {1.0});
  }
  const std::vector<EntityHistory> found = read(file);
  EXPECT_NE(said_.find("2002 states"), std::string::npos) << said_;
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].states.size(), 1u);
  EXPECT_EQ(found[0].states[0].time, 2);
}

}  // namespace
}  // namespace gapcheck::results::binout_entities_test
