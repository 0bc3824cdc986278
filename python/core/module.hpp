#pragma once
#include <pybind11/pybind11.h>

// What each file of the module adds to it.
namespace gapcheck::python {

void add_report(pybind11::module_& module);
void add_columns(pybind11::module_& module);
void add_audit(pybind11::module_& module);
void add_read_motion(pybind11::module_& module);
void add_read_run(pybind11::module_& module);
void add_compare(pybind11::module_& module);
void add_fix(pybind11::module_& module);
void add_run(pybind11::module_& module);
void add_start(pybind11::module_& module);
void add_write(pybind11::module_& module);

}  // namespace gapcheck::python
