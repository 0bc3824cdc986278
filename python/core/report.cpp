#include <gapcheck/report.hpp>
#include <vector>

#include "module.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

const char* termination_name(api::SolverRun::Termination termination) {
  switch (termination) {
    case api::SolverRun::Termination::normal:
      return "normal";
    case api::SolverRun::Termination::error:
      return "error";
    case api::SolverRun::Termination::unknown:
      break;
  }
  return "unknown";
}

void add_parts_of_reports(py::module_& module) {
  using api::Contact, api::Diagnostic, api::Finding, api::ModelCounts, api::Totals;
  Record<Diagnostic>(module, "Diagnostic", "What could not be read or was skipped.")
      .add("severity", &Diagnostic::severity, "'note', 'warning' or 'error'")
      .add_path("file", &Diagnostic::file, "empty: about no file in particular")
      .add("line", &Diagnostic::line, "from 1; 0: the whole file")
      .add("message", &Diagnostic::message, "what is wrong, and what to do");
  Record<Totals>(module, "Totals", "Numbers of findings by severity, penetrations and ties included.")
      .add("errors", &Totals::errors)
      .add("warnings", &Totals::warnings)
      .add("notes", &Totals::notes);
  Record<ModelCounts>(module, "ModelCounts", "Size of a deck.")
      .add("nodes", &ModelCounts::nodes)
      .add("shells", &ModelCounts::shells)
      .add("solids", &ModelCounts::solids)
      .add("beams", &ModelCounts::beams)
      .add("thick_shells", &ModelCounts::thick_shells)
      .add("discrete", &ModelCounts::discrete)
      .add("masses", &ModelCounts::masses)
      .add("particles", &ModelCounts::particles)
      .add("parts", &ModelCounts::parts)
      .add("contacts", &ModelCounts::contacts);
  Record<Contact>(module, "Contact", "One contact definition and what was found in it. Lengths in the deck's unit.")
      .add("id", &Contact::id)
      .add("order", &Contact::order, "position in the deck, from 1")
      .add("title", &Contact::title, "empty: none")
      .add("keyword", &Contact::keyword, "'CONTACT_AUTOMATIC_SINGLE_SURFACE'; empty: the source does not say")
      .add("type", &Contact::type, "the solver's code: '13', 'a3'")
      .add("tracked_nodes", &Contact::tracked_nodes)
      .add("segments", &Contact::segments)
      .add("penetrations", &Contact::penetrations, "of kind 'initial'")
      .add("max_penetration", &Contact::max_penetration, "of these")
      .add("released", &Contact::released)
      .add("edge_zone", &Contact::edge_zone)
      .add("segment_penetrations", &Contact::segment_penetrations)
      .add("mortar_penetrations", &Contact::mortar_penetrations)
      .add("edge_penetrations", &Contact::edge_penetrations)
      .add("ties", &Contact::ties)
      .add("untied", &Contact::untied)
      .add("out_of_reach", &Contact::out_of_reach, "tracked nodes that are too far away to be meant to tie")
      .add("reported_penetrations", &Contact::reported_penetrations,
           "a count in the solver's files without a list of nodes; 0: none")
      .add("judged_nearest", &Contact::judged_nearest,
           "nodes and edges within reach of too many others: only the nearest counted")
      .add("not_checked", &Contact::not_checked, "why neither penetrations nor ties were decided; empty: they were")
      .add_path("file", &Contact::file)
      .add("line", &Contact::line);
  Record<Finding>(module, "Finding",
                  "A finding other than a penetration or tie. Ids of 0 and negative lengths are unknown.")
      .add("id", &Finding::id, "'GC501'")
      .add("rule", &Finding::rule, "'duplicate-id'")
      .add("severity", &Finding::severity, "'note', 'warning' or 'error'")
      .add("message", &Finding::message)
      .add("contact", &Finding::contact, "id")
      .add("node", &Finding::node, "id")
      .add("part", &Finding::part, "id")
      .add("element", &Finding::element, "id")
      .add("element_part", &Finding::element_part, "id")
      .add("penetration", &Finding::penetration)
      .add("contact_distance", &Finding::contact_distance)
      .add("point", &Finding::point, "where to look: three coordinates of the deck, or None")
      .add("count", &Finding::count, "more than 1: one line that represents that many things")
      .add_path("file", &Finding::file)
      .add("line", &Finding::line);
}

