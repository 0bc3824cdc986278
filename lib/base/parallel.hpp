#pragma once
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace gapcheck {

/// While it lives, parallel loops use at most `jobs` threads (0 = as many as the machine has).
class JobLimit {
 public:
  explicit JobLimit(std::size_t jobs)
      : control_(tbb::global_control::max_allowed_parallelism,
                 jobs > 0 ? jobs : static_cast<std::size_t>(std::max(1, tbb::info::default_concurrency()))) {}

 private:
  tbb::global_control control_;
};

/// Calls body(begin, end) on disjoint pieces of [0, count), in any order and on any thread. The pieces are at least
/// `grain` long if possible. The body must not depend on how the range is split.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
  if (count == 0) return;
  if (count <= grain) {
    body(std::size_t{0}, count);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const auto& range) { body(range.begin(), range.end()); });
}

}  // namespace gapcheck
