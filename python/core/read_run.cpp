#include <gapcheck/read_run.hpp>
#include <span>
#include <string>
#include <vector>

#include "errors.hpp"
#include "callback.hpp"
#include "module.hpp"
#include "options.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

api::Report run_report(const py::object& paths, const py::dict& options) {
  py::dict both;
  both["paths"] = paths;
  std::vector<std::string> files;
  Options(both).take_paths("paths", files);
  const Options given(options);
  api::RunReadOptions read;
  given.take_path("d3hsp", read.d3hsp);
  given.take_path("d3plot", read.d3plot);
  given.take_paths("message_tables", read.message_tables);
  given.take("contacts", read.contacts);
  given.take("ptol", read.ptol);
  given.take("rtol", read.rtol);
  given.take("select", read.select);
  given.take("ignore", read.ignore);
  given.take_jobs(read.jobs);
  return interruptible(read, [&] { return api::read_run(files, read); });
}

/// A view into a curve, which its Curves keeps alive.
py::array numbers(const py::object& curve, std::vector<double> api::Curve::*member) {
  return view(std::span<const double>(curve.cast<const api::Curve&>().*member), curve);
}

}  // namespace

void add_read_run(py::module_& module) {
  using api::Curve, api::Curves;
  Record<Curve>(module, "Curve", "One quantity of a run over time, in the units of the model.")
      .add("name", &Curve::name, "'rcforc contact 3 side A x-force'; unique in the run")
      .add("file", &Curve::file, "'rcforc'")
      .add("quantity", &Curve::quantity, "'force'")
      .add("contact", &Curve::contact, "id; 0: of no contact")
      .call(
          "times", [](const py::object& self) { return numbers(self, &Curve::times); }, "n, ascending")
      .call(
          "values", [](const py::object& self) { return numbers(self, &Curve::values); }, "n, finite")
      .add("not_numbers", &Curve::not_numbers, "NaN values of the file, left out");
  Record<Curves>(module, "Curves", "The curves of a run; gapcheck.Curves is made around it.")
      .add_list("curves", &Curves::curves)
      .add("complete", &Curves::complete)
      .add_list("diagnostics", &Curves::diagnostics);
  module.def("read_run", run_report);
  module.def("read_curves", [](const py::object& path) {
    const std::string directory = path_of(path);
    return worked([&] { return api::read_curves(directory); });
  });
}

}  // namespace gapcheck::python
