#include <gtest/gtest.h>

#include <fstream>

#include "results/curves/binout_folder.hpp"
#include "results/curves/sample_lsda.hpp"

namespace gapcheck::results::binout_histories_test {
namespace {

using Type = LsdaArray::Type;

class BinoutHistories : public BinoutFolder {
 protected:
  RunResults read(const SampleLsda& file) {
    std::ofstream(path(), std::ios::binary) << file.bytes;
    return read_folder();
  }
};

/// The rows of the only state.
template <class Row>
std::vector<Row> rows(const History<Row>& history) {
  EXPECT_EQ(history.states.size(), 1u);
  return history.states.empty() ? std::vector<Row>(9) : history.states[0].rows;
}

// The directories and names of each file as LS-DYNA's own translator of binouts reads them; in both byte orders.
TEST_F(BinoutHistories, OfAllFiles) {
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
    file.array<std::int32_t>("moment_ids", Type::int32, {7, 5});
    state("spcforc", 1, {"x_force", "y_force", "z_force"});  // 13, 14, 15
    for (const char* name : {"x_moment", "y_moment", "z_moment"}) file.array<double>(name, Type::float64, {100, 101});
    file.array<double>("x_resultant", Type::float64, {200});
    file.change("misc");
    file.array<double>("x_moment0", Type::float64, {0});
    metadata("bndout/velocity/nodes", "ids", {30});
    state("bndout/velocity/nodes", 1, {"x_force", "y_force", "z_force", "energy"});  // 16 … 19
    metadata("bndout/discrete/rigidbodies", "ids", {31});
    state("bndout/discrete/rigidbodies", 1, {"xforce", "yforce", "zforce", "energy"});  // 20 … 23
    metadata("rwforc/forces", "ids", {1, 2});
    file.array<std::int32_t>("setid", Type::int32, {11, 12});
    state("rwforc/forces", 2, {"x_force", "y_force", "z_force", "normal_force"});  // 24 … 31
    metadata("rbdout", "ids", {5, 6});
    file.array<std::int32_t>("num_nodal", Type::int32, {1});
    state("rbdout", 2, {"global_dx", "global_dy", "global_dz", "global_rdy"});  // 32 … 39
    metadata("swforc", "ids", {6, 6, 9});
    file.array<std::int32_t>("types", Type::int32, {2, 3, 2});
    state("swforc", 3, {"axial", "shear", "failure_time"});  // 40 … 48
    file.array<double>("failure", Type::float64, {0, 0.5, 1});
    file.change("/elout/beam/d000001");
    file.array<double>("time", Type::float64, {0.5});
    file.array<std::int32_t>("ids", Type::int32, {60, 61});
    file.array<std::int32_t>("nip", Type::int32, {0, 2});
    file.array<double>("axial", Type::float64, {40, 41});
    file.array<double>("sigma_11", Type::float64, {1, 2});
    file.array<double>("plastic_eps", Type::float64, {3, 4});
    file.change("/elout/shell/d000001");
    file.array<double>("time", Type::float64, {0.5});
    file.array<std::int32_t>("ids", Type::int32, {70, 71});
    file.array<std::int32_t>("nip", Type::int32, {2, 1});
    file.array<std::int32_t>("npl", Type::int32, {2, 1});
    file.array<double>("sig_xx", Type::float64, {1, 2, 3, 4, 5});  // two layers of two points; one of one
    file.change("/elout/solid/d000001");
    file.array<double>("time", Type::float64, {0.5});
    file.array<std::int32_t>("ids", Type::int32, {80});
    file.array<double>("sig_xx", Type::float64, {6});
    file.array<double>("yield", Type::float64, {7});
    metadata("deforc", "ids", {80, 81});
    file.array<std::int32_t>("irot", Type::int32, {0, 1});
    state("deforc", 2, {"x_force", "y_force", "z_force", "resultant_force", "displacement"});  // 49 … 58
    metadata("jntforc/joints", "ids", {90});
    file.array<std::int32_t>("local", Type::int32, {1});
    state("jntforc/joints", 1, {"x_force", "y_force", "z_force", "x_moment"});  // 59 … 62

    const RunResults run = read(file);
    EXPECT_EQ(said_, "");
    EXPECT_EQ(rows(run.secforc)[1].section, 9);
    EXPECT_EQ(rows(run.secforc)[1].force, Vector(2, 4, 6));
    EXPECT_EQ(rows(run.secforc)[1].moment, Vector(10, 0, 0));
    EXPECT_EQ(rows(run.secforc)[0].area, 11);
    const std::vector<SupportState> supports = rows(run.spcforc);
    ASSERT_EQ(supports.size(), 3u);
    EXPECT_EQ(supports[0].node, 5);
    EXPECT_FALSE(supports[0].translation);
    EXPECT_EQ(supports[0].moment, Vector(101, 101, 101));
    EXPECT_TRUE(supports[1].translation && supports[1].rotation);
    EXPECT_EQ(supports[1].force, Vector(13, 14, 15));
    EXPECT_EQ(supports[1].moment, Vector(100, 100, 100));
    EXPECT_EQ(supports[2].node, 0);
    EXPECT_EQ(supports[2].force, Vector(200, 0, 0));
    const std::vector<BoundaryState> boundary = rows(run.bndout);
    ASSERT_EQ(boundary.size(), 2u);
    EXPECT_EQ(boundary[0].kind, BoundaryKind::velocity);
    EXPECT_EQ(boundary[0].energy, 19);
    EXPECT_TRUE(boundary[1].body);
    EXPECT_EQ(boundary[1].force, Vector(20, 21, 22));
    EXPECT_EQ(rows(run.rwforc)[1].wall, 12);
    EXPECT_EQ(rows(run.rwforc)[1].force, Vector(25, 27, 29));
    EXPECT_EQ(rows(run.rwforc)[0].normal, 30);
    EXPECT_EQ(rows(run.rbdout)[0].displacement, Vector(32, 34, 36));
    EXPECT_EQ(rows(run.rbdout)[1].rotation, Vector(0, 39, 0));
    EXPECT_FALSE(rows(run.rbdout)[0].nodal);
    EXPECT_TRUE(rows(run.rbdout)[1].nodal);
    EXPECT_EQ(rows(run.swforc)[1].kind, WeldForce::Kind::solid);
    EXPECT_EQ(rows(run.swforc)[1].axial, 41);
    EXPECT_FALSE(rows(run.swforc)[1].failed);
    EXPECT_EQ(rows(run.swforc)[2].shear, 45);
    EXPECT_TRUE(rows(run.swforc)[2].failed);
    EXPECT_EQ(rows(run.swforc)[2].failure_time, 48);
    const std::vector<ElementStress> elements = rows(run.elout);
    ASSERT_EQ(elements.size(), 5u);
    EXPECT_EQ(elements[0].resultants[0], 40);
    EXPECT_TRUE(elements[0].points.empty());
    ASSERT_EQ(elements[1].points.size(), 2u);
    EXPECT_EQ(elements[1].points[1].stress[0], 2);
    EXPECT_EQ(elements[1].points[1].plastic_strain, 4);
    EXPECT_EQ(elements[2].layers, 2u);
    ASSERT_EQ(elements[2].points.size(), 4u);
    EXPECT_EQ(elements[2].points[1].stress[0], 3);  // second layer of the first point
    EXPECT_EQ(elements[2].points[2].stress[0], 2);
    EXPECT_EQ(elements[3].points.at(0).stress[0], 5);
    EXPECT_EQ(elements[4].kind, StressKind::solid);
    EXPECT_EQ(elements[4].points.at(0).plastic_strain, 7);
    EXPECT_EQ(rows(run.deforc)[0].force, Vector(49, 51, 53));
    EXPECT_EQ(rows(run.deforc)[1].resultant, 56);
    EXPECT_TRUE(rows(run.deforc)[1].torsional);
    EXPECT_TRUE(rows(run.jntforc)[0].local);
    EXPECT_EQ(rows(run.jntforc)[0].moment, Vector(62, 0, 0));
  }
}

/// A wall in one state.
SampleLsda one_wall() {
  SampleLsda file;
  file.change("/rwforc/forces/metadata");
  file.array<std::int32_t>("ids", Type::int32, {1});
  file.change("/rwforc/forces/d000001");
  file.array<double>("time", Type::float64, {0.5});
  for (const char* name : {"x_force", "y_force", "z_force", "normal_force"})
    file.array<double>(name, Type::float64, {4});
  return file;
}

// The text file comes first, as for all other files.
TEST_F(BinoutHistories, NotBesideATextFile) {
  EXPECT_EQ(read(one_wall()).rwforc.states.size(), 1u);
  std::ofstream(folder_ / "rwforc") << "\n";
  EXPECT_TRUE(read(one_wall()).rwforc.states.empty());
}

// Ids of nothing, values of nobody, states without their time or a column that all have, points that do not add up.
TEST_F(BinoutHistories, HostileStates) {
  SampleLsda file = one_wall();
  file.change("/secforc/metadata");
  file.array<std::int8_t>("ids", Type::int8, std::vector<std::int8_t>(100'000, 1));
  for (int state = 0; state < 2000; ++state) {
    file.change("/secforc/d" + std::to_string(state));
    file.array<double>("time", Type::float64, {1.0});
    file.array<double>("x_force", Type::float64, {1.0});
  }
  for (const char* gone : {"time", "y_force"}) {
    file.change(std::string("/rwforc/forces/d00000") + (gone[0] == 't' ? "2" : "3"));
    for (const char* name : {"time", "x_force", "y_force", "z_force"})
      if (std::string(name) != gone) file.array<double>(name, Type::float64, {2});
  }
  const std::vector<std::vector<std::int64_t>> counts{{-1, 4}, {1, 1}, {2, 1}, {std::int64_t{1} << 62, 4}, {1, 3}};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    file.change("/elout/shell/d" + std::to_string(i));
    file.array<double>("time", Type::float64, {1.0});
    file.array<std::int64_t>("ids", Type::int64, {1, 2});
    file.array<std::int64_t>("nip", Type::int64, counts[i]);
    file.array<double>("sig_xx", Type::float64, {1, 2, 3});
  }
  const RunResults run = read(file);
  EXPECT_NE(said_.find("2006 states"), std::string::npos) << said_;
  EXPECT_TRUE(run.secforc.states.empty());
  EXPECT_EQ(rows(run.elout)[0].points.size(), 2u);
  ASSERT_EQ(run.rwforc.states.size(), 1u);
  EXPECT_EQ(run.rwforc.states[0].time, 0.5);
}

}  // namespace
}  // namespace gapcheck::results::binout_histories_test
