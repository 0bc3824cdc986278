#pragma once
#include "base/diagnostic.hpp"
#include "base/result.hpp"

namespace gapcheck::app {

/// What goes wrong in one call of a program, where it goes on all the same: each error is printed as it comes up.
class Failures {
 public:
  using Print = void (*)(const Diagnostic&);
  explicit Failures(Print print) : print_(print) {}

  void add(const Diagnostic& error) {
    print_(error);
    any_ = true;
  }
  void add(const Status& status) {
    if (!status.ok()) add(status.error());
  }
  /// Counts errors among diagnostics that are printed elsewhere.
  void count(const Diagnostics& diagnostics) { any_ = any_ || diagnostics.has_errors(); }
  /// Counts those that others have printed.
  void count(const Failures& others) { any_ = any_ || others.any_; }
  [[nodiscard]] bool any() const { return any_; }

 private:
  Print print_;
  bool any_ = false;
};

}  // namespace gapcheck::app
