#pragma once
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstddef>
#include <functional>

// The thread sanitizer does not see how oneTBB, which is not compiled with it, lets threads wait for each other, and
// would report races that are none. With it the loops run on std::thread, so that what it reports is a race of ours.
#if defined(__SANITIZE_THREAD__)
#define GAPCHECK_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define GAPCHECK_PLAIN_THREADS
#endif
#endif
#ifdef GAPCHECK_PLAIN_THREADS
#include <atomic>
#include <thread>
#include <vector>
#endif

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

/// With a limit of one, nothing here starts a thread: oneTBB would even then, and end the process where none is to be
/// had.
inline bool one_thread() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) <= 1;
}

/// Calls body(begin, end) on disjoint pieces of [0, count), in any order and on any thread. The pieces are at least
/// `grain` long if possible. The body must not depend on how the range is split.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
  if (count == 0) return;
  if (count <= grain || one_thread()) {
    body(std::size_t{0}, count);
    return;
  }
#ifdef GAPCHECK_PLAIN_THREADS
  std::atomic<std::size_t> next{0};
  const std::size_t pieces = (count + grain - 1) / std::max<std::size_t>(1, grain);
  const std::size_t limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const auto work = [&] {
    for (std::size_t piece = next++; piece < pieces; piece = next++)
      body(piece * grain, std::min(count, (piece + 1) * grain));
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < std::min({pieces, limit, std::size_t{8}}); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
#else
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const auto& range) { body(range.begin(), range.end()); });
#endif
}

/// Sorts by a strict order; equal items come in no particular order.
template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator first, Iterator last, const Less& less = {}) {
#ifdef GAPCHECK_PLAIN_THREADS
  std::sort(first, last, less);
#else
  if (one_thread())
    std::sort(first, last, less);
  else
    tbb::parallel_sort(first, last, less);
#endif
}

}  // namespace gapcheck
