#include "solver/interpolation/find_followers.hpp"

#include "solver/interpolation/followed.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::find_followers_test {
namespace {

/// Masses 1 to 4 on a square (lines 2 to 5), node 9 beside it; the keyword of the cards is on line 12.
const std::string five =
    "*NODE\n1,1.,1.,0.\n2,-1.,1.,0.\n3,-1.,-1.,0.\n4,1.,-1.,0.\n9,0.,0.,1.\n"
    "*ELEMENT_MASS\n1,1,2.\n2,2,2.\n3,3,2.\n4,4,2.\n";

Failure refused(const std::string& cards) {
  Followed scene(five + cards, 1e-3);
  if (!scene.status().ok()) return scene.status().error();
  ADD_FAILURE() << "not refused: " << cards;
  return {};
}

TEST(FindFollowers, TakesNodesSetsWeightsAndLocalAxes) {
  Followed plain(five + "*CONSTRAINED_INTERPOLATION\n5,9\n1,123\n2,12,2.,3.\n3,123\n4,123,0.5\n", 1e-3);
  EXPECT_TRUE(plain.ready());
  EXPECT_EQ(plain.warnings(), "");
  Followed set(five + "*SET_NODE_LIST\n7\n1,2,3,4\n*CONSTRAINED_INTERPOLATION\n5,9,12,,1,2,1\n7,123,2.\n", 1e-3);
  EXPECT_TRUE(set.ready());
  Followed local(five +
                     "*DEFINE_COORDINATE_VECTOR\n3,0.,1.,0.,-1.,0.,0.\n"
                     "*CONSTRAINED_INTERPOLATION_LOCAL\n5,9,1,3\n1,3\n3\n2,2\n\n3,123\n3\n4,123\n\n",
                 1e-3);
  EXPECT_TRUE(local.ready()) << local.status().error().message;
}

TEST(FindFollowers, NodesOfSolidsHaveNoRotationsToCount) {
  Followed scene(five + "*CONSTRAINED_INTERPOLATION\n5,9,123\n1\n2\n3\n4,123\n", 1e-3);
  EXPECT_TRUE(scene.ready());
  EXPECT_EQ(scene.warnings(),
            "13: *CONSTRAINED_INTERPOLATION 5: 3 independent nodes have no rotations: of IDOF only the digits 1 to 3 "
            "count for them\n");
}

TEST(FindFollowers, AnInitialVelocityOfItsOwnIsReplaced) {
  const std::string cards = "*CONSTRAINED_INTERPOLATION\n5,9,123\n1,123\n2,123\n3,123\n4,123\n*INITIAL_VELOCITY_NODE\n";
  Followed other(five + cards + "9,1.\n", 1e-3);
  EXPECT_NE(other.warnings().find("the initial velocity of node 9 is replaced"), std::string::npos);
  Followed same(five + cards + "1,1.\n2,1.\n3,1.\n4,1.\n9,1.\n", 1e-3);
  EXPECT_EQ(same.warnings(), "");
  run(same.stepper(), 1);
  EXPECT_NEAR((same.state().v[4] - Vector(1, 0, 0)).norm(), 0, 1e-14);
}

TEST(FindFollowers, RefusesWithKeywordAndLine) {
  struct Case {
    std::string cards, why;
    std::uint32_t line;
    Failure::Kind kind;
  };
  using Kind = Failure::Kind;
  const std::string card = "*CONSTRAINED_INTERPOLATION\n", all = "1,123\n2,123\n3,123\n4,123\n";
  const std::string rigid = "*SET_NODE_LIST\n7\n1,2\n*CONSTRAINED_NODAL_RIGID_BODY\n50,,7\n";
  const std::string bar =
      "*NODE\n11,5.,0.,0.\n12,6.,0.,0.\n13,5.,1.,0.\n*PART\np\n1,1,1\n*SECTION_BEAM\n1,2\n"
      "0.1,0.01,0.01,0.02\n*MAT_ELASTIC\n1,1.,1000.,0.3\n*ELEMENT_BEAM\n1,1,11,12,13\n";
  const std::vector<Case> cases{
      {card + "5,9,123,,2\n" + all, "ITYP = 2 has no meaning", 13, Kind::contradiction},
      {card + "5,9,123,,,3\n" + all, "IDNSW = 3 has no meaning", 13, Kind::contradiction},
      {card + "5,9,123\n", "no independent nodes", 13, Kind::contradiction},
      {card + "5,9,127\n" + all, "DDOF = 127", 13, Kind::contradiction},
      {card + "5,9,-1\n" + all, "DDOF = -1", 13, Kind::contradiction},
      {card + "5,99,123\n" + all, "dependent node 99 is not defined", 13, Kind::unknown_reference},
      {card + "5,9,123\n1,123\n77,123\n", "independent node 77 is not defined", 15, Kind::unknown_reference},
      {card + "5,9,123,,1\n77,123\n", "independent node set 77 is not defined", 14, Kind::unknown_reference},
      {card + "5,9,123\n1,109\n", "IDOF = 109", 14, Kind::contradiction},
      {card + "5,9,123\n" + all + "9,123\n", "node 9 follows itself", 18, Kind::contradiction},
      {card + "5,9,123\n" + all + "1,123,-2.\n", "the weight -2 is not above 0", 18, Kind::contradiction},
      {card + "5,9,123\n1,123\n2,123\n", "do not give the motion of node 9", 13, Kind::contradiction},
      {card + "5,9,6\n1,3\n2,3\n3,3\n4,3\n", "do not give the rotation of node 9", 13, Kind::contradiction},
      {card + "5,9,123\n" + all + card + "6,9,4\n" + all, "dependent one of two", 19, Kind::contradiction},
      {card + "5,9,123\n" + all + card + "6,4,1\n1,123\n2,123\n3,123\n", "independent node 4 is the dependent one", 13,
       Kind::not_calculated},
      {card + "5,9,123\n" + all + "*BOUNDARY_SPC_NODE\n9,0,1\n", "held or moved in a direction that DDOF", 13,
       Kind::contradiction},
      {card + "5,9,123\n" + all + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n9,3,2,1\n*DEFINE_CURVE\n1\n0.,0.\n1.,1.\n",
       "held or moved in a direction that DDOF", 13, Kind::contradiction},
      {card + "5,9,123\n" + all + "*BOUNDARY_SPC_NODE\n2,3,1\n*DEFINE_COORDINATE_VECTOR\n3,1.,1.,0.,-1.,1.,0.\n",
       "node 2 has conditions in local axes", 15, Kind::not_calculated},
      {rigid + card + "5,9,123\n" + all, "node 1 belongs to a rigid body", 19, Kind::not_calculated},
      {rigid + card + "5,2,123\n3,123\n4,123\n9,123\n", "node 2 belongs to a rigid body", 18, Kind::not_calculated},
      {card + "5,1,123\n2,123\n3,123\n9,123\n", "independent node 9 has no mass", 16, Kind::zero_mass},
      {bar + card + "5,9,123\n" + all + "11\n", "rotations of independent nodes (node 11)", 32, Kind::not_calculated},
      {"*CONSTRAINED_INTERPOLATION_LOCAL\n5,9,123,8\n1,123\n\n2,123\n\n3,123\n\n", "local system 8", 13,
       Kind::not_calculated},
  };
  for (const Case& one : cases) {
    const Failure failure = refused(one.cards);
    EXPECT_NE(failure.message.find(one.why), std::string::npos) << one.cards << failure.message;
    EXPECT_EQ(failure.message.find("*CONSTRAINED_INTERPOLATION"), 0u) << failure.message;
    EXPECT_EQ(failure.place.line, one.line) << one.cards << failure.message;
    EXPECT_EQ(failure.kind, one.kind) << failure.message;
  }
}

TEST(FindFollowers, HeldFreedomsThatDoNotFollowAreFine) {
  Followed scene(
      five + "*CONSTRAINED_INTERPOLATION\n5,9,12\n1,123\n2,123\n3,123\n4,123\n*BOUNDARY_SPC_NODE\n9,0,0,0,1\n", 1e-3);
  EXPECT_TRUE(scene.ready());
}

/// A free block on a follower; the run as a whole.
const std::string block = brick_bar(1, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0.3, 1) +
                          "*CONTROL_TERMINATION\n0.1\n*NODE\n9,0.5,0.5,2.\n*ELEMENT_MASS\n9,9,0.5\n"
                          "*CONSTRAINED_INTERPOLATION\n5,9,123\n5,123\n6,123\n7,123\n8,123\n";

TEST(FindFollowers, RunsWithTheWholeDeck) {
  RunScene scene(block + "*LOAD_NODE_POINT\n9,3,1,2.\n*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n");
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-3);  // the last step is another
  EXPECT_NEAR(scene.momentum().z(), 2 * (scene.state().time + scene.run().stepper().next_step() / 2), 1e-12);
}

