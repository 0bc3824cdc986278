#include "report/format/fix_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "report/format/fix_proof_report.hpp"
#include "report/format/fix_words.hpp"
#include "report/item/describe.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using fix_words::number;
using fix_words::part_name;
using fix_words::plural;

std::string file_and_line(const FixReport& report, std::uint32_t file, std::uint32_t line) {
  return file < report.files.size() ? fmt::format("{}:{}", printable_path(report.files[file]), line) : "";
}

void contacts(const FixReport& report, std::string& out) {
  constexpr std::array<Column, 7> columns{
      {{"contact"}, {"nodes before"}, {"too deep"}, {"deepest"}, {"nodes after"}, {"too deep"}, {"deepest"}}};
  append_table(
      columns, report.contacts.size(),
      [&](std::size_t i, Row<7>& row) {
        const FixContact& c = report.contacts[i];
        row = {std::to_string(c.id),     std::to_string(c.before.penetrations), std::to_string(c.before.released),
               number(c.before.deepest), std::to_string(c.after.penetrations),  std::to_string(c.after.released),
               number(c.after.deepest)};
      },
      "  ", out);
  for (const FixContact& c : report.contacts) {
    if (!c.not_checked.empty()) out += fmt::format("  contact {}: {}\n", c.id, printable(c.not_checked));
    if (c.edges_before > 0 || c.edges_after > 0)
      out += fmt::format("  contact {}: {} in others before, {} after\n", c.id, plural(c.edges_before, "edge"),
                         c.edges_after);
  }
}

void walls(const FixReport& report, std::string& out) {
  if (report.walls.empty()) return;
  constexpr std::array<Column, 5> columns{
      {{"rigid wall"}, {"nodes before"}, {"deepest"}, {"nodes after"}, {"deepest"}}};
  out += "\n";
  append_table(
      columns, report.walls.size(),
      [&](std::size_t i, Row<5>& row) {
        const FixWall& wall = report.walls[i];
        row = {std::to_string(wall.id), std::to_string(wall.before.penetrations), number(wall.before.deepest),
               std::to_string(wall.after.penetrations), number(wall.after.deepest)};
      },
      "  ", out);
}

void moves(const FixReport& report, std::size_t top, std::string& out) {
  if (report.moved.empty()) return;
  out += fmt::format("\n{} moved: at most {:.6g}, on average {:.6g}, together {:.6g}\n",
                     plural(report.moved.size(), "node"), report.largest_move, report.mean_move(), report.total_move);
  out += fmt::format("{} touched, {} with a worse shape\n", plural(report.elements_touched, "element"),
                     report.elements_worsened);
  std::vector<const MovedNode*> list;
  for (const MovedNode& node : report.moved) list.push_back(&node);
  std::stable_sort(list.begin(), list.end(),
                   [](const MovedNode* a, const MovedNode* b) { return a->distance() > b->distance(); });
  list.resize(std::min(top, list.size()));
  if (list.empty()) return;
  constexpr std::array<Column, 6> columns{{{"node"}, {"move"}, {"dx"}, {"dy"}, {"dz"}, {"line", Align::left}}};
  append_table(
      columns, list.size(),
      [&](std::size_t i, Row<6>& row) {
        const MovedNode& node = *list[i];
        const Vector d = node.to - node.from;
        row = {std::to_string(node.node),
               number(node.distance()),
               number(d.x()),
               number(d.y()),
               number(d.z()),
               file_and_line(report, node.file, node.line) + (node.onto_tie ? "  (tied)" : "")};
      },
      "  ", out);
  if (report.moved.size() > list.size()) out += fmt::format("  {} more\n", report.moved.size() - list.size());
}

void remaining(const FixReport& report, std::size_t top, std::string& out) {
  if (report.separated_ties_before > 0)
    out += fmt::format("\ntied nodes off their segments: {} before, {} after\n", report.separated_ties_before,
                       report.separated_ties_after);
  if (penetrating_after(report) == 0) return;
  out += fmt::format("\n{} not freed by any movement\n", plural(penetrating_after(report), "node"));
  std::vector<std::pair<std::string, const UnfixedNode*>> list;
  for (const UnfixedNode& node : report.unfixed)
    list.emplace_back(std::to_string(report.contacts[node.contact].id), &node);
  for (const FixWall& wall : report.walls)
    for (const UnfixedNode& node : wall.unfixed) list.emplace_back(fmt::format("wall {}", wall.id), &node);
  const std::size_t count = std::min(top, list.size());
  if (count == 0) return;
  constexpr std::array<Column, 6> columns{
      {{"contact"}, {"node"}, {"element"}, {"penetration"}, {"why", Align::left}, {"line", Align::left}}};
  append_table(
      columns, count,
      [&](std::size_t i, Row<6>& row) {
        const UnfixedNode& node = *list[i].second;
        row = {
            list[i].first,      std::to_string(node.node),       node.element == 0 ? "-" : std::to_string(node.element),
            number(node.depth), std::string(words(node.reason)), file_and_line(report, node.file, node.line)};
      },
      "  ", out);
  if (list.size() > count) out += fmt::format("  {} more\n", list.size() - count);
}

