#pragma once
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <gapcheck/result.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "convert.hpp"

namespace gapcheck::python {

namespace py = pybind11;

[[nodiscard]] inline const char* name(api::Severity severity) {
  return severity == api::Severity::note ? "note" : severity == api::Severity::warning ? "warning" : "error";
}

/// A member as Python has it: strings are words, severities their names, lists of numbers arrays.
template <class Value>
[[nodiscard]] py::object python_value(const Value& value) {
  if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, std::string_view>)
    return text(value);
  else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    py::list list;
    for (const std::string& each : value) list.append(text(each));
    return py::tuple(list);
  } else if constexpr (std::is_same_v<Value, api::Severity>)
    return py::str(name(value));
  else if constexpr (std::is_same_v<Value, std::vector<double>>)
    return py::array_t<double>(static_cast<py::ssize_t>(value.size()), value.data());
  else
    return py::cast(value);
}

/// A struct of the C++ interface as a class with attributes that cannot be set. Its `_fields` are their names, in the
/// order in which they are added.
template <class T>
class Record {
 public:
  Record(py::module_& module, const char* name, const char* doc) : class_(module, name, doc) {
    class_.def("__repr__",
               [](const py::object& self) { return py::module_::import("gapcheck.tables").attr("record_repr")(self); });
  }
  ~Record() { class_.attr("_fields") = py::tuple(fields_); }
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  template <class Value>
  Record& add(const char* name, Value T::*member, const char* doc = "") {
    return call(
        name, [member](const T& self) { return python_value(self.*member); }, doc);
  }
  Record& add_path(const char* name, std::string T::*member, const char* doc = "") {
    return call(
        name, [member](const T& self) { return path_text(self.*member); }, doc);
  }
  /// A list of other records, which it keeps alive.
  template <class Other>
  Record& add_list(const char* name, std::vector<Other> T::*member, const char* doc = "") {
    return call(
        name,
        [member](const py::object& self) {
          py::list list;
          for (const Other& each : self.cast<const T&>().*member)
            list.append(py::cast(each, py::return_value_policy::reference_internal, self));
          return py::object(py::tuple(list));
        },
        doc);
  }
  template <class Function>
  Record& call(const char* name, const Function& function, const char* doc = "") {
    class_.def_property_readonly(name, function, doc);
    fields_.append(name);
    return *this;
  }
  [[nodiscard]] py::class_<T>& type() { return class_; }

 private:
  py::class_<T> class_;
  py::list fields_;
};

}  // namespace gapcheck::python
