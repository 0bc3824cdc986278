// gapcheck._core: the C++ interface as it is, for the package around it. Paths are str, bytes or os.PathLike; options
// come as a dict; everything else is checked here, so that no value can end the interpreter.
#include "module.hpp"

#include <gapcheck/version.hpp>
#include <string>

PYBIND11_MODULE(_core, module) {
  module.doc() = "The C++ interface of gapcheck; use the package gapcheck.";
  module.attr("version") = std::string(gapcheck::api::version());
  gapcheck::python::add_report(module);
  gapcheck::python::add_columns(module);
  gapcheck::python::add_audit(module);
  gapcheck::python::add_read_motion(module);
  gapcheck::python::add_read_run(module);
  gapcheck::python::add_compare(module);
  gapcheck::python::add_fix(module);
  gapcheck::python::add_run(module);
  gapcheck::python::add_start(module);
  gapcheck::python::add_write(module);
}