void crossings(const FixReport& report, std::size_t top, std::string& out) {
  const std::size_t count = std::min(top, report.crossings.size());
  for (std::size_t i = 0; i < count; ++i) {
    const LeftCrossing& c = report.crossings[i];
    out += fmt::format("  contact {}, {} and {}: {}, such as elements {} and {}: {}\n", report.contacts[c.contact].id,
                       part_name(c.part), part_name(c.other_part), plural(c.pairs, "pair"), c.element, c.other_element,
                       c.why);
  }
  if (report.crossings.size() > count)
    out += fmt::format("  {} more\n", plural(report.crossings.size() - count, "such place"));
}

void enclosed(const FixReport& report, std::size_t top, std::string& out) {
  if (report.enclosed.empty()) return;
  out += "\nsolids that lie wholly inside another part: cut out their space there, exclude the pair or move them\n";
  const std::size_t count = std::min(top, report.enclosed.size());
  for (std::size_t i = 0; i < count; ++i) {
    const EnclosedSolids& body = report.enclosed[i];
    out += fmt::format("  contact {}, {} of {} in {}, from solid {} on\n", report.contacts[body.contact].id,
                       plural(body.solids, "solid"), part_name(body.part), part_name(body.outer_part), body.element);
  }
  if (report.enclosed.size() > count) out += fmt::format("  {} more\n", report.enclosed.size() - count);
}

void proposals(const FixReport& report, std::size_t top, std::string& out) {
  if (report.proposals.empty()) return;
  out += "\nInstead of moving nodes\n";
  const std::size_t count = std::min(top, report.proposals.size());
  for (std::size_t i = 0; i < count; ++i) {
    const FixProposal& p = report.proposals[i];
    out += fmt::format("  contact {}, {} and {}: {}, at most {:.6g} deep\n", p.contact, part_name(p.part),
                       part_name(p.other_part), plural(p.penetrations, "penetration"), p.deepest);
    if (p.not_searched)
      out += "    a thickness was searched for the first pairs only\n";
    else if (p.thickness == 0)
      out += "    no thickness was found that helps\n";
    for (const FixAlternative& a : p.alternatives) {
      out += "    " + a.text + "\n";
      for (std::size_t at = 0; at < a.card.size();) {
        const std::size_t end = a.card.find('\n', at);
        out += "      " + a.card.substr(at, end - at) + "\n";
        at = end == std::string::npos ? a.card.size() : end + 1;
      }
    }
  }
  if (report.proposals.size() > count)
    out += fmt::format("  {} more\n", plural(report.proposals.size() - count, "pair"));
}

Json vector_json(const Vector& x) { return Json::array({x.x(), x.y(), x.z()}); }

Json state_json(const FixContact::State& state) {
  return {{"penetrations", state.penetrations}, {"released", state.released}, {"max_penetration", state.deepest}};
}

void place_json(const FixReport& report, std::uint32_t file, std::uint32_t line, Json& json) {
  if (file >= report.files.size()) return;
  json["file"] = report.files[file];
  json["line"] = line;
}

Json fix_contact_json(const FixContact& c) {
  Json json{{"id", c.id}, {"keyword", c.keyword}};
  if (!c.title.empty()) json["title"] = c.title;
  if (!c.not_checked.empty()) json["not_checked"] = c.not_checked;
  json["before"] = state_json(c.before);
  json["after"] = state_json(c.after);
  if (c.by_segments) json["by_segments"] = true;
  if (c.edges_before > 0 || c.edges_after > 0) json["edges"] = {{"before", c.edges_before}, {"after", c.edges_after}};
  return json;
}

Json moved_json(const FixReport& report, const MovedNode& node) {
  Json json{
      {"node", node.node}, {"from", vector_json(node.from)}, {"to", vector_json(node.to)}, {"move", node.distance()}};
  if (node.onto_tie) json["onto_tie"] = true;
  place_json(report, node.file, node.line, json);
  return json;
}

Json wall_json(const FixReport& report, const FixWall& wall) {
  Json json{{"id", wall.id}};
  if (!wall.title.empty()) json["title"] = wall.title;
  const auto state = [](const FixContact::State& s) {
    return Json{{"penetrations", s.penetrations}, {"max_penetration", s.deepest}};
  };
  json["before"] = state(wall.before);
  json["after"] = state(wall.after);
  json["unfixed"] = Json::array();
  for (const UnfixedNode& node : wall.unfixed) {
    Json one{{"node", node.node}, {"penetration", node.depth}, {"reason", name(node.reason)}};
    place_json(report, node.file, node.line, one);
    json["unfixed"].push_back(std::move(one));
  }
  return json;
}

