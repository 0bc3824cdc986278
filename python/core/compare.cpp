#include <gapcheck/compare.hpp>
#include <optional>
#include <string>

#include "callback.hpp"
#include "module.hpp"
#include "options.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

const char* verdict_name(api::CurvePair::Verdict verdict) {
  switch (verdict) {
    case api::CurvePair::Verdict::agrees:
      return "agrees";
    case api::CurvePair::Verdict::differs:
      return "differs";
    case api::CurvePair::Verdict::no_common_times:
      break;
  }
  return "no common times";
}

py::object reason_name(const std::optional<api::TieReason>& reason) {
  return reason ? py::object(text(api::name(*reason))) : py::none();
}

api::Comparison comparison(const py::object& first_path, const py::object& second_path, const py::dict& options) {
  const std::string first = path_of(first_path), second = path_of(second_path);
  const Options given(options);
  api::CompareOptions settings;
  given.take(settings.includes);
  given.take("tolerance", settings.tolerance);
  given.take("contacts", settings.contacts);
  given.take_paths("message_tables", settings.message_tables);
  given.take("curves", settings.curves);
  given.take("curve_tolerance", settings.curve_tolerance);
  given.take("curve_names", settings.curve_names);
  given.take_jobs(settings.jobs);
  return interruptible(settings, [&] { return api::compare(first, second, settings); });
}

void add_differences(py::module_& module) {
  using api::ContactComparison, api::DepthDifference, api::TieDifference;
  Record<ContactComparison>(module, "ContactComparison", "How the records of one contact agree; numbers of nodes.")
      .add("id", &ContactComparison::id)
      .add("title", &ContactComparison::title)
      .add("type", &ContactComparison::type)
      .add("agree", &ContactComparison::agree)
      .add("depth_differs", &ContactComparison::depth_differs)
      .add("only_first", &ContactComparison::only_first)
      .add("only_second", &ContactComparison::only_second)
      .add("largest_difference", &ContactComparison::largest_difference, "of depth")
      .add("missing_in_first", &ContactComparison::missing_in_first, "the whole contact")
      .add("missing_in_second", &ContactComparison::missing_in_second)
      .add("not_checked", &ContactComparison::not_checked, "one source did not decide it")
      .add("counts_only", &ContactComparison::counts_only, "one source lists no nodes: numbers are compared")
      .add("ties_compared", &ContactComparison::ties_compared)
      .add("ties_agree", &ContactComparison::ties_agree)
      .add("ties_other_reason", &ContactComparison::ties_other_reason)
      .add("ties_only_first", &ContactComparison::ties_only_first)
      .add("ties_only_second", &ContactComparison::ties_only_second);
  Record<DepthDifference>(module, "DepthDifference", "A node whose penetration differs.")
      .add("contact", &DepthDifference::contact, "id")
      .add("node", &DepthDifference::node, "id")
      .add("first", &DepthDifference::first, "depth; None: no such penetration")
      .add("second", &DepthDifference::second);
  Record<TieDifference>(module, "TieDifference", "A node that is untied in one source only, or for another reason.")
      .add("contact", &TieDifference::contact, "id")
      .add("node", &TieDifference::node, "id")
      .call(
          "first", [](const TieDifference& self) { return reason_name(self.first); }, "None: not untied there")
      .call("second", [](const TieDifference& self) { return reason_name(self.second); });
}

void add_compared_runs(py::module_& module) {
  using api::CurveComparison, api::CurvePair, api::CurveRating, api::MotionComparison, api::PartMotion;
  Record<CurveRating>(module, "CurveRating", "How one curve follows another by ISO/TS 18571, from 0 to 1.")
      .add("overall", &CurveRating::overall)
      .add("corridor", &CurveRating::corridor)
      .add("phase", &CurveRating::phase)
      .add("magnitude", &CurveRating::magnitude)
      .add("slope", &CurveRating::slope);
  Record<CurvePair>(module, "CurvePair", "One curve that both runs have.")
      .add("name", &CurvePair::name)
      .call(
          "verdict", [](const CurvePair& self) { return verdict_name(self.verdict); },
          "'agrees', 'differs' or 'no common times'")
      .add("largest_first", &CurvePair::largest_first)
      .add("largest_second", &CurvePair::largest_second)
      .add("largest_difference", &CurvePair::largest_difference)
      .add("time", &CurvePair::time, "of the largest difference")
      .add("relative_difference", &CurvePair::relative_difference)
      .add("l2_difference", &CurvePair::l2_difference)
      .add("rating", &CurvePair::rating);
  Record<CurveComparison>(module, "CurveComparison", "The curves of two runs.")
      .add_list("pairs", &CurveComparison::pairs, "those that differ first")
      .add("only_first", &CurveComparison::only_first)
      .add("only_second", &CurveComparison::only_second)
      .add("agree", &CurveComparison::agree)
      .add("differ", &CurveComparison::differ)
      .add("without_common_times", &CurveComparison::without_common_times);
  Record<PartMotion>(module, "PartMotion", "How far the nodes of one part lie apart in two d3plots.")
      .add("part", &PartMotion::part, "id; 0: nodes of no element")
      .add("nodes", &PartMotion::nodes)
      .add("largest_distance", &PartMotion::largest_distance)
      .add("time", &PartMotion::time)
      .add("node", &PartMotion::node)
      .add("largest", &PartMotion::largest, "distance at each of the times")
      .add("mean", &PartMotion::mean)
      .add("differs", &PartMotion::differs);
  Record<MotionComparison>(module, "MotionComparison", "The nodes of two d3plots, part by part.")
      .add("times", &MotionComparison::times)
      .add("largest_displacement", &MotionComparison::largest_displacement)
      .add_list("parts", &MotionComparison::parts, "largest distance first")
      .add("differ", &MotionComparison::differ, "parts");
}

}  // namespace

void add_compare(py::module_& module) {
  using api::Comparison;
  add_differences(module);
  add_compared_runs(module);
  Record<Comparison>(module, "Comparison", "Two compared sources; gapcheck.Comparison is made around it.")
      .add("equal", &Comparison::equal)
      .add("complete", &Comparison::complete)
      .add("first", &Comparison::first)
      .add("second", &Comparison::second)
      .add_list("contacts", &Comparison::contacts)
      .add_list("differences", &Comparison::differences)
      .add_list("tie_differences", &Comparison::tie_differences)
      .add("curves", &Comparison::curves)
      .add("motion", &Comparison::motion)
      .type()
      .def("text", [](const Comparison& self, std::size_t top) { return text(api::text(self, top)); })
      .def("json", [](const Comparison& self) { return text(api::json(self)); });
  module.def("compare", comparison);
}

}  // namespace gapcheck::python
