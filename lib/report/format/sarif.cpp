#include <fmt/compile.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "report/baseline/baseline.hpp"
#include "report/format/formats.hpp"
#include "report/format/sarif_fix.hpp"
#include "report/item/causes.hpp"
#include "report/item/describe.hpp"
#include "report/item/fingerprint.hpp"
#include "report/item/item.hpp"
#include "report/write/json_members.hpp"
#include "report/write/percent_encoding.hpp"
#include "report/write/stream.hpp"

namespace gapcheck::report {
namespace {

void append_text(std::string_view key, std::string_view text, Members& object) {
  object.object(key, [&](Members& message) { message.string("text", text); });
}

/// `line` 0: the whole file.
void append_place(std::string_view file, std::uint32_t line, Members& location) {
  location.object("physicalLocation", [&](Members& physical) {
    physical.object("artifactLocation", [&](Members& artifact) { artifact.string("uri", file_uri(file)); });
    if (line != 0) physical.object("region", [&](Members& region) { region.integer("startLine", line); });
  });
}

/// Which deck the results of a run with several decks are about; the members that say so are empty for one deck.
struct Target {
  std::size_t index = 0;
  std::string_view deck{};
};

void append_target(const Target& target, Members& result) {
  if (target.deck.empty()) return;
  result.object("analysisTarget", [&](Members& artifact) {
    artifact.string("uri", file_uri(target.deck));
    artifact.integer("index", target.index);
  });
}

/// Variants of a deck have findings in the same places.
void append_fingerprint(std::uint64_t value, const Target& target, Members& result) {
  result.object("partialFingerprints", [&](Members& prints) {
    prints.fingerprint(value, "gapcheck/v1");
    if (!target.deck.empty()) prints.string("gapcheck/deck", target.deck);
  });
}

void append_rule(const RuleText& rule, Buffer& out) {
  Members object(out);
  object.string("id", rule.id);
  object.string("name", rule.name);
  append_text("shortDescription", rule.summary, object);
  if (!rule.page.empty())
    object.object("help", [&](Members& help) {
      help.string("text", rule.page);
      help.string("markdown", rule.page);
    });
  object.object("defaultConfiguration",
                [&](Members& configuration) { configuration.plain("level", name(rule.severity)); });
  object.close();
}

/// The deck's entities that the finding names, as logical locations.
void append_entities(const Item& item, Members& location, Buffer& out) {
  const std::pair<std::string_view, std::int64_t> entities[] = {
      {"contact", item.contact}, {"node", item.node}, {"element", item.element}};
  bool first = true;
  for (const auto& [kind, id] : entities) {
    if (id == 0) continue;
    if (std::exchange(first, false)) {
      location.key("logicalLocations");
      out.push_back('[');
    } else {
      out.push_back(',');
    }
    fmt::format_to(fmt::appender(out), FMT_COMPILE("{{\"name\":\"{0} {1}\",\"kind\":\"{0}\"}}"), kind, id);
  }
  if (!first) out.push_back(']');
}

void append_properties(const Item& item, Members& result, Buffer& out) {
  result.key("properties");
  Members properties(out);
  if (item.part != 0) properties.integer("part", item.part);
  if (item.element_part != 0) properties.integer("elementPart", item.element_part);
  if (item.penetration >= 0) properties.number("penetration", item.penetration);
  if (item.contact_distance >= 0) properties.number("contactDistance", item.contact_distance);
  if (item.position)
    properties.array("position", std::array{item.position->x(), item.position->y(), item.position->z()});
  if (!item.outcome.empty()) properties.plain("outcome", item.outcome);
  properties.close();
}

/// In the words of SARIF.
std::string_view baseline_state(BaselineState state) { return state == BaselineState::worse ? "updated" : name(state); }

/// Says why the finding does not count, and where that is written.
void append_suppression(const IgnoreSource& source, Members& result, Buffer& out) {
  result.key("suppressions");
  out.push_back('[');
  Members suppression(out);
  suppression.plain("kind", source.in_deck ? "inSource" : "external");
  if (!source.reason.empty()) suppression.string("justification", source.reason);
  suppression.object("location", [&](Members& location) { append_place(source.file, source.line, location); });
  suppression.close();
  out.push_back(']');
}

/// A place that explains a result, with a sentence about it.
void append_related_place(std::string_view file, std::uint32_t line, std::string_view text, Buffer& out) {
  if (out.size() > 0) out.push_back(',');
  Members location(out);
  append_place(file, line, location);
  append_text("message", text, location);
  location.close();
}

/// The cards of the contacts, each as a related location; empty where the file is not known.
std::vector<std::string> contact_places(const Report& report) {
  std::vector<std::string> places;
  for (const ContactSummary& contact : report.contacts) {
    Buffer place;
    if (!contact.file.empty()) {
      const std::string title = contact.title.empty() ? "" : fmt::format(" \"{}\"", contact.title);
      append_related_place(contact.file, contact.line,
                           fmt::format("contact {}{}: *{}", contact.id, title, contact.keyword), place);
    }
    places.push_back(fmt::to_string(place));
  }
  return places;
}

/// What explains a finding: the card of its contact, unless it is reported there, and the finding that it follows from.
void append_related(const Item& item, const Report& report, const std::vector<std::string>& contacts,
                    const Finding* cause, Members& result, Buffer& out) {
  Buffer places;
  if (item.of_contact()) {
    const ContactSummary& contact = report.contacts[item.contact_position];
    if (item.file != contact.file || item.line != contact.line)
      places.append(std::string_view(contacts[item.contact_position]));
  }
  if (cause != nullptr && !cause->file.empty())
    append_related_place(cause->file, cause->line, "follows from " + cause->id + ": " + cause->message, places);
  if (places.size() == 0) return;
  result.key("relatedLocations");
  out.push_back('[');
  out.append(places);
  out.push_back(']');
}

/// What all results of a report need.
struct ResultContext {
  const Report& report;
  const std::vector<std::string>& contacts;  ///< contact_places()
  const Target& target;
  const FindingFixes* fixes;  ///< nullptr: none
};

void append_fixes(const Item& item, const FindingFixes& fixes, Members& result, Buffer& out) {
  const auto found = fixes.find(item.number);
  if (found == fixes.end()) return;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Repair* repair : found->second) list.push_back(sarif_fix(*repair));
  result.key("fixes");
  out.append(list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// `rule`: position among the tool's rules, or npos. `cause`: the finding that this one follows from; nullptr: none.
void append_result(const Item& item, std::size_t rule, const Finding* cause, const ResultContext& context,
                   Buffer& out) {
  Members result(out);
  result.string("ruleId", item.id);
  if (rule != std::string_view::npos) result.integer("ruleIndex", rule);
  result.plain("level", name(item.severity));
  append_text("message", item.message, result);
  result.key("locations");
  out.push_back('[');
  Members location(out);
  append_place(item.file.empty() ? context.report.input : item.file, item.line, location);
  append_entities(item, location, out);
  location.close();
  out.push_back(']');
  append_target(context.target, result);
  append_related(item, context.report, context.contacts, cause, result, out);
  if (item.count > 1) result.integer("occurrenceCount", item.count);
  append_fingerprint(item.fingerprint, context.target, result);
  if (item.state) result.plain("baselineState", baseline_state(*item.state));
  if (item.ignored != nullptr) append_suppression(*item.ignored, result, out);
  if (context.fixes != nullptr) append_fixes(item, *context.fixes, result, out);
  append_properties(item, result, out);
  result.close();
}

/// A finding of the baseline that is gone; its place in the files is not known.
void append_absent(const KnownFinding& finding, std::string_view input, const Target& target, Buffer& out) {
  Members result(out);
  result.string("ruleId", finding.id);
  result.plain("level", name(finding.severity));
  append_text("message", describe(finding), result);
  result.key("locations");
  out.push_back('[');
  Members location(out);
  append_place(input, 0, location);
  location.close();
  out.push_back(']');
  append_target(target, result);
  append_fingerprint(fingerprint(finding), target, result);
  result.plain("baselineState", "absent");
  result.close();
}

using RulePositions = std::unordered_map<std::string_view, std::size_t>;

RulePositions append_tool(std::string_view version, std::span<const RuleText> rules, Stream& stream) {
  stream.text("{\"tool\":{\"driver\":{\"name\":\"gapcheck\",\"version\":");
  stream.text(json_string(version));
  stream.text(",\"rules\":[");
  RulePositions positions;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    positions.emplace(rules[i].id, i);
    stream.separator(i == 0);
    append_rule(rules[i], stream.buffer);
  }
  stream.text("]}},\"columnKind\":\"utf16CodeUnits\"");
  return positions;
}

/// `first`: no results came before; false afterwards if there are some.
void append_results(const Report& report, const Target& target, const RulePositions& rules, const FindingFixes* fixes,
                    bool& first, Stream& stream) {
  const Items items(report), ignored = Items::ignored(report);
  const std::vector<std::string> contacts = contact_places(report);
  const Causes causes(report);
  const std::size_t records = report.penetrations.size() + report.tie_failures.size();
  const auto append = [&](const Item& item, const Finding* cause, Buffer& out) {
    const auto rule = rules.find(item.id);
    append_result(item, rule == rules.end() ? std::string_view::npos : rule->second, cause,
                  {report, contacts, target, fixes}, out);
  };
  stream.lines(items.size(), first, [&](std::size_t i, Buffer& out) {
    append(items[i], i < records ? nullptr : causes.of(report.findings[i - records]), out);
  });
  first = first && items.size() == 0;
  stream.lines(ignored.size(), first, [&](std::size_t i, Buffer& out) { append(ignored[i], nullptr, out); });
  first = first && ignored.size() == 0;
  if (!report.baseline) return;
  for (const KnownFinding& finding : report.baseline->gone) {
    stream.separator(std::exchange(first, false));
    append_absent(finding, report.input, target, stream.buffer);
  }
}

void append_run_of_deck(const Report& report, std::string_view version, std::span<const RuleText> rules,
                        const FindingFixes* fixes, Stream& stream) {
  const RulePositions positions = append_tool(version, rules, stream);
  // One category per deck: code scanning refuses several runs of one.
  stream.text(",\"automationDetails\":{\"id\":");
  stream.text(json_string(fmt::format("gapcheck/{}/", report.input)));
  stream.text("},\n\"results\":[");
  bool first = true;
  append_results(report, {}, positions, fixes, first, stream);
  stream.text("]}");
}

/// Decks that were not audited, so that nobody takes their findings for gone.
void append_not_audited(std::span<const Unread> unread, Stream& stream) {
  if (unread.empty()) return;
  stream.text(",\"invocations\":[{\"executionSuccessful\":false,\"toolExecutionNotifications\":[");
  bool first = true;
  for (const Unread& each : unread) {
    stream.separator(std::exchange(first, false));
    Members notification(stream.buffer);
    notification.plain("level", "error");
    append_text("message", fmt::format("{}: {}", each.deck, each.reason), notification);
    notification.close();
  }
  stream.text("]}]");
}

/// One run of several decks, which are its artifacts: services take few runs of a file. It names no category, so that
/// who uploads it does.
void append_run_of_decks(const Reports& reports, std::string_view version, std::span<const RuleText> rules,
                         std::span<const FindingFixes> fixes, Stream& stream) {
  const RulePositions positions = append_tool(version, rules, stream);
  append_not_audited(reports.unread, stream);
  stream.text(",\n\"artifacts\":[");
  for (std::size_t i = 0; i < reports.all.size(); ++i) {
    stream.separator(i == 0);
    Members artifact(stream.buffer);
    artifact.object("location", [&](Members& place) { place.string("uri", file_uri(reports.all[i].input)); });
    artifact.key("roles");
    stream.text("[\"analysisTarget\"]");
    artifact.close();
  }
  stream.text("],\n\"results\":[");
  bool first = true;
  for (std::size_t i = 0; i < reports.all.size() && stream.open(); ++i)
    append_results(reports.all[i], {i, reports.all[i].input}, positions, i < fixes.size() ? &fixes[i] : nullptr, first,
                   stream);
  stream.text("]}");
}

}  // namespace

void sarif(const Reports& reports, std::string_view version, std::span<const RuleText> rules, const Sink& sink,
           std::span<const FindingFixes> fixes) {
  Stream stream(sink);
  stream.text("{\"$schema\":\"https://json.schemastore.org/sarif-2.1.0.json\",\"version\":\"2.1.0\",\"runs\":[");
  if (reports.several() && !reports.all.empty())
    append_run_of_decks(reports, version, rules, fixes, stream);
  else if (!reports.all.empty())
    append_run_of_deck(reports.all.front(), version, rules, fixes.empty() ? nullptr : fixes.data(), stream);
  stream.text("]}\n");
  stream.flush();
}

}  // namespace gapcheck::report
