#include "solver/contact/contact_spring.hpp"

#include <gtest/gtest.h>

namespace gapcheck::solver::contact_spring_test {
namespace {

// VDC / 100 · 2 m ω with m the smaller mass and ω² = k (m1 + m2) / (m1 m2): ω = 2.5 for k = 5, m1 = 1, m2 = 4.
TEST(ContactSprings, DampingIsAPercentageOfTheCriticalOne) {
  for (const auto& [node, segment] : {std::pair{1., 4.}, {4., 1.}}) {
    const ContactSprings::Spring spring{5, node, segment};
    EXPECT_NEAR(ContactSprings::damping(spring, 20), 0.2 * 2 * 1 * 2.5, 1e-15);
    EXPECT_NEAR(ContactSprings::damping(spring, 100), 2 * 2.5, 1e-14);
    EXPECT_EQ(ContactSprings::damping(spring, 0), 0);
    EXPECT_EQ(ContactSprings::damping(spring, -20), 0);
  }
  EXPECT_EQ(ContactSprings::damping({5, 0, 4}, 20), 0);
  EXPECT_EQ(ContactSprings::damping({5, 1, 0}, 20), 0);
}

}  // namespace
}  // namespace gapcheck::solver::contact_spring_test