TEST(FindFollowers, ConstraintTiesOfItsNodesAreRefused) {
  const std::string plate =
      "*NODE\n21,-1.,-1.,1.\n22,2.,-1.,1.\n23,2.,2.,1.\n24,-1.,2.,1.\n*ELEMENT_SHELL\n21,2,21,22,23,24\n"
      "*PART\nq\n2,2,1\n*SECTION_SHELL\n2,2\n0.1\n*SET_NODE_LIST\n3\n5,6,7,8\n";
  const std::string sides = "3,2,4,3\n\n\n";
  RunScene tied(block + plate + "*CONTACT_TIED_NODES_TO_SURFACE\n" + sides);
  EXPECT_FALSE(tied.prepared());
  EXPECT_NE(tied.message().find("is tied by constraints in contact 1; tie by an OFFSET form"), std::string::npos)
      << tied.message();
  RunScene springs(block + plate + "*CONTACT_TIED_NODES_TO_SURFACE_OFFSET\n" + sides);
  EXPECT_TRUE(springs.prepared()) << springs.message();
  RunScene kept(block + plate + "*CONTACT_CONSTRAINT_NODES_TO_SURFACE\n" + sides);
  EXPECT_FALSE(kept.prepared());
  EXPECT_NE(kept.message().find("which acts by constraints"), std::string::npos) << kept.message();
}

