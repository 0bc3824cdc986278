#pragma once
#include <pybind11/pybind11.h>

#include <gapcheck/result.hpp>
#include <utility>

namespace gapcheck::python {

namespace py = pybind11;

/// Raises gapcheck.Error.
[[noreturn]] void raise(const api::Error& error);

/// The value of a result, or its error raised.
template <class T>
[[nodiscard]] T taken(api::Result<T> result) {
  if (!result) raise(result.error());
  return std::move(result).value();
}

/// Does work without the lock of the interpreter, and takes its result.
template <class Work>
[[nodiscard]] auto worked(const Work& work) {
  auto result = [&work] {
    const py::gil_scoped_release release;
    return work();
  }();
  return taken(std::move(result));
}

}  // namespace gapcheck::python
