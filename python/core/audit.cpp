#include <chrono>
#include <cstddef>
#include <cstdint>
#include <gapcheck/arrays.hpp>
#include <gapcheck/audit.hpp>
#include <span>
#include <string>
#include <utility>

#include "callback.hpp"
#include "errors.hpp"
#include "module.hpp"
#include "options.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

api::AuditOptions audit_options(const Options& given) {
  api::AuditOptions options;
  given.take(options.includes);
  given.take("select", options.select);
  given.take("ignore", options.ignore);
  given.take("contacts", options.contacts);
  given.take("parts", options.parts);
  given.take("ptol", options.ptol);
  given.take("rtol", options.rtol);
  given.take("ratio", options.ratio);
  given.take("severities", options.severities);
  given.take("millimetre", options.millimetre);
  given.take("exact", options.exact);
  given.take("picture", options.picture);
  given.take("mesh", options.mesh);
  given.take_jobs(options.jobs);
  std::size_t days = 0;  // since 1970-01-01
  given.take("today", days);
  options.today = std::chrono::sys_days(std::chrono::days(days));
  return options;
}

/// `audit`: makes the report by these options.
template <class Audit>
api::Report audited(const py::dict& given, const Audit& audit) {
  const Options read(given);
  api::AuditOptions options = audit_options(read);
  Callback progress(read.function("progress"));
  options.watch = [&progress](const api::AuditStep& step) {
    return progress([&] { return py::make_tuple(text(step.name), step.done, step.all); });
  };
  auto report = without_lock([&] { return audit(options); });
  progress.raise_again();
  return taken(std::move(report));
}

using Numbers = py::array_t<double, py::array::c_style>;
using Ids = py::array_t<std::int64_t, py::array::c_style>;

/// The arrays are of the right types and without gaps; gapcheck.arrays sees to it.
api::ShellMesh shell_mesh(const Numbers& points, const Ids& shells, const Ids& parts, const Options& given) {
  const auto span = [](const auto& array) { return std::span(array.data(), static_cast<std::size_t>(array.size())); };
  api::ShellMesh mesh;
  mesh.points = span(points);
  mesh.shells = span(shells);
  mesh.parts = span(parts);
  given.take("thickness", mesh.thickness);
  given.take("part_thickness", mesh.part_thickness);
  given.take("contact", mesh.contact);
  given.take("tracked", mesh.tracked);
  given.take("reference", mesh.reference);
  return mesh;
}

}  // namespace

void add_audit(py::module_& module) {
  using api::Rule;
  Record<Rule>(module, "Rule", "A rule of audits, or of runs.")
      .add("id", &Rule::id, "'GC101'")
      .add("name", &Rule::name, "'initial-penetration'")
      .add("severity", &Rule::severity, "'note', 'warning' or 'error'")
      .add("summary", &Rule::summary, "one line")
      .add("page", &Rule::page, "markdown: formula, example, what to do")
      .add("of_runs", &Rule::of_runs, "judges the output of a run, not a deck");
  module.def("rules", [] { return py::tuple(py::cast(api::rules())); });
  module.def("audit_deck", [](const py::object& path, const py::dict& options) {
    const std::string deck = path_of(path);
    return audited(options, [&](const api::AuditOptions& given) { return api::audit_deck(deck, given); });
  });
  module.def("audit_text", [](const py::bytes& deck, const py::object& name, const py::dict& options) {
    std::string content = deck;
    const std::string path = path_of(name);
    return audited(options,
                   [&](const api::AuditOptions& given) { return api::audit_text(std::move(content), path, given); });
  });
  module.def("audit_arrays", [](const Numbers& points, const Ids& shells, const Ids& parts, const py::dict& mesh,
                                const py::dict& options) {
    const api::ShellMesh given_mesh = shell_mesh(points, shells, parts, Options(mesh));
    return audited(options, [&](const api::AuditOptions& given) { return api::audit_arrays(given_mesh, given); });
  });
  module.def("shell_deck", [](const Numbers& points, const Ids& shells, const Ids& parts, const py::dict& mesh) {
    const api::ShellMesh given = shell_mesh(points, shells, parts, Options(mesh));
    return worked([&] { return api::shell_deck(given); });
  });
}

}  // namespace gapcheck::python
