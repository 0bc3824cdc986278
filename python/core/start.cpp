#include <cstdint>
#include <gapcheck/start.hpp>
#include <optional>
#include <string>

#include "callback.hpp"
#include "module.hpp"
#include "options.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

api::Start start_of(const py::object& path, const py::dict& options) {
  const std::string deck = path_of(path);
  const Options given(options);
  api::StartOptions settings;
  given.take(settings.includes);
  given.take("picture", settings.picture);
  given.take("mesh", settings.mesh);
  given.take_jobs(settings.jobs);
  return interruptible(settings, [&] { return api::start_deck(deck, settings); });
}

/// What contacts and pairs of parts have in common.
template <class T>
void add_counts(Record<T>& record) {
  using Counts = api::StartCounts;
  record.template add<std::uint64_t>("moved", &Counts::moved, "nodes")
      .template add<double>("largest_move", &Counts::largest_move)
      .template add<double>("total_move", &Counts::total_move, "sum over the nodes")
      .call(
          "histogram",
          [](const T& self) {
            return py::array_t<std::uint64_t>(static_cast<py::ssize_t>(self.histogram.size()), self.histogram.data());
          },
          "5 numbers of nodes in equal bins from 0 to the largest move")
      .template add<std::uint64_t>("kept", &Counts::kept, "nodes whose penetration IGNORE forgives")
      .template add<double>("deepest_kept", &Counts::deepest_kept)
      .template add<std::optional<double>>("least_share", &Counts::least_share,
                                           "smallest share of the contact thickness that is left; None: no thickness")
      .template add<std::uint64_t>("forced", &Counts::forced, "nodes with a force from the beginning")
      .template add<double>("deepest_forced", &Counts::deepest_forced)
      .template add<double>("energy", &Counts::energy, "of their springs")
      .template add<std::uint64_t>("released", &Counts::released, "nodes without contact until they are outside")
      .template add<double>("way_out", &Counts::way_out, "of released nodes, the longest")
      .template add<std::optional<double>>("to_release", &Counts::to_release,
                                           "smallest further penetration with which a node is released")
      .template add<std::uint64_t>("touched", &Counts::touched, "elements with a moved node")
      .template add<std::uint64_t>("changed", &Counts::changed, "of these, visibly changed")
      .template add<std::uint64_t>("collapsed", &Counts::collapsed, "of these, unusable");
}

void add_contacts(py::module_& module) {
  using api::StartContact, api::StartPair;
  Record<StartContact> contact(module, "StartContact", "What a contact does before the first step.");
  contact.add("id", &StartContact::id)
      .add("title", &StartContact::title)
      .add("keyword", &StartContact::keyword)
      .add("score", &StartContact::score, "one line: 'starts clean', 'loses 14 nodes'")
      .add("not_known", &StartContact::not_known, "why nothing is known about it; empty: something is")
      .add("no_energy", &StartContact::no_energy, "why the energy of its springs is not known; empty: it is");
  add_counts(contact);
  Record<StartPair> pair(module, "StartPair", "What a contact does between two parts before the first step.");
  pair.add("contact", &StartPair::contact, "position in Start.contacts")
      .add("part", &StartPair::part, "id, of the nodes; 0: not known")
      .add("other_part", &StartPair::other_part, "id, of the segments; 0: not known");
  add_counts(pair);
}

