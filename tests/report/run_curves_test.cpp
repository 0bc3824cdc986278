// A run of the bundled solver, read back: the text files and the binout of one run give the same curves.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "folder_test.hpp"
#include "report/compare/curves.hpp"
#include "solver/conditioned.hpp"
#include "solver/output/run_files.hpp"

namespace gapcheck::report::run_curves_test {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 15> files{"glstat",  "matsum",  "nodout", "rcforc",  "sleout",
                                                 "secforc", "spcforc", "bndout", "rwforc",  "rbdout",
                                                 "swforc",  "elout",   "deforc", "jntforc", "abstat"};

/// Something for each of them: a bar that is held, loaded, moved and cut, two plates in contact, a beam, a weld, a
/// spring, a mass that hits a wall, rigid bodies and a joint.
std::string deck(int binary) {
  std::string text =
      solver::brick_bar(3, {1, 0.5, 0.25}) + solver::elastic_deck(solver::solid_section, 1000, 0.3, 2) +
      solver::rigid_material +
      "*NODE\n51,0.,0.,20.\n52,1.,0.,20.\n53,1.,1.,20.\n54,0.,1.,20.\n*ELEMENT_SHELL\n9,7,51,52,53,54\n"
      "*PART\nrigid\n7,7,7\n*SECTION_SHELL\n7,2\n0.1\n"
      "*NODE\n31,0.,9.,0.\n32,1.,9.,0.\n41,0.,12.,0.\n42,1.,12.,0.\n45,89.99,0.,0.\n*ELEMENT_MASS\n"
      "31,31,1.\n32,32,1.\n41,41,1.\n42,42,1.\n45,45,1.\n*CONSTRAINED_SPOTWELD\n31,32\n"
      "*ELEMENT_DISCRETE\n41,11,41,42\n*PART\nspring\n11,11,11\n*SECTION_DISCRETE\n11,0\n\n*MAT_SPRING_ELASTIC\n11,50."
      "\n"
      "*NODE\n61,40.,0.,0.\n62,41.,0.,0.\n63,40.,1.,0.\n64,40.,0.,1.\n71,40.,0.,0.\n72,42.,0.,0.\n73,42.,1.,0.\n"
      "74,42.,0.,1.\n*ELEMENT_MASS\n61,61,1.\n62,62,1.\n63,63,1.\n64,64,1.\n71,71,1.\n72,72,1.\n73,73,1.\n74,74,1.\n"
      "*SET_NODE_LIST\n60\n61,62,63,64\n*SET_NODE_LIST\n70\n71,72,73,74\n*CONSTRAINED_NODAL_RIGID_BODY_SPC\n60,0,60\n"
      "1.,7,7\n*CONSTRAINED_NODAL_RIGID_BODY\n70,0,70\n*CONSTRAINED_JOINT_SPHERICAL_ID\n5,pin\n61,71\n"
      "*NODE\n81,60.,0.,0.\n82,61.,0.,0.\n83,60.,1.,0.\n*ELEMENT_BEAM\n4,9,81,82,83\n*PART\nbeam\n9,9,1\n"
      "*SECTION_BEAM\n9,1\n0.1,0.1,0.2,0.2\n"
      "*NODE\n101,0.,0.,30.\n102,1.,0.,30.\n103,0.,1.,30.\n104,0.,0.,31.\n*ELEMENT_MASS\n101,101,1.\n102,102,1.\n"
      "103,103,1.\n104,104,1.\n*SET_SEGMENT\n100\n101,103,102,102\n101,102,104,104\n102,103,104,104\n103,101,104,104\n"
      "*AIRBAG_SIMPLE_AIRBAG_MODEL_ID\n13,bag\n100\n700.,980.,300.,3,0.5,0.01,10.,0.1\n0\n"
      "*NODE\n91,20.,20.,0.\n92,21.,20.,0.\n93,21.,21.,0.\n94,20.,21.,0.\n95,20.2,20.2,0.11\n96,20.8,20.2,0.11\n"
      "97,20.8,20.8,0.11\n98,20.2,20.8,0.11\n*ELEMENT_SHELL\n20,8,91,92,93,94\n21,10,95,96,97,98\n"
      "*SECTION_SHELL\n8,2\n0.1\n*PART\np\n8,8,1\n*PART\nq\n10,8,1\n"
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n3,plates\n10,8,3,3\n0.3\n\n"
      "*SET_NODE_LIST\n4\n95,96,97,98\n*INITIAL_VELOCITY\n4\n0.5,0.1,-2.\n"
      "*INITIAL_VELOCITY_NODE\n42,1.,0.3,0.\n45,5.,1.,0.\n82,0.2,0.1,0.05\n31,0.3,0.2,0.\n"
      "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n5,0,1,0,1,1,1,1\n*LOAD_NODE_POINT\n4,1,1,1.\n45,1,1,3.\n"
      "*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*DEFINE_CURVE\n3\n0.,0.\n1.,20.\n*LOAD_BODY_Z\n1,10.\n"
      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n16,2,0,3\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,1,0,3\n"
      "*LOAD_SEGMENT\n1,0.5,0.,91,92,93,94\n*RIGIDWALL_PLANAR_ID\n6\n0\n90.,0.,0.,89.,0.,0.\n"
      "*DATABASE_CROSS_SECTION_PLANE_ID\n12,cut\n0,1.5,0.,0.,2.,0.,0.\n\n"
      "*DATABASE_HISTORY_NODE\n4,98\n*DATABASE_HISTORY_SOLID\n2\n*DATABASE_HISTORY_BEAM\n4\n"
      "*DATABASE_HISTORY_SHELL_ID\n        21the plate\n*CONTROL_TERMINATION\n0.02\n";
  for (const std::string_view file : files) {
    text += "*DATABASE_";
    for (const char letter : file) text += static_cast<char>(letter - 'a' + 'A');
    text += fmt::format("\n0.004,{}\n", binary);
  }
  return text;
}

class RunCurves : public FolderTest {
 protected:
  /// Runs the deck into a folder of this name; the names of its files.
  std::set<std::string> calculate(const std::string& folder, int binary, bool option = false) const {
    const model::Read read = model::read_text(deck(binary));
    EXPECT_EQ(read.errors(), 0u) << read.text();
    contact::SurfaceStore surfaces(read.model);
    Diagnostics diagnostics;
    solver::RunSettings step;
    step.step.greatest_step = 1e-3;
    auto run = solver::Run::prepare(read.model, surfaces, step, diagnostics);
    EXPECT_TRUE(run.ok()) << (run.ok() ? "" : run.error().message);
    if (!run) return {};
    solver::RunFilesSettings settings;
    settings.directory = (folder_ / folder).string();
    settings.program = "gapcheck 1.2.3";
    settings.binout = option;
    auto written = solver::RunFiles::create(run.value(), surfaces, settings);
    EXPECT_TRUE(written.ok());
    EXPECT_EQ(run.value().go(written.value()), solver::RunEnd::time);
    const std::vector<std::string> names = written.value().names();
    return {names.begin(), names.end()};
  }
  [[nodiscard]] std::vector<Curve> read(const std::string& folder) const {
    Diagnostics diagnostics;
    std::vector<Curve> list = curves(results::read_run_results((folder_ / folder).string(), true, diagnostics));
    for (const Diagnostic& d : diagnostics.sorted()) ADD_FAILURE() << d.file << ": " << d.message;
    return list;
  }
  [[nodiscard]] std::string bytes(const std::string& folder) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / folder / "binout0000", std::ios::binary).rdbuf();
    return text.str();
  }
};

