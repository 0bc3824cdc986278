#pragma once
#include <string>

#include "solver/run.hpp"

namespace gapcheck::app {

/// A progress line for a run on standard error; only on a terminal, at most twice a second.
class RunProgress {
 public:
  explicit RunProgress(bool wanted);
  ~RunProgress();
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;
  void show(const solver::Run& run);

 private:
  bool wanted_, shown_ = false;
  double last_ = 0;  ///< seconds of the run
};

/// "1 h 02 min", "3 min 05 s", "12 s".
[[nodiscard]] std::string duration(double seconds);

}  // namespace gapcheck::app
