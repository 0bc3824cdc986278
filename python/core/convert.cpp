#include "convert.hpp"

namespace gapcheck::python {
namespace {

py::str decoded(PyObject* made) {
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(made);
}

}  // namespace

py::str text(std::string_view bytes) {
  return decoded(PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

py::str path_text(std::string_view bytes) {
  return decoded(PyUnicode_DecodeFSDefaultAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size())));
}

py::list path_texts(const std::vector<std::string>& paths) {
  py::list list;
  for (const std::string& path : paths) list.append(path_text(path));
  return list;
}

std::string path_of(py::handle given) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(given.ptr(), &bytes) == 0) throw py::error_already_set();
  return std::string(py::reinterpret_steal<py::bytes>(bytes));
}

}  // namespace gapcheck::python
