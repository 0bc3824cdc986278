#pragma once
#include <pybind11/pybind11.h>

#include <gapcheck/result.hpp>
#include <utility>

#include "kept_memory.hpp"

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

/// Does work without the lock of the interpreter.
template <class Work>
[[nodiscard]] auto without_lock(const Work& work) {
  const py::gil_scoped_release release;
  const KeptMemory memory;
  return work();
}

/// The same, and takes its result.
template <class Work>
[[nodiscard]] auto worked(const Work& work) {
  return taken(without_lock(work));
}

}  // namespace gapcheck::python
