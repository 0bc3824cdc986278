#pragma once
#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "errors.hpp"

namespace gapcheck::python {

namespace py = pybind11;

/// Calls a function of Python, or none, from work that runs without the lock of the interpreter, and lets signals
/// arrive. What is raised meanwhile, by the function or by Ctrl-C, ends the work and is raised again behind it.
class Callback {
 public:
  /// `function`: a callable, or None.
  explicit Callback(py::object function) : function_(std::move(function)) {
    if (!function_.is_none() && PyCallable_Check(function_.ptr()) == 0)
      throw py::type_error("a function is needed, not " +
                           std::string(py::str(py::type::of(function_).attr("__name__"))));
  }
  /// `arguments`: gives the tuple to call with. False: the work is to end.
  template <class Arguments>
  [[nodiscard]] bool operator()(const Arguments& arguments) {
    if (raised_) return false;
    if (function_.is_none() && !due()) return true;
    const py::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (function_.is_none()) return true;
      return function_(*arguments()).ptr() != Py_False;
    } catch (const py::error_already_set& error) {
      raised_.emplace(error);
      return false;
    }
  }
  void raise_again() const {
    if (raised_) throw py::error_already_set(*raised_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// Signals are looked for every few milliseconds; taking the lock in each cycle of a run would cost more.
  [[nodiscard]] bool due() {
    if (Clock::now() < next_) return false;
    next_ = Clock::now() + std::chrono::milliseconds(20);
    return true;
  }

  py::object function_;
  std::optional<py::error_already_set> raised_;
  Clock::time_point next_{};
};

/// Does work whose options have a `watch`, without the lock of the interpreter, and takes its result. Ctrl-C ends it.
template <class Options, class Work>
[[nodiscard]] auto interruptible(Options& options, const Work& work) {
  Callback signals{py::none()};
  options.watch = [&signals] { return signals([] { return py::tuple(); }); };
  auto result = without_lock(work);
  signals.raise_again();
  return taken(std::move(result));
}

}  // namespace gapcheck::python
