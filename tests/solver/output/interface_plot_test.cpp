#include "solver/output/interface_plot.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "results/curves/run_results.hpp"
#include "solver/output/run_files.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::interface_plot_test {
namespace {

namespace fs = std::filesystem;

/// A plate of 3 by 3 shells and above it one of 2 by 2 that moves down and sideways.
std::string plates() {
  std::string text = "*NODE\n", elements = "*ELEMENT_SHELL\n";
  const auto plate = [&](int part, int n, double side, double x, double z) {
    const int first = 100 * part;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        text += fmt::format("{},{},{},{}\n", first + j * (n + 1) + i, x + side * i / n, x + side * j / n, z);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = first + j * (n + 1) + i;
        elements += fmt::format("{},{},{},{},{},{}\n", first + j * n + i, part, a, a + 1, a + n + 2, a + n + 1);
      }
  };
  plate(1, 3, 3, 0, 0);
  plate(2, 2, 1.7, 0.6, 0.11);
  return text + elements +
         "*SECTION_SHELL\n1,2\n0.1\n*MAT_ELASTIC\n1,1.,1000.,0.3\n*PART\np\n1,1,1\n*PART\nq\n2,1,1\n"
         "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.7,0.2,-2.\n0.,0.,0.,0.,0.,1.\n"
         "*CONTROL_TERMINATION\n0.03\n*CONTROL_TIMESTEP\n0.,0.02\n*DATABASE_BINARY_INTFOR\n0.002\n*DATABASE_RCFORC\n0."
         "002\n";
}

std::string contact(const std::string& type, const std::string& sides, const std::string& print) {
  return fmt::format("*CONTACT_{}_ID\n7,lid\n{},0,0,{}\n0.3\n\n", type, sides, print);
}

Vector sum_of(const results::InterfaceMesh& mesh, const results::InterfaceForces& state, std::size_t surface) {
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < state.segments.size(); ++i)
    if (mesh.surface_of[i] == surface)
      for (const auto& f : state.segments[i].force) sum += Vector(f[0], f[1], f[2]);
  return sum;
}

Vector corner(const results::InterfaceForces& state, std::uint32_t node) {
  return {state.coordinates[node][0], state.coordinates[node][1], state.coordinates[node][2]};
}

