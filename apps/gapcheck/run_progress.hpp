#pragma once
#include <string>

#include "solver/run.hpp"

namespace gapcheck::app {

/// A line on standard error that says how far a run is; only on a terminal, twice a second at most.
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
