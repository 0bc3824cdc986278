#include "base/work_watch.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace gapcheck::work_watch_test {
namespace {

TEST(WorkWatch, NobodyStopsWorkThatNobodyWatches) {
  EXPECT_FALSE(work_stopped());
  const std::function<bool()> none;
  const WorkWatch watch(none);
  EXPECT_FALSE(work_stopped());
  EXPECT_FALSE(watch.stopped());
}

TEST(WorkWatch, ANoHoldsAndIsNotAskedForAgain) {
  int asked = 0;
  const std::function<bool()> go_on = [&asked] { return ++asked < 3; };
  {
    const WorkWatch watch(go_on);
    EXPECT_FALSE(work_stopped());
    EXPECT_FALSE(work_stopped());
    EXPECT_FALSE(watch.stopped());
    EXPECT_TRUE(work_stopped());
    EXPECT_TRUE(work_stopped());
    EXPECT_TRUE(watch.stopped());
    EXPECT_EQ(asked, 3);
  }
  EXPECT_FALSE(work_stopped());
}

TEST(WorkWatch, EachThreadHasItsOwn) {
  const std::function<bool()> no = [] { return false; };
  const WorkWatch watch(no);
  bool other = true;
  std::thread([&other] { other = work_stopped(); }).join();
  EXPECT_FALSE(other);
  EXPECT_TRUE(work_stopped());
}

TEST(WorkWatch, OneWithoutAQuestionLeavesTheOuterOneInPlace) {
  const std::function<bool()> no = [] { return false; }, none;
  const WorkWatch outer(no);
  const WorkWatch inner(none);
  EXPECT_TRUE(work_stopped());
  EXPECT_TRUE(outer.stopped());
  EXPECT_FALSE(inner.stopped());
}

}  // namespace
}  // namespace gapcheck::work_watch_test
