#include "options.hpp"

#include <utility>

#include "convert.hpp"

namespace gapcheck::python {

py::object Options::value(const char* name) const {
  return given_.contains(name) ? py::object(given_[name]) : py::none();
}

void Options::refuse(const char* name, py::handle value, const char* wanted) {
  const std::string type = py::str(py::type::of(value).attr("__name__"));
  // What cannot be shown, or not in ASCII, is escaped.
  std::string shown = py::module_::import("builtins").attr("ascii")(value).cast<std::string>();
  if (shown.size() > 60) shown = "…";
  throw py::type_error(std::string(name) + ": " + wanted + " is needed, not " + shown + " (" + type + ")");
}

py::list Options::entries(const py::object& given) {
  py::list list;
  const bool many = py::isinstance<py::iterable>(given) && !py::isinstance<py::str>(given) &&
                    !py::isinstance<py::bytes>(given) && PyObject_HasAttrString(given.ptr(), "__fspath__") == 0;
  // An array without dimensions says that it can be iterated, and raises.
  if (many)
    for (const py::handle each : py::iter(given)) list.append(each);
  else
    list.append(given);
  return list;
}

void Options::take(const char* name, std::map<std::string, api::Severity>& to) const {
  const py::object given = value(name);
  if (given.is_none()) return;
  constexpr const char* wanted = "a dict of \"note\", \"warning\" or \"error\" by rule";
  if (!py::isinstance<py::dict>(given)) refuse(name, given, wanted);
  for (const auto& [rule, severity] : given.cast<py::dict>()) {
    if (!py::isinstance<py::str>(rule) || !py::isinstance<py::str>(severity)) refuse(name, given, wanted);
    const auto word = severity.cast<std::string>();
    if (word != "note" && word != "warning" && word != "error") refuse(name, severity, wanted);
    to[rule.cast<std::string>()] = word == "note"      ? api::Severity::note
                                   : word == "warning" ? api::Severity::warning
                                                       : api::Severity::error;
  }
}

void Options::take_path(const char* name, std::string& to) const {
  if (const py::object given = value(name); !given.is_none()) to = path_of(given);
}

void Options::take_paths(const char* name, std::vector<std::string>& to) const {
  const py::object given = value(name);
  if (given.is_none()) return;
  to.clear();
  for (const py::handle each : entries(given)) to.push_back(path_of(each));
}

void Options::take(api::Includes& to) const {
  take_paths("includes", to.directories);
  take("skip_missing", to.skip_missing);
  take("parameters", to.parameters);
}

void Options::take_jobs(std::size_t& to) const {
  constexpr std::size_t most = 4096;
  take("jobs", to);
  if (to > most) throw py::value_error("jobs: at most 4096 threads can be asked for");
}

py::object Options::function(const char* name) const {
  py::object given = value(name);
  if (!given.is_none() && PyCallable_Check(given.ptr()) == 0) refuse(name, given, "a function");
  return given;
}

}  // namespace gapcheck::python
