#pragma once
#include <limits>
#include <span>
#include <string>

#include "certified.hpp"
#include "geometry/batch/pair_batch.hpp"
#include "geometry/view.hpp"
#include "methods.hpp"

namespace gapcheck::bench {

/// gapcheck's decisions for 64 pairs at once, the open ones one by one; a distance only where it counts, at nodes that
/// are nearer than the contact distance.
struct CertifiedBatch {
  [[nodiscard]] static std::string name() { return "certified batches"; }

  static void run(const Pairs& pairs, std::span<Answer<double>> answers) {
    for (const bool triangles : {false, true}) {
      geometry::PairBatch batch(triangles);
      std::array<std::size_t, geometry::PairBatch::capacity> members{};
      const auto finish = [&] {
        batch.decide();
        for (std::size_t i = 0; i < batch.size(); ++i)
          answers[members[i]] = answer(batch, i, pairs.in_double[members[i]]);
        batch.clear();
      };
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        const ContactPair<double>& pair = pairs.in_double[p];
        if (pair.triangle != triangles) continue;
        members[batch.size()] = p;
        batch.add(geometry::seen_from({pair.x, pair.triangle}, pair.query), pair.bound);
        if (batch.full()) finish();
      }
      finish();
    }
  }

 private:
  static Answer<double> answer(const geometry::PairBatch& batch, std::size_t i, const ContactPair<double>& pair) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (batch.located(i)) return {std::sqrt(batch.squared_distance(i)), true};
    const geometry::Verdict verdict = batch.verdict(i);
    if (verdict == geometry::Verdict::apart) return {none, false};
    const geometry::Facet facet{pair.x, pair.triangle};
    const auto closest = geometry::closest_point(facet, pair.query);
    const bool closer = verdict == geometry::Verdict::closer ||
                        geometry::decide(facet, pair.query, pair.bound, geometry::Mode::filtered, &closest).closer;
    return {closer ? std::sqrt(closest.squared_distance) : none, closer};
  }
};

}  // namespace gapcheck::bench