void add_parts_of_runs(py::module_& module) {
  using api::RigidwallPenetration, api::SolverMessage, api::SolverRun, api::SurfaceTimestep, api::Timesteps;
  Record<SurfaceTimestep>(module, "SurfaceTimestep",
                          "The largest stable time step of the springs on one side of a contact.")
      .add("contact", &SurfaceTimestep::contact, "position in Report.contacts")
      .call(
          "side", [](const SurfaceTimestep& self) { return std::string(1, self.side); }, "'A' or 'B'")
      .add("type", &SurfaceTimestep::type, "the contact's code: 'a3'")
      .add("timestep", &SurfaceTimestep::timestep, "1e16: no limit")
      .add("node", &SurfaceTimestep::node, "id, controlling; 0: unknown")
      .add("part", &SurfaceTimestep::part, "id, controlling; 0: unknown");
  Record<Timesteps>(module, "Timesteps", "Time steps that contacts and elements allow, in the model's unit of time.")
      .add("contact", &Timesteps::contact, "the smallest of `surfaces`; 0: unknown")
      .add("element", &Timesteps::element, "the smallest of all elements; 0: unknown")
      .add_list("surfaces", &Timesteps::surfaces, "SurfaceTimestep by contact, side A before side B");
  Record<SolverMessage>(module, "SolverMessage", "A warning or error of the solver other than a penetration or tie.")
      .add("severity", &SolverMessage::severity)
      .add("code", &SolverMessage::code, "40565")
      .add("kind", &SolverMessage::kind, "empty: not understood")
      .add("text", &SolverMessage::text)
      .add("count", &SolverMessage::count, "messages of this kind that it represents")
      .add("file", &SolverMessage::file, "position in Report.files")
      .add("line", &SolverMessage::line);
  Record<RigidwallPenetration>(module, "RigidwallPenetration", "A node inside a rigid wall.")
      .add("node", &RigidwallPenetration::node, "id")
      .add("wall", &RigidwallPenetration::wall, "id")
      .add("depth", &RigidwallPenetration::depth)
      .add("file", &RigidwallPenetration::file, "position in Report.files")
      .add("line", &RigidwallPenetration::line);
  Record<SolverRun>(module, "SolverRun", "What the solver's files say of the whole run. Empty or zero: unknown.")
      .add("version", &SolverRun::version)
      .add("revision", &SolverRun::revision)
      .add("precision", &SolverRun::precision)
      .add("platform", &SolverRun::platform)
      .add("title", &SolverRun::title)
      .add("mpp", &SolverRun::mpp)
      .add("ranks", &SolverRun::ranks)
      .call(
          "termination", [](const SolverRun& self) { return termination_name(self.termination); },
          "'normal', 'error' or 'unknown'")
      .add("problem_time", &SolverRun::problem_time, "reached")
      .add("end_time", &SolverRun::end_time, "requested by the deck")
      .add("cycles", &SolverRun::cycles)
      .add("timesteps", &SolverRun::timesteps)
      .add_list("rigidwalls", &SolverRun::rigidwalls)
      .add_list("messages", &SolverRun::messages, "by code, file and line")
      .add("counts_may_be_cut", &SolverRun::counts_may_be_cut, "the solver suppressed messages");
}

}  // namespace

void add_report(py::module_& module) {
  using api::Report;
  add_parts_of_reports(module);
  add_parts_of_runs(module);
  Record<Report>(module, "Report", "A report of the library; gapcheck.Report is made around it.")
      .add("source", &Report::source)
      .add_path("input", &Report::input)
      .add("model", &Report::model)
      .call("files", [](const Report& self) { return py::tuple(path_texts(self.files)); })
      .add_list("contacts", &Report::contacts)
      .add_list("findings", &Report::findings)
      .add("totals", &Report::totals)
      .add("ignored", &Report::ignored)
      .add("predicted", &Report::predicted)
      .add("run", &Report::run)
      .call("parts",
            [](const py::object& self) {
              const auto& parts = self.cast<const Report&>().parts;
              return parts ? py::cast(*parts, py::return_value_policy::reference_internal, self) : py::none();
            })
      .add("complete", &Report::complete)
      .add_list("diagnostics", &Report::diagnostics)
      .add("diagnostics_left_out", &Report::diagnostics_left_out);
}

}  // namespace gapcheck::python