Json unfixed_json(const FixReport& report, const UnfixedNode& node) {
  Json json{{"contact", report.contacts[node.contact].id}, {"node", node.node}};
  if (node.part != 0) json["part"] = node.part;
  if (node.element != 0) json["element"] = node.element;
  if (node.element_part != 0) json["element_part"] = node.element_part;
  json["penetration"] = node.depth;
  json["contact_distance"] = node.contact_distance;
  if (node.released) json["released"] = true;
  json["reason"] = name(node.reason);
  place_json(report, node.file, node.line, json);
  return json;
}

Json crossing_json(const FixReport& report, const LeftCrossing& c) {
  return {{"contact", report.contacts[c.contact].id},
          {"part", c.part},
          {"other_part", c.other_part},
          {"element", c.element},
          {"other_element", c.other_element},
          {"pairs", c.pairs},
          {"why", c.why}};
}

Json proposal_json(const FixProposal& p) {
  Json json{{"contact", p.contact},
            {"part", p.part},
            {"other_part", p.other_part},
            {"penetrations", p.penetrations},
            {"max_penetration", p.deepest}};
  if (p.thickness > 0) json["thickness"] = p.thickness;
  if (p.not_searched) json["not_searched"] = true;
  json["alternatives"] = Json::array();
  for (const FixAlternative& a : p.alternatives) json["alternatives"].push_back({{"text", a.text}, {"card", a.card}});
  return json;
}

}  // namespace

std::string said_of(const FixReport& report) {
  const std::string_view run = report.proof ? verdict(*report.proof) : "";
  return fmt::format(
      "{} penetrating before, {} after{}; {} moved in {}{}{}", plural(penetrating_before(report), "node"),
      penetrating_after(report),
      report.crossings_after > 0 ? fmt::format(", {} of elements cross", plural(report.crossings_after, "pair")) : "",
      plural(report.moved.size(), "node"), plural(report.changed.size(), "file"),
      report.dry_run ? "; nothing was written" : "", run);
}

std::string fix_text(const FixReport& report, const FixTextOptions& options) {
  std::string out;
  if (!options.quiet) {
    out = fmt::format("{}\n\n", printable_path(report.input));
    contacts(report, out);
    walls(report, out);
    moves(report, options.top, out);
    remaining(report, options.top, out);
    if (report.crossings_before > 0 || report.crossings_after > 0)
      out += fmt::format("\npairs of elements that cross: {} before, {} after\n", report.crossings_before,
                         report.crossings_after);
    crossings(report, options.top, out);
    enclosed(report, options.top, out);
    if (report.proof) append_proof(*report.proof, out);
    proposals(report, options.top, out);
    if (!report.notes.empty()) out += "\n";
    for (const std::string& note : report.notes) out += "note: " + printable(note) + "\n";
    if (!report.changed.empty()) out += "\n";
    for (const FixedFile& file : report.changed)
      out += fmt::format("{}: {} changed{}\n", printable(file.path), plural(file.lines, "line"),
                         file.written.empty() ? "" : ", written to " + printable(file.written));
    out += "\n";
  }
  return out + said_of(report) + "\n";
}

std::string fix_json(const FixReport& report) {
  Json json{{"schema", "gapcheck-fix/1"}, {"input", report.input}, {"dry_run", report.dry_run}};
  for (const char* list :
       {"contacts", "walls", "moved", "unfixed", "crossings", "enclosed", "proposals", "files", "notes"})
    json[list] = Json::array();
  for (const FixContact& c : report.contacts) json["contacts"].push_back(fix_contact_json(c));
  for (const FixWall& wall : report.walls) json["walls"].push_back(wall_json(report, wall));
  for (const MovedNode& node : report.moved) json["moved"].push_back(moved_json(report, node));
  for (const UnfixedNode& node : report.unfixed) json["unfixed"].push_back(unfixed_json(report, node));
  for (const LeftCrossing& c : report.crossings) json["crossings"].push_back(crossing_json(report, c));
  for (const EnclosedSolids& body : report.enclosed)
    json["enclosed"].push_back({{"contact", report.contacts[body.contact].id},
                                {"part", body.part},
                                {"outer_part", body.outer_part},
                                {"element", body.element},
                                {"solids", body.solids}});
  for (const FixProposal& p : report.proposals) json["proposals"].push_back(proposal_json(p));
  for (const FixedFile& file : report.changed) {
    json["files"].push_back({{"path", file.path}, {"lines", file.lines}});
    if (!file.written.empty()) json["files"].back()["written"] = file.written;
  }
  for (const std::string& note : report.notes) json["notes"].push_back(note);
  json["summary"] = {{"complete", complete(report)},
                     {"largest_move", report.largest_move},
                     {"mean_move", report.mean_move()},
                     {"total_move", report.total_move},
                     {"elements_touched", report.elements_touched},
                     {"elements_worsened", report.elements_worsened},
                     {"crossings_before", report.crossings_before},
                     {"crossings_after", report.crossings_after},
                     {"separated_ties_before", report.separated_ties_before},
                     {"separated_ties_after", report.separated_ties_after},
                     {"rounds", report.rounds},
                     {"cut_short", report.cut_short}};
  if (report.proof) json["proof"] = proof_json(*report.proof);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gapcheck::report