/// Equal to the digits that the text has. The resultant of rounded components is off by somewhat more.
void expect_same(const Curve& text, const Curve& binout) {
  ASSERT_EQ(text.values.size(), binout.values.size()) << text.name;
  const double units = text.name.find("resultant") == std::string::npos ? 0.51 : 0.9;
  for (std::size_t i = 0; i < text.values.size(); ++i) {
    EXPECT_NEAR(text.times[i], binout.times[i], 5e-4 * binout.times[i]) << text.name;
    const double exact = binout.values[i];
    const double unit = exact == 0 ? 0 : std::pow(10, std::floor(std::log10(std::abs(exact))) - text.digits + 1);
    EXPECT_NEAR(text.values[i], exact, units * unit + 1e-98) << text.name << " at " << text.times[i];
  }
}

TEST_F(RunCurves, TextAndBinoutSayTheSame) {
  const std::set<std::string> names = calculate("text", 3);
  for (const std::string_view file : files) EXPECT_EQ(names.count(std::string(file)), 1u) << file;
  EXPECT_EQ(names.count("binout0000"), 1u);
  fs::create_directories(folder_ / "binout");
  fs::rename(folder_ / "text/binout0000", folder_ / "binout/binout0000");
  const std::vector<Curve> text = read("text"), binout = read("binout");
  ASSERT_EQ(text.size(), binout.size());
  std::set<std::string> seen, moving;
  for (std::size_t i = 0; i < text.size(); ++i) {
    ASSERT_EQ(text[i].name, binout[i].name);
    EXPECT_EQ(text[i].quantity, binout[i].quantity) << text[i].name;
    expect_same(text[i], binout[i]);
    seen.insert(text[i].file);
    for (const double value : binout[i].values)
      if (value != 0) moving.insert(text[i].file);
  }
  EXPECT_EQ(seen.size(), files.size() - 1) << "matsum has no curves";
  EXPECT_EQ(moving, seen) << "files of zeros show nothing";
  RecordProperty("curves", static_cast<int>(text.size()));
}

// BINARY = 2: no text; with the option text and binout whatever the cards say. The binout is always the same.
TEST_F(RunCurves, Binary) {
  calculate("both", 3);
  const std::set<std::string> only = calculate("only", 2), option = calculate("option", 2, true),
                              plain = calculate("plain", 1);
  for (const std::string_view file : files) {
    const std::string name(file);
    EXPECT_EQ(only.count(name) + (fs::exists(folder_ / "only" / name) ? 1 : 0), 0u) << name;
    EXPECT_EQ(option.count(name), 1u) << name;
    EXPECT_EQ(plain.count(name), 1u) << name;
  }
  EXPECT_EQ(plain.count("binout0000"), 0u);
  EXPECT_FALSE(bytes("both").empty());
  EXPECT_TRUE(bytes("both") == bytes("only") && bytes("both") == bytes("option"));
}

}  // namespace
}  // namespace gapcheck::report::run_curves_test