// Whatever the pairs of a contact are (nodes and segments, both ways, segments and segments, single surface): the
// forces on a side's segments are those of rcforc; pressure and shear stress over the area are the force on a segment.
TEST(InterfacePlot, ForcesArePressuresOverAreas) {
  struct Case {
    const char* type;
    const char* sides;
    const char* rest;
  };
  for (const Case& c : {Case{"AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", ""},
                        Case{"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "2,1,3,3", ""},
                        Case{"AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "2\n"},
                        Case{"AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", "2,1,3,3", ""}}) {
    SCOPED_TRACE(std::string(c.type) + ' ' + c.rest);
    RunScene scene(plates() + contact(c.type, c.sides, "1,1") + c.rest);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    contact::SurfaceStore surfaces(scene.read().model);
    const InterfacePlot plot(scene.run(), surfaces);
    const results::InterfaceMesh& mesh = plot.mesh();
    ASSERT_EQ(mesh.surfaces.size(), 2u);
    EXPECT_EQ(mesh.surfaces[1].side, 1u);
    EXPECT_EQ(mesh.segments.size(), 13u);
    EXPECT_EQ(mesh.node_ids.size(), 25u);
    double greatest = 0, sheared = 0;
    scene.go([&](const solver::Run& run) {
      const results::InterfaceForces state = plot.state(run);
      const ContactState& total = run.contacts()[0].state();
      const double scale = 1e-12 * (1 + total.force_a.norm());
      EXPECT_NEAR((sum_of(mesh, state, 0) - total.force_a).norm(), 0, scale);
      EXPECT_NEAR((sum_of(mesh, state, 1) - total.force_b).norm(), 0, scale);
      double pressed = 0;
      for (std::size_t i = 0; i < state.segments.size(); ++i) {
        const results::SegmentForce& segment = state.segments[i];
        const auto& nodes = mesh.segments[i];
        const Vector across = (corner(state, nodes[2]) - corner(state, nodes[0]))
                                  .cross(corner(state, nodes[3]) - corner(state, nodes[1]));
        const double area = across.norm() / 2;
        Vector force = Vector::Zero();
        for (const auto& f : segment.force) force += Vector(f[0], f[1], f[2]);
        EXPECT_NEAR(area * std::hypot(segment.pressure, segment.shear), force.norm(), scale);
        EXPECT_NEAR(std::hypot(segment.shear_r, segment.shear_s), segment.shear, scale);
        EXPECT_NEAR(area * segment.pressure, std::abs(force.dot(across.normalized())), scale);
        if (mesh.surface_of[i] == 0) pressed += area * segment.pressure;
        sheared = std::max(sheared, segment.shear);
      }
      // The plates stay nearly flat.
      EXPECT_NEAR(pressed, std::abs(total.force_a.z()), 0.002 * total.force_a.norm() + scale);
      greatest = std::max(greatest, pressed);
    });
    EXPECT_GT(greatest, 1);
    EXPECT_GT(sheared, 0.01) << "there is friction";
  }
}

// Only the sides that the card names, and of a single surface the only one.
TEST(InterfacePlot, SidesThatTheCardNames) {
  const auto mesh_of = [](const std::string& deck) {
    RunScene scene(deck);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    contact::SurfaceStore surfaces(scene.read().model);
    return InterfacePlot(scene.run(), surfaces).mesh();
  };
  const std::string pair = "AUTOMATIC_SURFACE_TO_SURFACE";
  EXPECT_EQ(mesh_of(plates() + contact(pair, "2,1,3,3", "0,1")).segments.size(), 9u);
  EXPECT_EQ(mesh_of(plates() + contact(pair, "2,1,3,3", "1,0")).segments.size(), 4u);
  EXPECT_TRUE(mesh_of(plates() + contact(pair, "2,1,3,3", "0,0")).segments.empty());
  EXPECT_EQ(mesh_of(plates() + contact("AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "1,1")).segments.size(), 13u);
}

// Single surfaces: what presses on one plate presses on the other, so that the forces cancel and the pressures do not.
TEST(InterfacePlot, ASingleSurface) {
  RunScene scene(plates() + contact("AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "1,0"));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  contact::SurfaceStore surfaces(scene.read().model);
  const InterfacePlot plot(scene.run(), surfaces);
  double greatest = 0;
  scene.go([&](const solver::Run& run) {
    const results::InterfaceForces state = plot.state(run);
    EXPECT_NEAR(sum_of(plot.mesh(), state, 0).norm(), 0, 1e-10);
    for (const results::SegmentForce& segment : state.segments) greatest = std::max(greatest, segment.pressure);
  });
  EXPECT_GT(greatest, 0.1);
}

class InterfaceFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("gapcheck_interface_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Runs with files; the names of these.
  std::vector<std::string> calculate(const std::string& deck) {
    const model::Read read = model::read_text(deck);
    contact::SurfaceStore surfaces(read.model);
    Diagnostics diagnostics;
    auto run = solver::Run::prepare(read.model, surfaces, {}, diagnostics);
    said_.clear();
    for (const Diagnostic& diagnostic : diagnostics.sorted()) said_ += diagnostic.message + "\n";
    for (const model::Output::Note& note : read.model.output.all_notes()) said_ += note.text + "\n";
    EXPECT_TRUE(run.ok());
    RunFilesSettings settings;
    settings.directory = folder_.string();
    settings.program = "gapcheck 1.2.3";
    settings.double_words = true;
    auto files = RunFiles::create(run.value(), surfaces, settings);
    EXPECT_TRUE(files.ok());
    EXPECT_EQ(run.value().go(files.value()), RunEnd::time);
    return files.value().names();
  }
  results::RunResults results() {
    Diagnostics diagnostics;
    results::RunResults found = results::read_run_results(folder_.string(), true, diagnostics);
    EXPECT_TRUE(diagnostics.sorted().empty());
    return found;
  }

  fs::path folder_;
  std::string said_;
};

TEST_F(InterfaceFiles, ForcesAreThoseOfRcforc) {
  const std::vector<std::string> names =
      calculate(plates() + contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "1,1"));
  EXPECT_EQ(std::count(names.begin(), names.end(), "intfor"), 1);
  std::ifstream messag(folder_ / "messag");
  std::size_t lines = 0;
  for (std::string line; std::getline(messag, line);) lines += line.ends_with(" write intfor file") ? 1 : 0;
  EXPECT_EQ(lines, results().intfor.states.size());
  const results::RunResults found = results();
  ASSERT_EQ(found.intfor.surfaces.size(), 2u);
  ASSERT_EQ(found.intfor.states.size(), found.rcforc.states.size());
  double greatest = 0;
  for (std::size_t i = 0; i < found.rcforc.states.size(); ++i)
    for (const std::size_t side : {0u, 1u}) {
      const results::SurfaceForce& sum = found.intfor.states[i].rows.at(side);
      const Vector& force = found.rcforc.states[i].contacts[0].force[side];
      EXPECT_NEAR(found.intfor.states[i].time, found.rcforc.states[i].time, 1e-6);
      for (const int axis : {0, 1, 2})
        EXPECT_NEAR(sum.force[static_cast<std::size_t>(axis)], force[axis], 1e-5 * (1e-3 + force.norm()));
      greatest = std::max(greatest, force.norm());
    }
  EXPECT_GT(greatest, 1);
}

// Without SAPR and SBPR there is nothing to write, which the run says; and the file of the run before is gone.
TEST_F(InterfaceFiles, NoSideIsNamed) {
  calculate(plates() + contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "1,1"));
  EXPECT_TRUE(fs::exists(folder_ / "intfor01"));
  EXPECT_EQ(said_, "");
  calculate(plates() + contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "0,0"));
  EXPECT_NE(said_.find("no contact has SAPR or SBPR"), std::string::npos) << said_;
  EXPECT_FALSE(fs::exists(folder_ / "intfor"));
  EXPECT_FALSE(fs::exists(folder_ / "intfor01"));
}

// BINARY of the cards: what is none of its values, and what a binout does not hold, is written as text, and named.
TEST_F(InterfaceFiles, Binary) {
  const std::string contacts = contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "1,0");
  const std::vector<std::string> names = calculate(
      plates() + contacts + "*DATABASE_GLSTAT\n0.002,2\n*DATABASE_NCFORC\n0.002,2\n*DATABASE_SLEOUT\n0.002,7\n");
  for (const char* name : {"binout0000", "ncforc", "sleout", "rcforc", "intfor"})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_EQ(std::count(names.begin(), names.end(), "binout0000"), 1);
  EXPECT_FALSE(fs::exists(folder_ / "glstat"));
  EXPECT_EQ(results().glstat.size(), 16u);
  EXPECT_NE(said_.find("*DATABASE_NCFORC: BINARY = 2 asks for a binout"), std::string::npos) << said_;
  EXPECT_NE(said_.find("*DATABASE_SLEOUT: BINARY = 7 is none of"), std::string::npos) << said_;
}

}  // namespace
}  // namespace gapcheck::solver::interface_plot_test
