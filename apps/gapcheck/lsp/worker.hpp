#pragma once
#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace gapcheck::app::lsp {

/// A thread that does the newest of the jobs that it is given: one that waits is dropped, and one that runs is asked to
/// stop.
class Worker {
 public:
  /// False: a newer job waits, or the server ends.
  using GoOn = std::function<bool()>;
  using Job = std::function<void(const GoOn&)>;
  Worker() : thread_([this] { work(); }) {}
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
      next_.reset();
      ++number_;
    }
    wake_.notify_all();
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void start(Job job) {
    {
      const std::lock_guard lock(mutex_);
      next_ = std::move(job);
      ++number_;
    }
    wake_.notify_all();
  }

 private:
  void work() {
    for (;;) {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ended_ || next_; });
      if (ended_) return;
      const Job job = std::move(*next_);
      next_.reset();
      const std::uint64_t own = number_;
      lock.unlock();
      try {
        job([this, own] { return number_ == own; });
      } catch (const std::exception&) {
        // Too little memory: the editor keeps what it has, and the next job may have enough.
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Job> next_;
  std::atomic<std::uint64_t> number_{0};
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace gapcheck::app::lsp
