#include <gapcheck/mesh.hpp>
#include <gapcheck/records.hpp>
#include <gapcheck/report.hpp>
#include <gapcheck/start.hpp>
#include <string_view>

#include "convert.hpp"
#include "module.hpp"

// The arrays of a report, each a view into the library's memory that keeps the report alive.
namespace gapcheck::python {
namespace {

const api::Report& report_in(const py::object& given) {
  if (!py::isinstance<api::Report>(given)) throw py::type_error("a Report is needed");
  return given.cast<const api::Report&>();
}

py::dict penetration_columns(const py::object& report) {
  const api::Penetrations& p = report_in(report).penetrations;
  py::dict columns;
  columns["kind"] = view(p.kind, report);
  columns["contact"] = view(p.contact, report);
  columns["node"] = view(p.node, report);
  columns["part"] = view(p.part, report);
  columns["segment"] = view(p.segment, report, 4);
  columns["segment_number"] = view(p.segment_number, report);
  columns["element"] = view(p.element, report);
  columns["element_part"] = view(p.element_part, report);
  columns["depth"] = view(p.depth, report);
  columns["contact_distance"] = view(p.contact_distance, report);
  columns["local"] = view(p.local, report, 2);
  columns["position"] = view(p.position, report, 3);
  columns["closest"] = view(p.closest, report, 3);
  columns["moved_to"] = view(p.moved_to, report, 3);
  columns["outcome"] = view(p.outcome, report);
  columns["feature"] = view(p.feature, report);
  columns["node_rule"] = view(p.node_rule, report);
  columns["segment_rule"] = view(p.segment_rule, report);
  columns["file"] = view(p.file, report);
  columns["line"] = view(p.line, report);
  return columns;
}

py::dict tie_columns(const py::object& report) {
  const api::Ties& t = report_in(report).ties;
  py::dict columns;
  columns["reason"] = view(t.reason, report);
  columns["contact"] = view(t.contact, report);
  columns["node"] = view(t.node, report);
  columns["part"] = view(t.part, report);
  columns["segment_number"] = view(t.segment_number, report);
  columns["distance"] = view(t.distance, report);
  columns["allowed"] = view(t.allowed, report);
  columns["position"] = view(t.position, report, 3);
  columns["by_node_set"] = view(t.by_node_set, report);
  columns["file"] = view(t.file, report);
  columns["line"] = view(t.line, report);
  return columns;
}

/// None: the report has no mesh.
py::object mesh_columns(const py::object& report) {
  const auto& mesh = report_in(report).mesh;
  if (!mesh) return py::none();
  py::dict columns;
  columns["node"] = view(mesh->node, report);
  columns["points"] = view(mesh->points, report, 3);
  columns["corners"] = view(mesh->corners, report);
  columns["ends"] = view(mesh->ends, report);
  columns["kind"] = view(mesh->kind, report);
  columns["element"] = view(mesh->element, report);
  columns["part"] = view(mesh->part, report);
  columns["contact"] = view(mesh->contact, report);
  columns["thickness"] = view(mesh->thickness, report);
  columns["left_out"] = py::int_(mesh->left_out);
  return columns;
}

/// The words of an enumeration from its first to its last code.
template <class Code>
py::tuple words(Code last, std::string_view (*name)(Code)) {
  py::list list;
  for (int code = 0; code <= static_cast<int>(last); ++code) list.append(text(name(static_cast<Code>(code))));
  return py::tuple(list);
}

}  // namespace

void add_columns(py::module_& module) {
  module.def("penetration_columns", penetration_columns);
  module.def("tie_columns", tie_columns);
  module.def("mesh_columns", mesh_columns);
  py::dict names;
  names["kind"] = py::make_tuple("initial", "released", "edge-zone", "segment", "mortar", "edge");
  names["outcome"] = words(api::Outcome::reported, &api::name);
  names["feature"] = words(api::Feature::corner, &api::name);
  names["thickness_rule"] = words(api::ThicknessRule::beam_section, &api::name);
  names["reason"] = words(api::TieReason::conflict, &api::name);
  names["cause"] = words(api::StartCause::first_cycle, &api::name);
  names["element"] = py::make_tuple("shell", "solid", "thick-shell", "beam", "particle");
  names["kind_rule"] = words(api::PenetrationKind::edge, &api::rule_id);
  names["reason_rule"] = words(api::TieReason::conflict, &api::rule_id);
  module.attr("names") = names;
  static_assert(static_cast<int>(api::PenetrationKind::edge) == 5 && static_cast<int>(api::ElementKind::particle) == 4);
}

}  // namespace gapcheck::python
