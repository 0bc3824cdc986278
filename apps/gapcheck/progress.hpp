#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace gapcheck::app {

/// While it lives, a line on standard error shows every second how long the work has taken; only on a terminal, and
/// only after the first second. The line is erased at the end.
class Progress {
 public:
  Progress(std::string what, bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  void run(const std::string& what);
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace gapcheck::app
