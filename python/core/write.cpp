#include <gapcheck/report.hpp>
#include <gapcheck/write.hpp>
#include <map>
#include <string>

#include "errors.hpp"
#include "module.hpp"
#include "options.hpp"

namespace gapcheck::python {
namespace {

api::Format format_of(const std::string& name) {
  static const std::map<std::string, api::Format> formats{
      {"text", api::Format::text},   {"json", api::Format::json},     {"sarif", api::Format::sarif},
      {"junit", api::Format::junit}, {"github", api::Format::github}, {"gitlab", api::Format::gitlab},
      {"csv", api::Format::csv},     {"html", api::Format::html},     {"vtu", api::Format::vtu}};
  const auto found = formats.find(name);
  if (found == formats.end()) throw py::value_error("there is no format '" + name + "'");
  return found->second;
}

api::WriteOptions write_options(const Options& given) {
  api::WriteOptions options;
  given.take("top", options.top);
  given.take("list", options.list);
  given.take("statistics", options.statistics);
  std::string fail_on = "error";
  given.take("fail_on", fail_on);
  if (fail_on == "never")
    options.fail_on.reset();
  else if (fail_on == "note" || fail_on == "warning")
    options.fail_on = fail_on == "note" ? api::Severity::note : api::Severity::warning;
  else if (fail_on != "error")
    throw py::value_error("fail_on: 'note', 'warning', 'error' or 'never' is needed, not '" + fail_on + "'");
  return options;
}

}  // namespace

void add_write(py::module_& module) {
  module.def("write", [](const api::Report& report, const std::string& format, const py::dict& given) {
    const api::Format chosen = format_of(format);
    const api::WriteOptions options = write_options(Options(given));
    const std::string text = without_lock([&] { return api::write(report, chosen, options); });
    return py::bytes(text);
  });
}

}  // namespace gapcheck::python