void add_consequences(py::module_& module) {
  using api::StartCrossing, api::StartElement, api::StartRefusal, api::StartRepeat;
  Record<StartRepeat>(module, "StartRepeat", "A node that is moved more than once.")
      .add("node", &StartRepeat::node, "id")
      .add("contacts", &StartRepeat::contacts, "positions in Start.contacts of those that moved it, in that order")
      .add("path", &StartRepeat::path, "sum of the moves")
      .add("net", &StartRepeat::net, "from the deck to the start")
      .add("back", &StartRepeat::back, "a move goes against an earlier one");
  Record<StartElement::Shape>(module, "StartShape", "The shape of an element.")
      .add("edge_ratio", &StartElement::Shape::edge_ratio, "longest edge over shortest one")
      .add("warp", &StartElement::Shape::warp, "of shells, degrees")
      .add("size", &StartElement::Shape::size, "length, area or volume; negative: turned inside out")
      .add("step", &StartElement::Shape::step, "stable time step without TSSFAC; infinity: it has none");
  Record<StartElement>(module, "StartElement", "An element with a moved node that has visibly changed or collapsed.")
      .add("kind", &StartElement::kind, "'shell', 'solid', 'thick shell' or 'beam'")
      .add("id", &StartElement::id)
      .add("part", &StartElement::part, "id")
      .add("contact", &StartElement::contact, "id of the one that moved its farthest node last")
      .add("before", &StartElement::before, "in the deck")
      .add("after", &StartElement::after, "at the start")
      .add("inverted", &StartElement::inverted, "by the moves")
      .add("flat", &StartElement::flat, "by the moves");
  Record<StartCrossing>(module, "StartCrossing", "Two elements that cross at the start and not in the deck.")
      .add("kind", &StartCrossing::kind)
      .add("id", &StartCrossing::id)
      .add("part", &StartCrossing::part, "id")
      .add("other_kind", &StartCrossing::other_kind)
      .add("other_id", &StartCrossing::other_id)
      .add("other_part", &StartCrossing::other_part, "id")
      .add("contact", &StartCrossing::contact, "id of the first that keeps them apart")
      .add("moved_by", &StartCrossing::moved_by, "id of the contact that last moved one of their nodes")
      .add("depth", &StartCrossing::depth, "by which they stick out behind each other, the smaller of the two");
  Record<StartRefusal>(module, "StartRefusal", "A part of the deck for which a run refuses it.")
      .add("keyword", &StartRefusal::keyword, "empty: `why` names it")
      .add_path("file", &StartRefusal::file)
      .add("line", &StartRefusal::line)
      .add("why", &StartRefusal::why);
}

void add_expected(py::module_& module) {
  using api::ExpectedContact, api::ExpectedContacts, api::ExpectedWall;
  Record<ExpectedContact>(module, "ExpectedContact", "What the nodes of a part meet along straight lines.")
      .add("contact", &ExpectedContact::contact, "position in Start.contacts")
      .add("part", &ExpectedContact::part, "id, of the nodes; 0: not known")
      .add("other_part", &ExpectedContact::other_part, "id, of the segments; 0: not known")
      .add("nodes", &ExpectedContact::nodes, "that meet a segment")
      .add("node", &ExpectedContact::node, "id of the first of them")
      .add("time", &ExpectedContact::time, "when it does")
      .add("speed", &ExpectedContact::speed, "greatest speed of approach, along the normal")
      .add("in_step", &ExpectedContact::in_step, "largest share of 0.8 of the contact distance in one step")
      .add("crossing", &ExpectedContact::crossing, "nodes that come closer by all of it")
      .add("margin", &ExpectedContact::margin, "depth of release over the depth that is reached; None: not known")
      .add("alone", &ExpectedContact::alone, "the same with each node alone, where parts deform")
      .add("low", &ExpectedContact::low, "bound of the margin of the run")
      .add("high", &ExpectedContact::high, "bound of the margin of the run")
      .add("reason", &ExpectedContact::reason, "why the margin is not known; empty: it is")
      .add("lost", &ExpectedContact::lost)
      .add("held", &ExpectedContact::held)
      .add("never_released", &ExpectedContact::never_released);
  Record<ExpectedWall>(module, "ExpectedWall", "Nodes of a part that reach a rigid wall along straight lines.")
      .add("wall", &ExpectedWall::wall, "id")
      .add("part", &ExpectedWall::part, "id; 0: none")
      .add("nodes", &ExpectedWall::nodes)
      .add("node", &ExpectedWall::node, "id of the first of them")
      .add("time", &ExpectedWall::time)
      .add("speed", &ExpectedWall::speed);
  Record<ExpectedContacts>(module, "ExpectedContacts", "What will meet, if all goes on along straight lines.")
      .add("until", &ExpectedContacts::until, "as far as the search has looked")
      .add("end", &ExpectedContacts::end, "of the run")
      .add("step", &ExpectedContacts::step, "of its first cycle")
      .add_list("contacts", &ExpectedContacts::contacts, "ExpectedContact, the least margin first")
      .add_list("walls", &ExpectedContacts::walls, "ExpectedWall, by time")
      .add("not_looked_at", &ExpectedContacts::not_looked_at, "what could meet and is not looked at");
}

