#include "report/format/repair_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "records/record_rules.hpp"
#include "report/format/fix_proof_report.hpp"
#include "report/format/fix_words.hpp"
#include "report/format/repair_words.hpp"
#include "report/format/sarif_fix.hpp"
#include "report/item/describe.hpp"
#include "report/write/percent_encoding.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using fix_words::part_name;
using fix_words::plural;

void each_line(std::string_view text, const auto& visit) {
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    visit(text.substr(at, end - at));
    at = end + 1;
  }
}

/// The lines that a repair takes out and puts in.
void changes(const std::vector<RepairLine>& lines, std::string_view indent, std::string& out) {
  for (const RepairLine& line : lines) {
    out += fmt::format("{}{}:{}\n", indent, printable_path(line.file), line.line);
    bool stays = false;
    each_line(line.after, [&](std::string_view text) { stays = stays || text == line.before; });
    if (!stays) out += fmt::format("{}  - {}\n", indent, printable(line.before));
    each_line(line.after, [&](std::string_view text) {
      if (text != line.before) out += fmt::format("{}  + {}\n", indent, printable(text));
    });
  }
}

std::string heading(const RepairPair& pair) {
  if (pair.of_ties)
    return fmt::format("contact {}: {} too far away to tie, at most {:.6g} from the segment, where {:.6g} tie",
                       pair.parts.contact, plural(pair.penetrations, "node"), pair.deepest, pair.contact_distance);
  return fmt::format("contact {}, {} and {}: {}, at most {:.6g}{} deep{}", pair.parts.contact, part_name(pair.parts.a),
                     part_name(pair.parts.b), plural(pair.penetrations, "penetration"), pair.deepest,
                     pair.contact_distance > 0 ? fmt::format(" of {:.6g}", pair.contact_distance) : "",
                     pair.released > 0 ? fmt::format(", {} released", pair.released) : "");
}

void pair_table(const RepairPair& pair, std::string& out) {
  out += fmt::format("\n{}  {}\n", pair.number, heading(pair));
  constexpr std::array<Column, 5> columns{
      {{"repair", Align::left}, {"left"}, {"worse elsewhere"}, {"cost"}, {"what it does", Align::left}}};
  append_table(
      columns, pair.repairs.size(),
      [&](std::size_t i, Row<5>& row) {
        const Repair& repair = pair.repairs[i];
        const RepairOutcome& o = repair.outcome;
        const bool known = pair.tried && o.refused.empty();
        row = {repair.id, known ? std::to_string(o.left) : "-", known ? std::to_string(o.remaining() - o.left) : "-",
               known ? fmt::format("{:.2f}", repair.cost) : "-", what_it_does(repair)};
      },
      "   ", out);
  for (const Repair& repair : pair.repairs) {
    if (repair.lines.empty()) continue;
    out += fmt::format("   {} writes\n", repair.id);
    changes(repair.lines, "     ", out);
  }
}

std::string last_line(const RepairPlan& plan) {
  const std::vector<std::string> best = plan.best();
  const auto ties = static_cast<std::uint64_t>(std::ranges::count(plan.pairs, true, &RepairPair::of_ties));
  std::string line = fmt::format("{} in {} of parts", plural(plan.penetrating, "penetration"),
                                 plural(plan.pairs.size() - ties, "pair"));
  if (plan.too_far > 0)
    line += fmt::format(", {} too far to tie in {}", plural(plan.too_far, "node"), plural(ties, "contact"));
  if (!plan.pairs.empty())
    line += best.empty() ? "; best: none without changing what the parts do to each other"
                         : fmt::format("; best: {}{}", fmt::join(best, ","),
                                       best.size() < plan.pairs.size() ? " (none for the others)" : "");
  return line + "\n";
}

