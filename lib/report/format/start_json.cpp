#include <cmath>
#include <nlohmann/json.hpp>

#include "report/format/start_report.hpp"

namespace gapcheck::report {
namespace {

using StartJson = nlohmann::ordered_json;

StartJson place_json(const Vector& x) { return StartJson::array({x.x(), x.y(), x.z()}); }

void add_known(StartJson& json, const char* key, const std::optional<double>& value) {
  if (value && std::isfinite(*value)) json[key] = *value;
}

StartJson shapes_json(const StartReport& report, const StartShapes& shapes) {
  StartJson json{{"touched", shapes.touched}, {"changed", shapes.changed}, {"collapsed", shapes.collapsed}};
  const auto add = [&](const char* key, const std::optional<std::size_t>& at) {
    if (at) json[key] = {{"kind", report.elements[*at].kind}, {"id", report.elements[*at].id}};
  };
  add("worst_edge_ratio", shapes.edge_ratio);
  add("worst_warp", shapes.warp);
  add("worst_step", shapes.step);
  return json;
}

void add_counts(const StartReport& report, const StartCounts& counts, bool energy, StartJson& json) {
  json["moved"] = counts.moved;
  json["largest_move"] = counts.largest_move;
  json["total_move"] = counts.total_move;
  json["histogram"] = counts.histogram;
  json["kept"] = counts.kept;
  json["deepest_kept"] = counts.deepest_kept;
  add_known(json, "least_share", counts.least_share);
  json["forced"] = counts.forced;
  json["deepest_forced"] = counts.deepest_forced;
  if (energy) json["energy"] = counts.energy;
  json["released"] = counts.released;
  json["way_out"] = counts.way_out;
  add_known(json, "to_release", counts.to_release);
  json["elements"] = shapes_json(report, counts.shapes);
}

StartJson start_contact_json(const StartReport& report, const StartContact& c) {
  StartJson json{{"id", c.id}, {"keyword", c.keyword}};
  if (!c.title.empty()) json["title"] = c.title;
  json["score"] = score(c);
  if (!c.not_known.empty()) json["not_known"] = c.not_known;
  if (!c.no_energy.empty()) json["no_energy"] = c.no_energy;
  add_counts(report, c, c.no_energy.empty(), json);
  return json;
}

StartJson pair_json(const StartReport& report, const StartPair& pair) {
  const StartContact& contact = report.contacts[pair.contact];
  StartJson json{{"contact", contact.id}, {"part", pair.part}, {"other_part", pair.other_part}};
  add_counts(report, pair, contact.no_energy.empty(), json);
  return json;
}

StartJson shape_json(const StartElement::Shape& shape) {
  StartJson json{{"edge_ratio", shape.edge_ratio}, {"warp", shape.warp}, {"size", shape.size}};
  add_known(json, "step", shape.step);
  return json;
}

StartJson element_json(const StartElement& e) {
  StartJson json{{"kind", e.kind}, {"id", e.id}, {"part", e.part}, {"contact", e.contact}};
  if (e.inverted) json["inverted"] = true;
  if (e.flat) json["flat"] = true;
  json["before"] = shape_json(e.before);
  json["after"] = shape_json(e.after);
  return json;
}

StartJson crossing_json(const StartCrossing& c) {
  StartJson elements = StartJson::array();
  for (const StartCrossing::Element& e : {c.a, c.b})
    elements.push_back({{"kind", e.kind}, {"id", e.id}, {"part", e.part}});
  return {{"elements", elements}, {"contact", c.contact}, {"moved_by", c.moved_by}, {"depth", c.depth}};
}

StartJson refusal_json(const StartRefusal& r) {
  StartJson json;
  if (!r.keyword.empty()) json["keyword"] = r.keyword;
  if (!r.file.empty()) {
    json["file"] = r.file;
    json["line"] = r.line;
  }
  json["why"] = r.why;
  return json;
}

void add_moves_json(const StartReport& report, StartJson& json) {
  for (const StartMove& m : report.moves)
    json["moves"].push_back({{"contact", report.contacts[m.contact].id},
                             {"node", m.node},
                             {"part", m.part},
                             {"other_part", m.other_part},
                             {"from", place_json(m.from)},
                             {"to", place_json(m.to)},
                             {"cause", name(m.cause)}});
  for (const StartRepeat& r : report.repeats) {
    StartJson by = StartJson::array();
    for (const std::uint32_t contact : r.contacts) by.push_back(report.contacts[contact].id);
    json["moved_again"].push_back(
        {{"node", r.node}, {"contacts", by}, {"path", r.path}, {"net", r.net}, {"back", r.back}});
  }
}

StartJson expected_contact_json(const StartReport& report, const ExpectedContact& e) {
  StartJson json{{"contact", report.contacts[e.contact].id},
                 {"part", e.part},
                 {"other_part", e.other_part},
                 {"nodes", e.nodes},
                 {"node", e.node},
                 {"time", e.time},
                 {"speed", e.speed}};
  add_known(json, "in_step", e.in_step);
  json["crossing"] = e.crossing;
  add_known(json, "margin", e.margin);
  add_known(json, "alone", e.alone);
  add_known(json, "low", e.low);
  add_known(json, "high", e.high);
  if (!e.reason.empty()) json["reason"] = e.reason;
  json["never_released"] = e.never_released;
  json["lost"] = e.lost();
  json["held"] = e.held();
  if (e.thickness) json["thickness"] = {{"card", e.thickness_card}, {"value", *e.thickness}};
  add_known(json, "sofscl", e.sofscl);
  add_known(json, "step", e.step);
  return json;
}

StartJson expected_json(const StartReport& report) {
  const ExpectedContacts& expected = *report.expected;
  StartJson json{{"until", expected.until}, {"end", expected.end}, {"step", expected.step}};
  for (const char* list : {"contacts", "walls", "not_looked_at"}) json[list] = StartJson::array();
  for (const ExpectedContact& e : expected.contacts) json["contacts"].push_back(expected_contact_json(report, e));
  for (const ExpectedWall& w : expected.walls)
    json["walls"].push_back({{"wall", w.wall},
                             {"part", w.part},
                             {"nodes", w.nodes},
                             {"node", w.node},
                             {"time", w.time},
                             {"speed", w.speed}});
  for (const std::string& what : expected.not_looked_at) json["not_looked_at"].push_back(what);
  json["counters"] = {
      {"still", expected.still}, {"candidates", expected.candidates}, {"closest_points", expected.closest_points}};
  return json;
}

}  // namespace

std::string start_json(const StartReport& report) {
  StartJson json{{"schema", "gapcheck-start/1"}, {"input", report.input}, {"first_cycle", report.first_cycle}};
  for (const char* list :
       {"contacts", "pairs", "moves", "moved_again", "elements", "crossings", "refused", "notes", "files"})
    json[list] = StartJson::array();
  for (const StartContact& c : report.contacts) json["contacts"].push_back(start_contact_json(report, c));
  for (const StartPair& p : report.pairs) json["pairs"].push_back(pair_json(report, p));
  add_moves_json(report, json);
  for (const StartElement& e : report.elements) json["elements"].push_back(element_json(e));
  for (const StartCrossing& c : report.crossings) json["crossings"].push_back(crossing_json(c));
  for (const StartRefusal& r : report.refused) json["refused"].push_back(refusal_json(r));
  for (const std::string& note : report.notes) json["notes"].push_back(note);
  for (const std::string& file : report.written) json["files"].push_back(file);
  if (report.expected) json["expected"] = expected_json(report);
  StartJson summary{{"clean", starts_clean(report)},       {"moved", report.moved},
                    {"largest_move", report.largest_move}, {"energy", report.energy},
                    {"rounding", report.rounding},         {"elements", shapes_json(report, report.shapes)}};
  add_known(summary, "kinetic", report.kinetic);
  add_known(summary, "first_step", report.first_step);
  add_known(summary, "step_before", report.step_before);
  add_known(summary, "step_after", report.step_after);
  json["summary"] = std::move(summary);
  return json.dump(2, ' ', false, StartJson::error_handler_t::replace) + "\n";
}

}  // namespace gapcheck::report
