// Random scenes: slow search = fast search, exact = filtered, any number of threads.
#include "audit/random_scene.hpp"

#include <gtest/gtest.h>

#include "audit/run.hpp"
#include "base/parallel.hpp"

namespace gapcheck::audit_test::random_scene_test {
namespace {

constexpr std::uint64_t scenes = 200;

std::string audited(const Scene& scene, const audit::AuditOptions& options = {}) {
  const AuditRun run = run_text(scene.text(), options);
  EXPECT_TRUE(clean(run));
  return dump(run.report);
}

TEST(RandomScene, SlowSearchFindsTheSame) {
  audit::AuditOptions slow;
  slow.brute_force = true;
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    const std::string fast = audited(scene);
    ASSERT_EQ(fast, audited(scene, slow)) << "seed " << seed;
    for (std::size_t at = 0; (at = fast.find(" depth ", at)) != std::string::npos; ++at) ++found;
  }
  EXPECT_GT(found, 2000U) << "the scenes must have something to find";
}

TEST(RandomScene, ExactDecisionsAreTheSame) {
  audit::AuditOptions exact;
  exact.exact = true;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    ASSERT_EQ(audited(scene), audited(scene, exact)) << "seed " << seed;
  }
}

TEST(RandomScene, ThreadsChangeNothing) {
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    std::string one, two;
    {
      const JobLimit limit(1);
      one = audited(scene);
    }
    {
      const JobLimit limit(2);
      two = audited(scene);
    }
    ASSERT_EQ(one, two) << "seed " << seed;
  }
}

}  // namespace
}  // namespace gapcheck::audit_test::random_scene_test