std::string last_line(const AppliedRepairs& applied) {
  std::string line =
      fmt::format("{}{}{} before, {} after", fmt::join(applied.ids, ","), applied.ids.empty() ? "" : ": ",
                  plural(applied.before(), "penetration"), applied.after());
  if (applied.too_far_before + applied.too_far_after > 0)
    line += fmt::format("; {} too far to tie before, {} after", plural(applied.too_far_before, "node"),
                        applied.too_far_after);
  std::uint64_t lines = 0;
  for (const FixedFile& file : applied.files) lines += file.lines;
  line += lines == 0 ? "; nothing changed"
                     : fmt::format("; {} of {} changed", plural(lines, "line"), plural(applied.files.size(), "file"));
  if (applied.dry_run) line += "; nothing was written";
  if (applied.proof) line += verdict(*applied.proof);
  return line + "\n";
}

Json lines_json(const std::vector<RepairLine>& lines) {
  Json list = Json::array();
  for (const RepairLine& line : lines)
    list.push_back({{"file", line.file}, {"line", line.line}, {"before", line.before}, {"after", line.after}});
  return list;
}

Json repair_json(const Repair& repair) {
  const RepairOutcome& o = repair.outcome;
  Json json{{"id", repair.id}, {"kind", name(repair.kind)}, {"text", repair.text}};
  if (!o.refused.empty()) {
    json["refused"] = o.refused;
    return json;
  }
  json["solves"] = o.solves();
  json["cost"] = repair.cost;
  json["left"] = o.left;
  json["forgiven"] = o.forgiven;
  json["elsewhere"] = {
      {"penetrations", o.added}, {"ties_lost", o.lost_ties}, {"untied", o.untied}, {"crossings", o.crossings}};
  if (repair.kind == RepairKind::move)
    json["moves"] = {{"nodes", o.moved}, {"largest", o.largest_move}, {"elements", o.changed_elements}};
  json["lines"] = lines_json(repair.lines);
  return json;
}

/// The rule that the nodes of a pair are findings of.
const RuleIdentity& pair_rule(const RepairPair& pair) {
  if (pair.of_ties) return record_rules::untied_node;
  return pair.released > 0 ? record_rules::released_node : record_rules::initial_penetration;
}

Json result_json(const RepairPair& pair, const std::string& input) {
  const RuleIdentity& rule = pair_rule(pair);
  Json result{{"ruleId", rule.id},
              {"level", name(rule.severity)},
              {"message", {{"text", heading(pair)}}},
              {"locations", Json::array({{{"physicalLocation", {{"artifactLocation", {{"uri", file_uri(input)}}}}}}})},
              {"fixes", Json::array()}};
  for (const Repair& repair : pair.repairs)
    if (pair.tried && repair.outcome.solves() && !repair.lines.empty()) result["fixes"].push_back(sarif_fix(repair));
  return result;
}

}  // namespace

std::string plan_sarif(const RepairPlan& plan, std::string_view version) {
  Json results = Json::array();
  for (const RepairPair& pair : plan.pairs) results.push_back(result_json(pair, plan.input));
  const Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({{{"tool", {{"driver", {{"name", "gapcheck"}, {"version", version}}}}},
                                        {"columnKind", "utf16CodeUnits"},
                                        {"automationDetails", {{"id", fmt::format("gapcheck-fix/{}/", plan.input)}}},
                                        {"results", std::move(results)}}})}};
  return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string plan_text(const RepairPlan& plan, const FixTextOptions& options) {
  if (options.quiet) return last_line(plan);
  std::string out = fmt::format("{}\n", printable_path(plan.input));
  const std::size_t count = std::min(options.top, plan.pairs.size());
  for (std::size_t i = 0; i < count; ++i) pair_table(plan.pairs[i], out);
  if (plan.pairs.size() > count) out += fmt::format("\n{} more\n", plural(plan.pairs.size() - count, "pair"));
  if (!plan.notes.empty()) out += "\n";
  for (const std::string& note : plan.notes) out += "note: " + printable(note) + "\n";
  if (plan.trials > 0)
    out += fmt::format("\n{} written into the deck, read again and audited\n",
                       plan.trials == 1 ? "1 repair was" : fmt::format("{} repairs were", plan.trials));
  return out + last_line(plan);
}

