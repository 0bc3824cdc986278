#pragma once
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <gapcheck/includes.hpp>
#include <gapcheck/result.hpp>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace gapcheck::python {

namespace py = pybind11;

/// The options of a call by their names. What is not there, or None, keeps its default; a value of another type raises
/// TypeError with the option's name.
class Options {
 public:
  explicit Options(py::dict given) : given_(std::move(given)) {}

  void take(const char* name, bool& to) const { cast_to(name, to, "True or False"); }
  void take(const char* name, double& to) const { cast_to(name, to, "a number"); }
  void take(const char* name, std::optional<double>& to) const { cast_to(name, to, "a number"); }
  void take(const char* name, std::size_t& to) const { cast_to(name, to, "a whole number of 0 or more"); }
  void take(const char* name, std::string& to) const { cast_to(name, to, "a str"); }
  void take(const char* name, std::vector<std::int64_t>& to) const { list_to(name, to, "a list of whole numbers"); }
  void take(const char* name, std::vector<std::size_t>& to) const {
    list_to(name, to, "a list of whole numbers of 0 or more");
  }
  void take(const char* name, std::vector<std::string>& to) const { list_to(name, to, "a list of str"); }
  void take(const char* name, std::map<std::int64_t, double>& to) const {
    cast_to(name, to, "a dict of numbers by id");
  }
  void take(const char* name, std::map<std::string, api::Severity>& to) const;
  void take_path(const char* name, std::string& to) const;
  void take_paths(const char* name, std::vector<std::string>& to) const;
  /// "includes", "skip_missing" and "parameters".
  void take(api::Includes& to) const;
  /// "jobs", up to 4096.
  void take_jobs(std::size_t& to) const;
  /// A callable or None.
  [[nodiscard]] py::object function(const char* name) const;
  /// None: it is not given.
  [[nodiscard]] py::object value(const char* name) const;
  [[noreturn]] static void refuse(const char* name, py::handle value, const char* wanted);

 private:
  /// Whole numbers must be whole: pybind11 takes anything that has an __int__, and cuts what is behind the point.
  template <class T>
  [[nodiscard]] static T one(py::handle given) {
    if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
      const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
      if (index) return index.cast<T>();
      PyErr_Clear();
      throw py::cast_error();
    } else {
      return given.cast<T>();
    }
  }
  template <class T>
  void cast_to(const char* name, T& to, const char* wanted) const {
    const py::object given = value(name);
    if (given.is_none()) return;
    try {
      to = one<T>(given);
    } catch (const py::cast_error&) {
      refuse(name, given, wanted);
    }
  }
  /// Any iterable, or one entry for a list of one.
  template <class T>
  void list_to(const char* name, std::vector<T>& to, const char* wanted) const {
    const py::object given = value(name);
    if (given.is_none()) return;
    to.clear();
    for (const py::handle each : entries(given)) {
      try {
        to.push_back(one<T>(each));
      } catch (const py::cast_error&) {
        refuse(name, each, wanted);
      }
    }
  }
  [[nodiscard]] static py::list entries(const py::object& given);

  py::dict given_;
};

}  // namespace gapcheck::python
