#include "solver/output/text_files.hpp"

#include <map>

#include "results/history/section_forces.hpp"
#include "solver/conditioned.hpp"
#include "solver/output/run_states.hpp"
#include "solver/output/section_states.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::text_files_test {
namespace {

RunSettings small_steps() {
  RunSettings settings;
  settings.step.greatest_step = 1e-3;
  return settings;
}

/// All files of a run with their states at every step.
std::map<std::string, std::string> texts_of(RunScene& scene) {
  std::map<std::string, std::string> texts;
  RunRecord record(scene.run(), contact::element_sizes(scene.read().model), scene.surfaces());
  const std::vector<TextFile> files = text_files(scene.run(), "gapcheck 0", record);
  for (const TextFile& file : files)
    if (file.interval > 0) texts[file.name] = file.header;
  scene.go([&](const solver::Run& run) {
    record.advance(run);
    for (const TextFile& file : files) {
      if (!(file.interval > 0)) continue;
      std::string& text = texts[file.name];
      EXPECT_TRUE(file.state(run, [&](std::string_view piece) {
        text += piece;
        return true;
      }));
    }
  });
  return texts;
}

const std::string requests =
    "*DATABASE_SECFORC\n0.001\n*DATABASE_SPCFORC\n0.001\n*DATABASE_BNDOUT\n0.001\n*DATABASE_RWFORC\n0.001\n"
    "*DATABASE_RBDOUT\n0.001\n*DATABASE_SWFORC\n0.001\n*DATABASE_ELOUT\n0.001\n*CONTROL_TERMINATION\n0.005\n";

// Everything that a deck may ask for is written, and the readers find all states without a complaint.
TEST(TextFiles, AreReadBack) {
  RunScene scene(
      brick_bar(3, {1, 0.5, 0.25}) + elastic_deck(solid_section, 1000, 0.3, 2) + rigid_material +
          "*NODE\n51,0.,0.,20.\n52,1.,0.,20.\n53,1.,1.,20.\n54,0.,1.,20.\n*ELEMENT_SHELL\n9,7,51,52,53,54\n*PART\nr\n7,"
          "7,7\n"
          "*SECTION_SHELL\n7,2\n0.1\n"
          "*NODE\n31,0.,9.,0.\n32,1.,9.,0.\n*ELEMENT_MASS\n31,31,1.\n32,32,1.\n*CONSTRAINED_SPOTWELD\n31,32\n"
          "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*LOAD_NODE_POINT\n4,1,1,1.\n"
          "*RIGIDWALL_PLANAR\n0\n90.,0.,0.,89.,0.,0.\n*DATABASE_HISTORY_SOLID\n2\n"
          "*DATABASE_CROSS_SECTION_PLANE\n0,1.5,0.,0.,2.,0.,0.\n\n" +
          requests,
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const std::map<std::string, std::string> texts = texts_of(scene);
  const std::size_t states = scene.state().cycle + 1;
  Diagnostics diagnostics;
  const auto sections = results::read_secforc(texts.at("secforc"), "secforc", diagnostics);
  EXPECT_EQ(sections.states.size(), states);
  EXPECT_EQ(results::read_spcforc(texts.at("spcforc"), "spcforc", diagnostics).states.size(), states);
  EXPECT_EQ(results::read_bndout(texts.at("bndout"), "bndout", diagnostics).states.size(), states);
  EXPECT_EQ(results::read_rwforc(texts.at("rwforc"), "rwforc", diagnostics).states.size(), states);
  EXPECT_EQ(results::read_rbdout(texts.at("rbdout"), "rbdout", diagnostics).states.size(), states);
  EXPECT_EQ(results::read_swforc(texts.at("swforc"), "swforc", diagnostics).states.size(), states);
  EXPECT_EQ(results::read_elout(texts.at("elout"), "elout", diagnostics).states.size(), states);
  for (const Diagnostic& d : diagnostics.sorted()) ADD_FAILURE() << d.file << ":" << d.line << ": " << d.message;
  const results::SectionState now =
      section_states(scene.run(), ElementPlaces(scene.read().model, scene.run().stepper().structure()),
                     section_cuts(scene.read().model))[0];
  EXPECT_NEAR((sections.states.back().rows.at(0).force - now.force).norm(), 0, 1e-4 * now.force.norm());
}

// The same requests in a deck that has nothing to write.
TEST(TextFiles, NotWithoutContents) {
  std::string said;
  for (const model::Output::Note& note : output_notes(model::read_text(requests).model)) said += note.text + "\n";
  for (const char* name : {"secforc", "spcforc", "bndout", "rwforc", "rbdout", "swforc", "elout"})
    EXPECT_NE(said.find(std::string("asks for ") + name), std::string::npos) << said;
  RunScene scene("*NODE\n1,0.,0.,0.\n*ELEMENT_MASS\n1,1,1.\n" + requests, small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const std::map<std::string, std::string> texts = texts_of(scene);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts.begin()->first, "glstat");
}

// The moments of rcforc are those of the forces on the nodes about the origin; each side's force is that on its nodes.
TEST(TextFiles, MomentsOfContactsAreAboutTheOrigin) {
  RunScene scene(
      "*CONTROL_TERMINATION\n0.02\n*NODE\n1,7.,0.,0.\n2,8.,0.,0.\n3,8.,1.,0.\n4,7.,1.,0.\n5,7.2,0.2,0.11\n6,7.8,0.2,0."
      "11\n"
      "7,7.8,0.8,0.11\n8,7.2,0.8,0.11\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n" +
          elastic_deck(shell_section, 1000, 0.3, 1) +
          "*PART\nq\n2,1,1\n*SET_NODE_LIST\n4\n5,6,7,8\n*INITIAL_VELOCITY\n4\n0.5,0.,-2.\n"
          "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n7,a pair\n2,1,3,3,0,0,1,1\n0.3\n\n",
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double most = 0;
  scene.go([&](const solver::Run& run) {
    const std::vector<results::InterfaceState> contacts = interface_states(run, true);
    ASSERT_EQ(contacts.size(), 1u);
    const auto nodes = node_forces(run, ContactIndex{0}, {});
    ASSERT_TRUE(nodes);
    std::array<Vector, 2> force{Vector::Zero(), Vector::Zero()}, moment = force;
    for (const results::NodeForce& node : *nodes) {
      const std::size_t side = node.node > 4 ? 0 : 1;
      force[side] += node.force;
      moment[side] += node.position.cross(node.force);
    }
    for (std::size_t side = 0; side < 2; ++side) {
      most = std::max(most, moment[side].norm());
      EXPECT_NEAR((contacts[0].force[side] - force[side]).norm(), 0, 1e-9 * (1 + most));
      EXPECT_NEAR((contacts[0].moment[side] - moment[side]).norm(), 0, 1e-9 * (1 + most));
    }
  });
  EXPECT_GT(most, 1);
}

}  // namespace
}  // namespace gapcheck::solver::text_files_test
