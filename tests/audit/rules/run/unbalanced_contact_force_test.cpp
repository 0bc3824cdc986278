#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::unbalanced_contact_force_test {
namespace {

TEST(UnbalancedContactForce, NamesTheWorstTime) {
  JudgedRun run;
  run.rcforc(0, 3, Vector(0, 0, 0), Vector(0, 0, 0));
  run.rcforc(1, 3, Vector(1000, 0, 0), Vector(-900, 0, 0));
  run.rcforc(2, 3, Vector(2000, 0, 0), Vector(-1999, 0, 0));
  const Finding f = run.finding("GC607");
  EXPECT_EQ(f.contact, 3);
  EXPECT_EQ(f.file, "out/rcforc");
  EXPECT_EQ(f.message, "the forces on side A and side B add up to 100 at time 1; the largest force is 2000");
}

TEST(UnbalancedContactForce, PrintingTransducersAndOneSidedForcesAreNone) {
  JudgedRun run;
  run.rcforc(1, 3, Vector(1234.56, 0.001, 0), Vector(-1234.57, 0, 0));
  run.rcforc(1, 4, Vector(1000, 0, 0), Vector(0, 0, 0));
  run.rcforc(1, 5, Vector(1000, 0, 0), Vector(-300, 0, 0));
  run.rcforc(1, 6, Vector(no_number, 0, 0), Vector(-300, 0, 0));
  run.contacts.resize(1);
  run.contacts[0].id = 5;
  run.contacts[0].type = "25";
  EXPECT_TRUE(run.findings("GC607").empty());
  run.contacts[0].type = "a3";
  EXPECT_EQ(run.finding("GC607").contact, 5);
  run.only = {3};
  EXPECT_TRUE(run.findings("GC607").empty());
}

TEST(UnbalancedContactForce, WithoutForces) {
  JudgedRun run;
  EXPECT_TRUE(run.findings("GC607").empty());
  EXPECT_EQ(run.skips.size(), 1u);
}

}  // namespace
}  // namespace gapcheck::audit_test::unbalanced_contact_force_test
