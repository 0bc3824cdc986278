#include "audit/fix/wall_hits.hpp"

#include <random>

#include "audit/fix/run_fix.hpp"
#include "audit/rules/rule_deck.hpp"
#include "contact/rigid_wall.hpp"

namespace gapcheck::audit_test::wall_hits_test {
namespace {

RuleDeck sheet(double z) {
  RuleDeck deck;
  deck.shell_part(1, 1);
  deck.plate(1, 1, 4, 4, Vector(-2, -2, z), 1, 1);
  return deck;
}

// After random moves of some nodes the search finds what looking at every node of every wall finds.
TEST(WallSearch, AgreesWithLookingAtAllNodes) {
  RuleDeck deck = sheet(0.1);
  deck.raw("RIGIDWALL_PLANAR", "0,0,0,0\n0.,0.,0.,0.2,0.1,1.\n");
  deck.raw("RIGIDWALL_GEOMETRIC_SPHERE", "0,0,0,0\n1.,0.,0.,1.,0.,1.\n1.2\n");
  deck.raw("RIGIDWALL_GEOMETRIC_CYLINDER", "0,0,0,0\n0.,-5.,-1.,0.,1.,-1.\n1.5,0.\n");
  const model::Model model = model_of(deck.text());
  ASSERT_EQ(model.rigid_walls.size(), 3u);
  audit::WallSearch search(model);
  std::mt19937_64 random(1);
  std::size_t found = 0;
  for (int round = 0; round < 50; ++round) {
    std::vector<Vector> x = model.mesh.nodes.x;
    for (Vector& p : x)
      if (random() % 3 == 0) p.z() += 1e-3 * static_cast<double>(random() % 1000) - 0.5;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all, listed;
    for (std::uint32_t w = 0; w < 3; ++w)
      for (std::uint32_t n = 0; n < x.size(); ++n)
        if (contact::wall_penetration(model.rigid_walls[w], x[n])) all.emplace_back(w, n);
    for (const audit::WallHit& hit : search.at(x)) {
      listed.emplace_back(hit.wall, hit.node.value);
      EXPECT_NEAR((x[hit.node.value] + hit.depth * hit.normal - hit.surface).norm(), 0, 1e-12);
    }
    EXPECT_EQ(listed, all) << round;
    found += all.size();
  }
  EXPECT_GT(found, 500u);
}

TEST(WallSearch, LeavesOutWallsThatAreBornLaterAndNodesThatTheyDoNotSee) {
  RuleDeck late = sheet(-0.1), set = sheet(-0.1);
  late.raw("RIGIDWALL_PLANAR", "0,0,0,0.,1.\n0.,0.,0.,0.,0.,1.\n");
  set.raw("SET_NODE_LIST", "5\n1,2,3\n").raw("RIGIDWALL_PLANAR", "5,0,0,0\n0.,0.,0.,0.,0.,1.\n");
  const model::Model unborn = model_of(late.text()), some = model_of(set.text());
  ASSERT_GT(unborn.rigid_walls.at(0).birth, 0);
  EXPECT_TRUE(audit::WallSearch(unborn).at(unborn.mesh.nodes.x).empty());
  EXPECT_EQ(audit::WallSearch(some).at(some.mesh.nodes.x).size(), 3u);
}

}  // namespace
}  // namespace gapcheck::audit_test::wall_hits_test