const api::Start& start_in(const py::object& given) { return given.cast<const api::Start&>(); }

py::dict start_move_columns(const py::object& start) {
  const api::StartMoves& m = start_in(start).moves;
  py::dict columns;
  columns["contact"] = view(m.contact, start);
  columns["node"] = view(m.node, start);
  columns["part"] = view(m.part, start);
  columns["other_part"] = view(m.other_part, start);
  columns["start"] = view(m.from, start, 3);
  columns["end"] = view(m.to, start, 3);
  columns["cause"] = view(m.cause, start);
  return columns;
}

py::dict start_node_columns(const py::object& start) {
  const api::StartNodes& n = start_in(start).nodes;
  py::dict columns;
  columns["contact"] = view(n.contact, start);
  columns["node"] = view(n.node, start);
  columns["part"] = view(n.part, start);
  columns["other_part"] = view(n.other_part, start);
  columns["outcome"] = view(n.outcome, start);
  columns["depth"] = view(n.depth, start);
  columns["contact_distance"] = view(n.contact_distance, start);
  columns["energy"] = view(n.energy, start);
  columns["to_release"] = view(n.to_release, start);
  return columns;
}

/// A text that was asked for; None: it was not.
py::object text_or_none(const std::string& written) { return written.empty() ? py::none() : py::object(text(written)); }

}  // namespace

void add_start(py::module_& module) {
  using api::Start;
  add_contacts(module);
  add_consequences(module);
  add_expected(module);
  Record<Start>(module, "Start", "The start of a run; gapcheck.Start is made around it.")
      .add_path("input", &Start::input)
      .add("clean", &Start::clean)
      .call("files", [](const Start& self) { return py::tuple(path_texts(self.files)); })
      .add_list("contacts", &Start::contacts)
      .add_list("pairs", &Start::pairs)
      .call("moves", [](const py::object& self) { return start_move_columns(self); })
      .call("nodes", [](const py::object& self) { return start_node_columns(self); })
      .call("node", [](const py::object& self) { return view(start_in(self).positions.node, self); })
      .call("deck_points", [](const py::object& self) { return view(start_in(self).positions.deck, self, 3); })
      .call("points", [](const py::object& self) { return view(start_in(self).positions.start, self, 3); })
      .add_list("repeats", &Start::repeats)
      .add_list("elements", &Start::elements)
      .add_list("crossings", &Start::crossings)
      .add("expected", &Start::expected)
      .add("moved", &Start::moved)
      .add("largest_move", &Start::largest_move)
      .add("energy", &Start::energy)
      .add("touched", &Start::touched)
      .add("changed", &Start::changed)
      .add("collapsed", &Start::collapsed)
      .add("kinetic", &Start::kinetic)
      .add("first_step", &Start::first_step)
      .add("step_before", &Start::step_before)
      .add("step_after", &Start::step_after)
      .add("first_cycle", &Start::first_cycle)
      .add_list("refused", &Start::refused)
      .add("notes", &Start::notes)
      .add_list("diagnostics", &Start::diagnostics)
      .type()
      .def("text", [](const Start& self, std::size_t top) { return text(api::text(self, top)); })
      .def("json", [](const Start& self) { return text(api::json(self)); })
      .def("html", [](const Start& self) { return text_or_none(api::html(self)); })
      .def("vtu", [](const Start& self) { return text_or_none(api::vtu(self)); });
  module.def("start_deck", start_of);
}

}  // namespace gapcheck::python
