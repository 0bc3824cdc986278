#include <gapcheck/part_history.hpp>
#include <gapcheck/read_run.hpp>
#include <span>
#include <string>
#include <vector>

#include "callback.hpp"
#include "errors.hpp"
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

/// T × P numbers of a PartHistory, or T × P × 3 of them, as a view.
py::array of_parts(const py::object& history, std::vector<double> api::PartHistory::*member, bool vectors) {
  const auto& from = history.cast<const api::PartHistory&>();
  const py::array flat = view(std::span<const double>(from.*member), history);
  const auto times = static_cast<py::ssize_t>(from.times.size()), parts = static_cast<py::ssize_t>(from.part.size());
  return vectors ? flat.attr("reshape")(times, parts, 3) : flat.attr("reshape")(times, parts);
}

void add_parts(py::module_& module) {
  using api::PartHistory;
  const auto numbers_of = [](std::vector<double> PartHistory::*member, bool vectors) {
    return [member, vectors](const py::object& self) { return of_parts(self, member, vectors); };
  };
  const auto list = [](auto PartHistory::*member) {
    return [member](const py::object& self) {
      const auto& entries = self.cast<const PartHistory&>().*member;
      return view(std::span(entries.data(), entries.size()), self);
    };
  };
  Record<PartHistory>(
      module, "PartHistory",
      "Energies and momenta of P parts at T times, from matsum or its branch of a binout, in the units of "
      "the model. Read-only arrays; NaN: the file has no number there.")
      .call("part", list(&PartHistory::part), "P ids, as they first appear")
      .add("title", &PartHistory::title, "P, empty: none; a binout has none")
      .call("times", list(&PartHistory::times), "T, ascending")
      .call("internal", numbers_of(&PartHistory::internal, false), "T × P energies")
      .call("kinetic", numbers_of(&PartHistory::kinetic, false), "T × P energies")
      .call("hourglass", numbers_of(&PartHistory::hourglass, false), "T × P energies")
      .call("eroded_internal", numbers_of(&PartHistory::eroded_internal, false),
            "T × P energies of deleted elements, which the others leave out")
      .call("eroded_hourglass", numbers_of(&PartHistory::eroded_hourglass, false), "T × P energies, likewise")
      .call("momentum", numbers_of(&PartHistory::momentum, true), "T × P × 3")
      .call("velocity", numbers_of(&PartHistory::velocity, true), "T × P × 3, of the part as a rigid body");
}

}  // namespace

void add_read_run(py::module_& module) {
  using api::Curve, api::Curves;
  add_parts(module);
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
