#include "results/curves/binout_write_histories.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "results/curves/binout_folder.hpp"

namespace gapcheck::results::binout_write_histories_test {
namespace {

/// Every number of its own.
class Numbers {
 public:
  double next() { return value_ += 0.125; }
  Vector vector() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }
  StressRow point(bool plastic) {
    StressRow row;
    for (double& stress : row.stress) stress = next();
    row.plastic_strain = next();
    row.plastic = plastic;
    return row;
  }

 private:
  double value_ = 0;
};

/// All kinds of rows at one time, and what becomes of them in a binout.
struct AllRows {
  std::vector<SectionState> sections;
  SupportStates supports;
  std::vector<BoundaryState> boundary;
  std::vector<WallForce> walls;
  std::vector<BodyMotion> bodies;
  std::vector<WeldForce> welds;
  std::vector<ElementStress> elements;
  std::vector<SpringForce> springs;
  std::vector<JointForce> joints;
  std::vector<AirbagRow> airbags;

  explicit AllRows(Numbers& n) {
    for (const std::int64_t id : {7, 3}) sections.push_back({id, n.vector(), n.vector(), n.vector(), n.next()});
    supports = {{{5, true, true, n.vector(), n.vector()},
                 {6, false, true, Vector::Zero(), n.vector()},
                 {9, true, false, n.vector(), Vector::Zero()}},
                n.vector()};
    boundary = {{BoundaryKind::discrete, false, 1, n.vector(), n.next(), Vector::Zero()},
                {BoundaryKind::discrete, true, 2, n.vector(), n.next(), Vector::Zero()},
                {BoundaryKind::pressure, false, 3, n.vector(), n.next(), Vector::Zero()},
                {BoundaryKind::velocity, false, 4, n.vector(), n.next(), Vector::Zero()},
                {BoundaryKind::velocity, true, 5, n.vector(), n.next(), n.vector()}};
    walls = {{4, n.next(), n.vector()}, {5'000'000'000, n.next(), n.vector()}};
    for (const bool nodal : {false, true}) {
      BodyMotion& body = bodies.emplace_back();
      body.body = nodal ? 12 : 30;
      body.nodal = nodal;
      for (Vector* value : {&body.position, &body.displacement, &body.velocity, &body.acceleration, &body.rotation,
                            &body.spin, &body.spin_rate})
        *value = n.vector();
      body.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    }
    for (const WeldForce::Kind kind :
         {WeldForce::Kind::link, WeldForce::Kind::generalized, WeldForce::Kind::beam, WeldForce::Kind::solid})
      welds.push_back(
          {kind, 8, n.next(), n.next(), kind == WeldForce::Kind::beam, n.next(), n.next(), n.next(), n.next()});
    elements = {{StressKind::solid, 1, 2, {}, {n.point(true)}, 1},
                {StressKind::beam, 3, 4, {1, 2, 3, 4, 5, 6}, {}, 1},
                {StressKind::beam, 5, 4, {7, 8, 9, 10, 11, 12}, {n.point(false), n.point(false)}, 1},
                {StressKind::shell, 6, 6, {}, {n.point(false), n.point(true), n.point(false)}, 3}};
    elements[0].points[0].effective = n.next();
    springs = {{1, false, n.vector(), n.next(), n.next()}, {2, true, n.vector(), n.next(), n.next()}};
    joints = {{1, false, n.vector(), n.vector()}, {2, true, n.vector(), n.vector()}};
    for (const std::int64_t id : {4, 2}) {
      AirbagRow& bag = airbags.emplace_back();
      bag.airbag = id;
      for (double* value : {&bag.volume, &bag.pressure, &bag.energy, &bag.rate_in, &bag.density, &bag.rate_out,
                            &bag.mass, &bag.temperature, &bag.area})
        *value = n.next();
    }
  }

  /// Shells with four points in the plane.
  void add_full_shell(Numbers& n) {
    ElementStress shell{StressKind::shell, 60, 6, {}, {}, 2};
    for (int i = 0; i < 8; ++i) shell.points.push_back(n.point(i == 3));
    elements.push_back(shell);
  }

  void add_to(BinoutWriter& binout, double time) const {
    add_secforc(binout, {{3, "cut"}}, time, sections);
    add_spcforc(binout, time, supports);
    add_bndout(binout, time, boundary);
    add_rwforc(binout, {}, time, walls);
    add_rbdout(binout, 17, time, bodies);
    add_swforc(binout, time, welds);
    add_elout(binout, {}, 17, time, false, elements);
    add_deforc(binout, time, springs);
    add_jntforc(binout, time, joints);
    add_abstat(binout, {{4, "bag"}}, time, airbags);
  }

  /// All numbers as the text files have them, but with all digits: what is printed is compared.
  [[nodiscard]] std::string text(double time) const {
    return secforc_text(time, sections) + spcforc_text(time, supports) + bndout_text(time, boundary) +
           rwforc_text(time, walls) + rbdout_text(17, time, bodies) + swforc_text(time, welds) +
           elout_text(17, time, false, elements) + deforc_text(time, springs) + jntforc_text(time, joints) +
           abstat_text(time, airbags);
  }
};

class BinoutWriteHistories : public BinoutFolder {
 protected:
  void SetUp() override {
    BinoutFolder::SetUp();
    auto binout = BinoutWriter::create(path(), {"a run", "gapcheck 1.2.3"});
    ASSERT_TRUE(binout);
    binout_ = std::make_unique<BinoutWriter>(std::move(binout).value());
  }

  RunResults read() {
    EXPECT_TRUE(binout_->file().flush().ok());
    RunResults run = read_folder();
    EXPECT_EQ(said_, "");
    return run;
  }
  /// Sizes of the arrays of a directory.
  std::map<std::string, std::size_t> arrays(const std::string& directory) {
    EXPECT_TRUE(binout_->file().flush().ok());
    std::ostringstream bytes;
    bytes << std::ifstream(path(), std::ios::binary).rdbuf();
    const std::string text = bytes.str();
    std::map<std::string, std::size_t> found;
    Diagnostics diagnostics;
    EXPECT_TRUE(read_lsda(
                    text, "binout0000",
                    [&](const LsdaArray& array) {
                      if (array.path() == directory) found[std::string(array.name())] = array.size();
                    },
                    diagnostics)
                    .ok());
    return found;
  }

  std::unique_ptr<BinoutWriter> binout_;
};

/// The rows that were read, as those of one state.
AllRows read_rows(const RunResults& run, std::size_t i) {
  Numbers none;
  AllRows all(none);
  all.sections = run.secforc.states.at(i).rows;
  all.supports.supports = run.spcforc.states.at(i).rows;
  all.supports.resultant = all.supports.supports.back().force;
  EXPECT_EQ(all.supports.supports.back().node, 0);
  all.supports.supports.pop_back();
  all.boundary = run.bndout.states.at(i).rows;
  all.walls = run.rwforc.states.at(i).rows;
  all.bodies = run.rbdout.states.at(i).rows;
  all.welds = run.swforc.states.at(i).rows;
  all.elements = run.elout.states.at(i).rows;
  // Whether a point has yielded is not read: files name their states in words.
  for (ElementStress& element : all.elements)
    for (StressRow& point : element.points) point.plastic = false;
  all.springs = run.deforc.states.at(i).rows;
  all.joints = run.jntforc.states.at(i).rows;
  all.airbags = run.abstat.states.at(i).rows;
  return all;
}

TEST_F(BinoutWriteHistories, EveryNumberComesBack) {
  Numbers n;
  AllRows first(n), second(n);
  second.add_full_shell(n);  // elements may come and go
  first.add_to(*binout_, 0.5);
  second.add_to(*binout_, 0.75);
  const RunResults run = read();
  for (const std::size_t i : {0u, 1u}) {
    AllRows expected = i == 0 ? first : second;
    for (ElementStress& element : expected.elements)
      for (StressRow& point : element.points) point.plastic = false;
    const AllRows found = read_rows(run, i);
    EXPECT_EQ(found.text(i == 0 ? 0.5 : 0.75), expected.text(i == 0 ? 0.5 : 0.75));
    // What the text rounds or leaves out.
    EXPECT_EQ(found.sections[1].force, expected.sections[1].force);
    EXPECT_EQ(found.bodies[1].spin_rate, expected.bodies[1].spin_rate);
    EXPECT_EQ(found.welds[3].moment, expected.welds[3].moment);
    EXPECT_EQ(found.welds[3].torsion, expected.welds[3].torsion);
  }
  EXPECT_EQ(run.secforc.states.size(), 2u);
  EXPECT_EQ(run.elout.states.at(1).rows.size(), 5u);
}

// All elements of a kind have failed: the state has its time only.
TEST_F(BinoutWriteHistories, FailedElements) {
  Numbers n;
  const std::vector<ElementStress> both{{StressKind::solid, 1, 2, {}, {n.point(true)}, 1},
                                        {StressKind::shell, 6, 6, {}, {n.point(false)}, 1}};
  add_elout(*binout_, {}, 1, 0, false, both);
  add_elout(*binout_, {}, 2, 1, false, std::span(both).first(1));
  EXPECT_EQ(arrays("/elout/shell/d000002"), (std::map<std::string, std::size_t>{{"time", 1}, {"cycle", 1}}));
  const RunResults run = read();
  ASSERT_EQ(run.elout.states.size(), 2u);
  EXPECT_EQ(run.elout.states[1].rows.size(), 1u);
}

// What LS-DYNA's own converter from binout to text asks for, and how many numbers of it.
TEST_F(BinoutWriteHistories, ArraysOfTheConverter) {
  Numbers n;
  AllRows all(n);
  all.add_to(*binout_, 0.5);
  const auto expect = [&](const std::string& directory, std::size_t count, const std::string& names) {
    const std::map<std::string, std::size_t> found = arrays(directory);
    std::istringstream words(names);
    for (std::string name; words >> name;) {
      const auto array = found.find(name);
      ASSERT_TRUE(array != found.end()) << directory << "/" << name;
      EXPECT_EQ(array->second, count) << directory << "/" << name;
    }
  };
  const std::string forces = "x_force y_force z_force ", moments = "x_moment y_moment z_moment ";
  expect("/secforc/metadata", 2, "ids rigidbody accelerometer coordinate_system");
  expect("/secforc/metadata", 80, "title legend");
  expect("/secforc/metadata", 1, "legend_ids");
  expect("/secforc/d000001", 2, forces + moments + "total_force total_moment x_centroid y_centroid z_centroid area");
  expect("/spcforc/metadata", 2, "force_ids moment_ids");
  expect("/spcforc/d000001", 2, forces + moments);
  expect("/spcforc/d000001", 1, "time x_resultant y_resultant z_resultant");
  for (const char* branch :
       {"discrete/nodes", "discrete/rigidbodies", "pressure", "velocity/nodes", "velocity/rigidbodies"}) {
    expect(std::string("/bndout/") + branch + "/metadata", 1, "ids");
    expect(std::string("/bndout/") + branch + "/d000001", 1, forces + "energy time x_total y_total z_total etotal");
  }
  expect("/bndout/velocity/nodes/metadata", 1, "setid");
  expect("/bndout/velocity/rigidbodies/d000001", 1, "xmoment ymoment zmoment");
  expect("/rwforc/forces/metadata", 2, "ids setid");
  expect("/rwforc/forces/d000001", 2, forces + "normal_force");
  std::string motions = "ids global_x global_y global_z ";
  for (const char* system : {"global", "local"})
    for (const char* what : {"d", "rd", "v", "rv", "a", "ra"})
      for (const char axis : {'x', 'y', 'z'}) motions += std::string(system) + "_" + what + axis + " ";
  for (const char* place : {"11", "12", "13", "21", "22", "23", "31", "32", "33"})
    motions += std::string("dircos_") + place + " ";
  expect("/rbdout/d000001", 2, motions);
  expect("/rbdout/d000001", 1, "time cycle num_nodal");
  expect("/swforc/metadata", 4, "ids types");
  expect("/swforc/d000001", 4, "axial shear failure failure_time length resultant_moment torsion");
  const std::string stresses = "sig_xx sig_yy sig_zz sig_xy sig_yz sig_zx state ";
  expect("/elout/solid/metadata", 15, "states");
  expect("/elout/solid/d000001", 1, "time cycle ids mtype yield effsg " + stresses);
  expect("/elout/beam/d000001", 2, "ids mat nip axial shear_s shear_t moment_s moment_t torsion");
  expect("/elout/beam/d000001", 2, "sigma_11 sigma_12 sigma_31 plastic_eps");
  expect("/elout/shell/metadata", 15, "states");
  expect("/elout/shell/metadata", 6, "system");
  expect("/elout/shell/d000001", 1, "ids mat nip iop");
  expect("/elout/shell/d000001", 3, "plastic_strain " + stresses);
  EXPECT_EQ(arrays("/elout/shell/d000001").count("npl"), 0u) << "points in the plane have another layout";
  expect("/deforc/metadata", 2, "ids irot");
  expect("/deforc/d000001", 2, forces + "resultant_force displacement");
  expect("/abstat/metadata", 2, "ids");
  expect("/abstat/d000001", 2,
         "volume pressure internal_energy dm_dt_in density dm_dt_out total_mass gas_temp surface_area");
  expect("/jntforc/joints/metadata", 2, "ids local");
  expect("/jntforc/joints/d000001", 2, forces + moments + "resultant_force resultant_moment");
}

}  // namespace
}  // namespace gapcheck::results::binout_write_histories_test
