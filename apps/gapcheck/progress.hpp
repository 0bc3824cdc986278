#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace gapcheck::app {

/// While it lives, a line on standard error says every second how long the work has taken; only on a terminal, and
/// only from the first second on. Leaves nothing behind.
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
