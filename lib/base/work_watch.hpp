#pragma once
#include <functional>

namespace gapcheck {

/// While it lives, long work of its thread asks it now and then whether to go on (work_stopped()). After a no, loops
/// end as soon as they can, and what the work gives must not be used.
class WorkWatch {
 public:
  /// `go_on`: called by this thread, outlives this, must not throw. Empty: the work is not watched.
  explicit WorkWatch(const std::function<bool()>& go_on) : go_on_(go_on), before_(current_) {
    if (go_on_) current_ = this;
  }
  ~WorkWatch() { current_ = before_; }
  WorkWatch(const WorkWatch&) = delete;
  WorkWatch& operator=(const WorkWatch&) = delete;

  /// It has said no.
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  friend bool work_stopped();

  const std::function<bool()>& go_on_;
  WorkWatch* before_;
  bool stopped_ = false;
  static inline thread_local WorkWatch* current_ = nullptr;
};

/// True: the work of this thread is to end. Not for the bodies of parallel loops, which may be the work of another
/// thread. Costs nothing where nobody watches.
[[nodiscard]] inline bool work_stopped() {
  WorkWatch* const watch = WorkWatch::current_;
  if (watch == nullptr) return false;
  if (!watch->stopped_) watch->stopped_ = !watch->go_on_();
  return watch->stopped_;
}

}  // namespace gapcheck
