#include "contact/definition/active_time.hpp"

#include <gtest/gtest.h>

namespace gapcheck::contact::active_time_test {
namespace {

ActiveTime times(double birth, double death) {
  model::Contact contact;
  contact.birth = birth;
  contact.death = death;
  return active_time(contact);
}

TEST(ActiveTime, SignsOfBirthAndDeath) {
  const struct {
    double birth, death, start, end;
  } cases[] = {{0, 1e20, 0, 1e20}, {2, 5, 2, 5}, {-2, 5, 0, 5}, {-2, -5, 2, 5}, {2, -5, 2, 5}};
  for (const auto& test : cases) {
    const ActiveTime time = times(test.birth, test.death);
    EXPECT_EQ(time.start, test.start) << test.birth << " " << test.death;
    EXPECT_EQ(time.end, test.end) << test.birth << " " << test.death;
    EXPECT_FALSE(time.by_curve);
  }
  EXPECT_TRUE(times(7, -9999).by_curve);
}

}  // namespace
}  // namespace gapcheck::contact::active_time_test