std::string plan_json(const RepairPlan& plan) {
  Json json{
      {"schema", "gapcheck-fix-plan/1"}, {"input", plan.input}, {"pairs", Json::array()}, {"ties", Json::array()}};
  for (const RepairPair& pair : plan.pairs) {
    Json entry{{"number", pair.number}, {"contact", pair.parts.contact}};
    if (pair.of_ties)
      entry.update(
          {{"too_far", pair.penetrations}, {"distance", pair.deepest}, {"tie_distance", pair.contact_distance}});
    else
      entry.update({{"part", pair.parts.a},
                    {"other_part", pair.parts.b},
                    {"penetrations", pair.penetrations},
                    {"released", pair.released},
                    {"max_penetration", pair.deepest},
                    {"contact_distance", pair.contact_distance}});
    entry["tried"] = pair.tried;
    entry["repairs"] = Json::array();
    if (pair.tried)
      for (const Repair& repair : pair.repairs) entry["repairs"].push_back(repair_json(repair));
    json[pair.of_ties ? "ties" : "pairs"].push_back(std::move(entry));
  }
  json["best"] = plan.best();
  json["notes"] = plan.notes;
  json["summary"] = {{"penetrations", plan.penetrating}, {"too_far", plan.too_far}, {"trials", plan.trials}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string applied_text(const AppliedRepairs& applied, const FixTextOptions& options) {
  if (options.quiet) return last_line(applied);
  std::string out = fmt::format("{}\n\n", printable_path(applied.input));
  constexpr std::array<Column, 5> columns{{{"contact"}, {"before"}, {"without force"}, {"after"}, {"without force"}}};
  append_table(
      columns, applied.contacts.size(),
      [&](std::size_t i, Row<5>& row) {
        const AppliedRepairs::Contact& c = applied.contacts[i];
        row = {std::to_string(c.id), std::to_string(c.before), std::to_string(c.forgiven_before),
               std::to_string(c.after), std::to_string(c.forgiven)};
      },
      "  ", out);
  if (applied.ties_before != applied.ties_after)
    out += fmt::format("  tied nodes: {} before, {} after\n", applied.ties_before, applied.ties_after);
  if (applied.moved > 0)
    out += fmt::format("\n{} moved, at most {:.6g}\n", plural(applied.moved, "node"), applied.largest_move);
  if (!applied.lines.empty()) out += "\n";
  changes(applied.lines, "  ", out);
  if (applied.proof) append_proof(*applied.proof, out);
  if (!applied.notes.empty()) out += "\n";
  for (const std::string& note : applied.notes) out += "note: " + printable(note) + "\n";
  if (!applied.files.empty()) out += "\n";
  for (const FixedFile& file : applied.files)
    out += fmt::format("{}: {} changed{}\n", printable(file.path), plural(file.lines, "line"),
                       file.written.empty() ? "" : ", written to " + printable(file.written));
  return out + "\n" + last_line(applied);
}

std::string applied_json(const AppliedRepairs& applied) {
  Json json{{"schema", "gapcheck-fix-applied/1"},
            {"input", applied.input},
            {"dry_run", applied.dry_run},
            {"repairs", applied.ids},
            {"contacts", Json::array()},
            {"lines", lines_json(applied.lines)},
            {"files", Json::array()},
            {"notes", applied.notes}};
  for (const AppliedRepairs::Contact& c : applied.contacts)
    json["contacts"].push_back({{"id", c.id},
                                {"keyword", c.keyword},
                                {"before", {{"penetrations", c.before}, {"forgiven", c.forgiven_before}}},
                                {"after", {{"penetrations", c.after}, {"forgiven", c.forgiven}}}});
  for (const FixedFile& file : applied.files) {
    json["files"].push_back({{"path", file.path}, {"lines", file.lines}});
    if (!file.written.empty()) json["files"].back()["written"] = file.written;
  }
  json["summary"] = {{"complete", applied.complete()},        {"moved", applied.moved},
                     {"largest_move", applied.largest_move},  {"ties_before", applied.ties_before},
                     {"ties_after", applied.ties_after},      {"too_far_before", applied.too_far_before},
                     {"too_far_after", applied.too_far_after}};
  if (applied.proof) json["proof"] = proof_json(*applied.proof);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gapcheck::report
