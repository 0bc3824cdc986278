// Ties give the same bits for any number of threads.
#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "solver/tie/tie_scene.hpp"

namespace gapcheck::solver::tie_threads_test {
namespace {

TEST(TieThreads, SameBits) {
  for (const char* keyword :
       {"TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"}) {
    const TieDeck::Grid base{1, {0, 0, 0}, {10, 10, 0.1}, 12, 12, 0}, upper{2, {0.3, 0.3, 0.2}, {9, 9, 0.1}, 17, 17, 0};
    const std::string text = TieDeck()
                                 .add(base)
                                 .add(upper)
                                 .tie(keyword, TieDeck::nodes(upper, -1), 1, 0.5)
                                 .load({2001}, 3, 1e-4)
                                 .load({2018}, 1, 1e-3)
                                 .text(1e9);
    RunSettings settings;
    settings.cycles = 6;
    const auto places = [&](std::size_t jobs) {
      const JobLimit limit(jobs);
      RunScene scene(text, settings);
      EXPECT_TRUE(scene.prepared()) << scene.message();
      if (scene.prepared()) scene.go();
      EXPECT_GT(scene.run().contacts().front().nodes().size(), 300u);
      return scene.state().x;
    };
    const std::vector<Vector> alone = places(1);
    EXPECT_EQ(alone, places(2)) << keyword;
    EXPECT_EQ(alone, places(7)) << keyword;
  }
}

}  // namespace
}  // namespace gapcheck::solver::tie_threads_test
