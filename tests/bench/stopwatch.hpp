#pragma once
#include <ctime>

namespace gapcheck::bench {

/// Seconds of the calling thread on a processor: what other programs on the machine take does not count.
class Stopwatch {
 public:
  /// Since it was made or last read.
  [[nodiscard]] double lap() {
    const double now = thread_seconds(), seconds = now - last_;
    last_ = now;
    return seconds;
  }

 private:
  static double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double last_ = thread_seconds();
};

}  // namespace gapcheck::bench
