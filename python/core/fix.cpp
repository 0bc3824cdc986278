#include <cstdint>
#include <gapcheck/fix.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "callback.hpp"
#include "module.hpp"
#include "options.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

/// `given`: a list of pairs (first id, last id).
void take_locks(const Options& given, const char* name, api::Lock::Of of, std::vector<api::Lock>& locks) {
  const py::object value = given.value(name);
  if (value.is_none()) return;
  for (const auto& [first, last] : value.cast<std::vector<std::pair<std::int64_t, std::int64_t>>>())
    locks.push_back({of, first, last});
}

api::Fix fix_of(const py::object& path, const py::dict& options) {
  const std::string deck = path_of(path);
  const Options given(options);
  api::FixOptions settings;
  given.take(settings.includes);
  take_locks(given, "lock_parts", api::Lock::Of::parts, settings.locks);
  take_locks(given, "lock_nodes", api::Lock::Of::nodes, settings.locks);
  std::map<std::int64_t, double> priorities;
  given.take("priorities", priorities);
  for (const auto& [part, factor] : priorities) settings.priorities.push_back({part, factor});
  given.take("recommended", settings.recommended);
  given.take("free_welds", settings.free_welds);
  given.take_jobs(settings.jobs);
  return interruptible(settings, [&] { return api::fix_deck(deck, settings); });
}

void add_parts_of_fixes(py::module_& module) {
  using api::ChangedFile, api::FixContact, api::FixProposal, api::FixWall, api::MovedNode, api::UnfixedNode;
  Record<FixContact::State>(module, "FixState", "What a contact finds.")
      .add("penetrations", &FixContact::State::penetrations)
      .add("released", &FixContact::State::released, "too deep, not among the penetrations")
      .add("deepest", &FixContact::State::deepest);
  Record<FixContact>(module, "FixContact", "One contact before and after the correction.")
      .add("id", &FixContact::id)
      .add("keyword", &FixContact::keyword)
      .add("title", &FixContact::title)
      .add("not_checked", &FixContact::not_checked)
      .add("before", &FixContact::before)
      .add("after", &FixContact::after)
      .add("by_segments", &FixContact::by_segments)
      .add("edges_before", &FixContact::edges_before)
      .add("edges_after", &FixContact::edges_after);
  Record<MovedNode>(module, "MovedNode", "A node that was moved; coordinates of the deck.")
      .add("node", &MovedNode::node, "id")
      .call(
          "start", [](const MovedNode& self) { return py::array_t<double>(3, self.from); }, "3, where it was")
      .call(
          "end", [](const MovedNode& self) { return py::array_t<double>(3, self.to); }, "3, where it is now")
      .add("onto_tie", &MovedNode::onto_tie)
      .add("file", &MovedNode::file, "position in Fix.files")
      .add("line", &MovedNode::line);
  Record<UnfixedNode>(module, "UnfixedNode", "A node that penetrates after the correction.")
      .add("contact", &UnfixedNode::contact)
      .add("node", &UnfixedNode::node)
      .add("part", &UnfixedNode::part)
      .add("element", &UnfixedNode::element)
      .add("element_part", &UnfixedNode::element_part)
      .add("depth", &UnfixedNode::depth)
      .add("contact_distance", &UnfixedNode::contact_distance)
      .add("released", &UnfixedNode::released)
      .add("reason", &UnfixedNode::reason, "'locked', 'rigid', 'shape', …; 'none': no way was found");
  Record<FixWall>(module, "FixWall", "One rigid wall before and after the correction.")
      .add("id", &FixWall::id)
      .add("title", &FixWall::title)
      .add("nodes_before", &FixWall::nodes_before)
      .add("nodes_after", &FixWall::nodes_after)
      .add("deepest_before", &FixWall::deepest_before)
      .add("deepest_after", &FixWall::deepest_after)
      .add_list("unfixed", &FixWall::unfixed);
  Record<FixProposal::Alternative>(module, "FixAlternative", "A change of the deck instead.")
      .add("text", &FixProposal::Alternative::text)
      .add("card", &FixProposal::Alternative::card, "the keyword lines");
  Record<FixProposal>(module, "FixProposal", "Instead of moving nodes: what else would part two parts.")
      .add("contact", &FixProposal::contact)
      .add("part", &FixProposal::part)
      .add("other_part", &FixProposal::other_part)
      .add("penetrations", &FixProposal::penetrations)
      .add("deepest", &FixProposal::deepest)
      .add("thickness", &FixProposal::thickness, "the largest for both parts without penetrations; 0: none")
      .add_list("alternatives", &FixProposal::alternatives);
  Record<ChangedFile>(module, "ChangedFile", "A file of the deck after the correction.")
      .add_path("path", &ChangedFile::path, "of the file that was read, which stays unchanged")
      .add_path("place", &ChangedFile::place, "below the main file's folder; only its name if it is elsewhere")
      .add("lines", &ChangedFile::lines, "that differ")
      .call(
          "content", [](const ChangedFile& self) { return py::bytes(self.text); }, "bytes");
}

}  // namespace

void add_fix(py::module_& module) {
  using api::Fix;
  add_parts_of_fixes(module);
  Record<Fix>(module, "Fix", "A correction; gapcheck.Fix is made around it.")
      .add("solved", &Fix::solved)
      .call("files", [](const Fix& self) { return py::tuple(path_texts(self.files)); })
      .add_list("contacts", &Fix::contacts)
      .add_list("walls", &Fix::walls)
      .add_list("moved", &Fix::moved)
      .add_list("unfixed", &Fix::unfixed)
      .add_list("proposals", &Fix::proposals)
      .add_list("changed", &Fix::changed)
      .add("largest_move", &Fix::largest_move)
      .add("total_move", &Fix::total_move)
      .add("elements_touched", &Fix::elements_touched)
      .add("elements_worsened", &Fix::elements_worsened)
      .add("cut_short", &Fix::cut_short)
      .add("notes", &Fix::notes)
      .add_list("diagnostics", &Fix::diagnostics)
      .type()
      .def("text", [](const Fix& self, std::size_t top) { return text(api::text(self, top)); })
      .def("json", [](const Fix& self) { return text(api::json(self)); });
  module.def("fix_deck", fix_of);
}

}  // namespace gapcheck::python