TEST(FindFollowers, SpringsNeedAMassAtTheFollower) {
  const std::string plate =
      "*NODE\n21,-1.,-1.,2.\n22,2.,-1.,2.\n23,2.,2.,2.\n24,-1.,2.,2.\n*ELEMENT_SHELL\n21,2,21,22,23,24\n"
      "*PART\nq\n2,2,1\n*SECTION_SHELL\n2,2\n0.1\n*SET_NODE_LIST\n3\n9\n"
      "*CONTACT_TIED_NODES_TO_SURFACE_OFFSET\n3,2,4,3\n\n\n";
  RunScene heavy(block + plate);
  EXPECT_TRUE(heavy.prepared()) << heavy.message();
  std::string light = block;
  const std::string mass = "*ELEMENT_MASS\n9,9,0.5\n";
  light.erase(light.find(mass), mass.size());
  RunScene scene(light + plate);
  EXPECT_FALSE(scene.prepared());
  EXPECT_NE(scene.message().find("dependent node 9 has no mass and contact 1 ties it"), std::string::npos)
      << scene.message();
}

TEST(FindFollowers, TooManyThatShareNodesAreRefused) {
  std::string nodes = "*NODE\n", cards;
  for (int i = 0; i < 1001; ++i) {
    nodes += fmt::format("{},0.,0.,{}\n", 1000 + i, i);
    cards += fmt::format("*CONSTRAINED_INTERPOLATION\n{},{},123\n1,123\n2,123\n3,123\n4,123\n", i + 1, 1000 + i);
  }
  EXPECT_NE(refused(nodes + cards).message.find("1001 interpolations share their 4 independent nodes"),
            std::string::npos);
}

TEST(FindFollowers, NodesBehindWallsAreNamed) {
  RunScene scene(block + "*RIGIDWALL_PLANAR\n0\n0.,0.,-5.,0.,0.,1.,0.\n");
  ASSERT_TRUE(scene.prepared()) << scene.message();
  bool named = false;
  for (const Diagnostic& d : scene.diagnostics().sorted())
    named = named || d.message.find("rigid walls do not stop the 1 nodes that follow others") != std::string::npos;
  EXPECT_TRUE(named);
}

/// A shell that fails when it is pulled, on nodes that node 9 follows.
std::string failing(const std::string& deletion) {
  return "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n9,0.5,0.5,1.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
         "*PART\np\n1,1,1\n" +
         shell_section +
         "*MAT_PLASTIC_KINEMATIC\n1,1.,1000.,0.,1.,0.,0.\n0.,0.,0.01\n*CONTROL_TERMINATION\n0.2\n"
         "*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,1,0,1\n3,1,0,1\n*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n4,0,1,1,1,1,1,1\n"
         "*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*CONSTRAINED_INTERPOLATION\n5,9,123,,," +
         deletion + "\n1,123\n2,123\n3,123\n4,123\n";
}

TEST(FindFollowers, ADeletedNodeEndsTheRunOrDoesNot) {
  for (const std::string deletion : {"0", "1"}) {
    RunScene ends(failing(deletion));
    ASSERT_TRUE(ends.prepared()) << ends.message();
    EXPECT_EQ(ends.try_to_go(), RunEnd::failed);
    EXPECT_NE(ends.message().find("*CONSTRAINED_INTERPOLATION 5: the last element of node 1 has failed"),
              std::string::npos)
        << ends.message();
    EXPECT_LT(ends.state().time, 0.1);
  }
  RunScene goes_on(failing("2"));
  ASSERT_TRUE(goes_on.prepared()) << goes_on.message();
  EXPECT_EQ(goes_on.try_to_go(), RunEnd::time) << goes_on.message();
  EXPECT_FALSE(goes_on.run().stepper().failures().empty());
}

}  // namespace
}  // namespace gapcheck::solver::find_followers_test
