#include "progress.hpp"

#include <chrono>
#include <cstdio>
#include <system_error>
#include <utility>

#include "base/system/terminal.hpp"

namespace gapcheck::app {

Progress::Progress(std::string what, bool wanted) {
  if (!wanted || !system::obeys_escapes(system::standard_error)) return;
  try {
    thread_ = std::thread([this, what = std::move(what)] { run(what); });
  } catch (const std::system_error&) {
    // No thread is to be had: then without the line.
  }
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Progress::run(const std::string& what) {
  std::unique_lock lock(mutex_);
  int seconds = 0;
  while (!changed_.wait_for(lock, std::chrono::seconds(1), [this] { return done_; }))
    std::fprintf(stderr, "\rgapcheck: %s: %d s", what.c_str(), ++seconds);
  if (seconds > 0) std::fputs("\r\x1b[K", stderr);
}

}  // namespace gapcheck::app
