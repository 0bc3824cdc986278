#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <utility>

namespace gapcheck::app::lsp {

/// What the server's thread has to do, from other threads. Those that read messages wait while it is full.
class Inbox {
 public:
  static constexpr std::size_t most = 256;
  using Task = std::function<void()>;

  void post(Task task, bool wait_for_room = false) {
    std::unique_lock lock(mutex_);
    if (wait_for_room) room_.wait(lock, [this] { return tasks_.size() < most; });
    tasks_.push_back(std::move(task));
    lock.unlock();
    ready_.notify_one();
  }
  /// Waits for the next task.
  [[nodiscard]] Task next() {
    std::unique_lock lock(mutex_);
    ready_.wait(lock, [this] { return !tasks_.empty(); });
    Task task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    room_.notify_one();
    return task;
  }

 private:
  std::mutex mutex_;
  std::condition_variable ready_, room_;
  std::deque<Task> tasks_;
};

}  // namespace gapcheck::app::lsp
