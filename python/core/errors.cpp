#include "errors.hpp"

#include "convert.hpp"

namespace gapcheck::python {

void raise(const api::Error& error) {
  py::list diagnostics;
  for (const api::Diagnostic& each : error.diagnostics) diagnostics.append(py::cast(each));
  const py::object type = py::module_::import("gapcheck.errors").attr("Error");
  const py::object raised = type(text(error.message), path_text(error.file), error.line, py::tuple(diagnostics));
  PyErr_SetObject(type.ptr(), raised.ptr());
  throw py::error_already_set();
}

}  // namespace gapcheck::python
