#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "report/baseline/baseline.hpp"
#include "report/baseline/rule_counts.hpp"
#include "report/format/json_portability.hpp"
#include "report/format/json_run.hpp"
#include "report/item/causes.hpp"
#include "report/item/describe.hpp"
#include "report/item/fingerprint.hpp"
#include "report/item/item.hpp"
#include "report/text/check_c_view.hpp"
#include "report/write/json_members.hpp"
#include "report/write/stream.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_json_string(std::string_view text, Buffer& out) {
  // Most strings are plain ASCII.
  const auto escaped = [](char c) { return c < ' ' || c == '"' || c == '\\' || static_cast<unsigned char>(c) >= 0x7f; };
  if (std::any_of(text.begin(), text.end(), escaped)) return out.append(json_string(text));
  append_quoted(text, out);
}

namespace {

std::array<double, 3> coordinates(const Vector& x) { return {x[0], x[1], x[2]}; }

void append_model(const ModelCounts& model, Buffer& out) {
  Members object(out);
  object.integer("nodes", model.nodes);
  object.integer("shells", model.shells);
  object.integer("solids", model.solids);
  object.integer("beams", model.beams);
  object.integer("thick_shells", model.thick_shells);
  object.integer("discrete", model.discrete);
  object.integer("masses", model.masses);
  object.integer("particles", model.particles);
  object.integer("parts", model.parts);
  object.integer("contacts", model.contacts);
  object.close();
}

void append_summary(const InitialSummary& summary, Members& object) {
  object.object("initial_summary", [&](Members& entry) {
    entry.integer("messages", summary.messages);
    entry.integer("nodes", summary.nodes);
    entry.integer("eliminated", summary.eliminated);
    entry.number("least", summary.least);
    entry.number("greatest", summary.greatest);
  });
}

void append_contact(const Report& report, std::uint32_t position, Buffer& out) {
  const ContactSummary& contact = report.contacts[position];
  const bool deck = report.source == "deck";  // solver files do not know everything about a contact
  Members object(out);
  object.integer("id", contact.id);
  if (deck || contact.order != 0) object.integer("order", contact.order);
  if (deck || !contact.title.empty()) object.string("title", contact.title);
  if (deck || !contact.keyword.empty()) object.string("keyword", contact.keyword);
  if (deck || !contact.type.empty()) object.string("type", contact.type);
  if (deck || contact.tracked_nodes != 0) object.integer("tracked_nodes", contact.tracked_nodes);
  if (deck || contact.segments != 0) object.integer("segments", contact.segments);
  object.integer("penetrations", contact.penetrations);
  object.integer("released", contact.released);
  object.integer("edge_zone", contact.edge_zone);
  object.number("max_penetration", contact.max_penetration);
  const auto found = [&](std::string_view key, std::uint64_t number) {
    if (number > 0) object.integer(key, number);
  };
  found("segment_penetrations", contact.segment_penetrations);
  found("mortar_penetrations", contact.mortar_penetrations);
  found("edge_penetrations", contact.edge_penetrations);
  object.integer("ties", contact.ties);
  object.integer("untied", contact.untied);
  if (contact.out_of_reach != 0) object.integer("out_of_reach", contact.out_of_reach);
  if (contact.reported_penetrations != 0) object.integer("reported_penetrations", contact.reported_penetrations);
  if (contact.contact_time_s >= 0) object.number("contact_time_s", contact.contact_time_s);
  append_predicted_timesteps(report, position, object, out);
  if (contact.initial_summary) append_summary(*contact.initial_summary, object);
  if (contact.judged_nearest != 0) object.integer("judged_nearest", contact.judged_nearest);
  if (!contact.not_checked.empty()) object.string("not_checked", contact.not_checked);
  if (!contact.file.empty()) object.string("file", contact.file);
  if (contact.line != 0) object.integer("line", contact.line);
  object.close();
}

/// `files`: the report's file names, quoted.
void append_penetration(const Report& report, const Penetration& record, const std::vector<std::string>& files,
                        std::optional<BaselineState> state, Buffer& out) {
  const RuleIdentity rule = rule_of(report, record);
  const bool contact_known = record.contact < report.contacts.size();
  const std::int64_t contact = contact_known ? report.contacts[record.contact].id : 0;
  Members object(out);
  object.plain("rule", rule.name);
  object.plain("id", rule.id);
  object.plain("severity", name(rule.severity));
  object.key("message");
  out.push_back('"');
  append_message(record, out);
  out.push_back('"');
  if (contact_known) object.integer("contact", contact);
  object.integer("node", record.node);
  if (record.part != 0) object.integer("part", record.part);
  if (record.segment[0] != 0) object.array("segment", record.segment);
  if (record.element != 0) object.integer("element", record.element);
  if (record.element_part != 0) object.integer("element_part", record.element_part);
  // A line of a log that names little more than the node leaves the rest at zero.
  const bool deck = report.source == "deck", placed = deck || !record.original.isZero() || !record.moved_to.isZero();
  if (deck || record.depth > 0) object.number("penetration", record.depth);
  if (knows_remaining(report, record)) {
    object.number("remaining", record.remaining());
    object.number("contact_distance", record.contact_distance);
  }
  // Solver files may name the segment and not the place on it.
  if (std::isfinite(record.s) && std::isfinite(record.t) && (deck || record.segment[0] != 0)) {
    object.array("st", std::array{record.s, record.t});
    object.plain("feature", name(record.feature));
  }
  if (placed) object.array("original", coordinates(record.original));
  if (placed) object.array("point", coordinates(record.point));
  if (placed && (record.outcome == Outcome::moved || record.moved_to != record.original))
    object.array(record.recommended() ? "recommended" : "moved_to", coordinates(record.moved_to));
  // The solver does not list nodes of the edge zone, so nothing happens to them yet.
  if (record.kind != PenetrationKind::edge_zone &&
      (record.kind != PenetrationKind::edge || record.outcome != Outcome::reported))
    object.plain("outcome", name(record.outcome));
  if (record.node_rule != ThicknessRule::none || record.segment_rule != ThicknessRule::none) {
    object.key("cause");
    out.push_back('"');
    append_cause(record, out);
    out.push_back('"');
  }
  if (record.line != 0 && record.file < files.size()) {
    object.raw("file", files[record.file]);
    object.integer("line", record.line);
  }
  object.fingerprint(fingerprint(record, contact));
  append_state(state, object);
  object.close();
}

/// `cause`: the finding that this one follows from; nullptr: none.
void append_finding(const Finding& finding, const Finding* cause, std::optional<BaselineState> state, Buffer& out) {
  Members object(out);
  object.string("rule", finding.rule);
  object.string("id", finding.id);
  object.plain("severity", name(finding.severity));
  object.string("message", finding.message);
  const auto id = [&](std::string_view key, std::int64_t value) {
    if (value != 0) object.integer(key, value);
  };
  id("contact", finding.contact);
  id("node", finding.node);
  id("part", finding.part);
  id("element", finding.element);
  id("element_part", finding.element_part);
  if (finding.penetration >= 0) object.number("penetration", finding.penetration);
  if (finding.contact_distance >= 0) object.number("contact_distance", finding.contact_distance);
  if (finding.point) object.array("point", coordinates(*finding.point));
  if (finding.count > 1) object.integer("count", static_cast<std::int64_t>(finding.count));
  if (!finding.file.empty()) object.string("file", finding.file);
  if (finding.line != 0) object.integer("line", finding.line);
  object.fingerprint(fingerprint(finding));
  if (cause != nullptr) object.fingerprint(fingerprint(*cause), "cause");
  append_state(state, object);
  object.close();
}

void append_timing(const Timing& timing, Buffer& out) {
  Members object(out);
  object.number("read_s", timing.read_s);
  object.number("model_s", timing.model_s);
  object.number("surface_s", timing.surface_s);
  object.number("search_s", timing.search_s);
  object.number("total_s", timing.total_s);
  object.close();
}

/// Counters as numbers, words as strings. Names may come more than once.
void append_statistics(const Report& report, Buffer& out) {
  out.append(std::string_view(",\n\"statistics\":["));
  bool first = true;
  for (const auto& [name, value] : report.statistics) {
    out.append(std::string_view(std::exchange(first, false) ? "\n  " : ",\n  "));
    Members object(out);
    object.string("name", name);
    const bool number = !value.empty() && value.size() <= 19 && (value[0] != '0' || value.size() == 1) &&
                        value.find_first_not_of("0123456789") == std::string::npos;
    if (number)
      object.raw("value", value);
    else
      object.string("value", value);
    object.close();
  }
  out.push_back(']');
}

/// `,"name":value`, or nothing.
std::string member_unless_zero(std::string_view name, std::size_t value) {
  return value > 0 ? fmt::format(",\"{}\":{}", name, value) : std::string();
}

/// The report's file names, quoted.
std::vector<std::string> quoted_files(const Report& report) {
  std::vector<std::string> files;
  files.reserve(report.files.size());
  for (const std::string& file : report.files) files.push_back(json_string(file));
  return files;
}

void append_findings(const Report& report, const std::vector<std::string>& files, Stream& stream) {
  const std::size_t nodes = report.penetrations.size(), ties = report.tie_failures.size();
  stream.lines(nodes, true, [&](std::size_t i, Buffer& out) {
    append_penetration(report, report.penetrations[i], files, state_of(report, i), out);
  });
  stream.lines(ties, nodes == 0, [&](std::size_t i, Buffer& out) {
    append_tie_failure(report, report.tie_failures[i], files, state_of(report, nodes + i), out);
  });
  const Causes causes(report);
  stream.lines(report.findings.size(), nodes + ties == 0, [&](std::size_t i, Buffer& out) {
    const Finding& finding = report.findings[i];
    append_finding(finding, causes.of(finding), state_of(report, nodes + ties + i), out);
  });
}

/// The finding with this number, counted over the three lists.
void append_ignored_finding(const Report& report, const std::vector<std::string>& files, std::size_t number,
                            Buffer& out) {
  const Ignored& ignored = report.ignored;
  std::optional<BaselineState> state;
  if (report.baseline && number < report.baseline->ignored_states.size())
    state = report.baseline->ignored_states[number];
  const std::size_t ties = ignored.penetrations.size(), others = ties + ignored.tie_failures.size();
  if (number < ties)
    append_penetration(report, ignored.penetrations[number], files, state, out);
  else if (number < others)
    append_tie_failure(report, ignored.tie_failures[number - ties], files, state, out);
  else
    append_finding(ignored.findings[number - others], nullptr, state, out);
}

/// What was left out on purpose, place by place.
void append_ignored_by_source(const Report& report, const std::vector<std::string>& files, Stream& stream) {
  const Ignored& ignored = report.ignored;
  std::vector<std::vector<std::size_t>> of_source(ignored.sources.size());
  for (std::size_t i = 0; i < ignored.source.size(); ++i) of_source[ignored.source[i]].push_back(i);
  stream.text("\"ignored\":[");
  for (std::size_t i = 0; i < ignored.sources.size(); ++i) {
    if (!stream.open()) return;
    const IgnoreSource& source = ignored.sources[i];
    stream.separator(i == 0);
    Members object(stream.buffer);
    object.string("file", source.file);
    if (source.line != 0) object.integer("line", source.line);
    object.plain("by", source.in_deck ? "comment" : "settings");
    if (!source.reason.empty()) object.string("reason", source.reason);
    object.integer("count", of_source[i].size());
    object.key("findings");
    stream.text("[");
    for (std::size_t k = 0; k < of_source[i].size(); ++k) {
      if (!stream.open()) return;
      stream.separator(k == 0);
      append_ignored_finding(report, files, of_source[i][k], stream.buffer);
    }
    stream.text("]");
    object.close();
  }
  stream.text("],\n");
}

/// Findings of the baseline that are gone.
void append_gone(const BaselineComparison& comparison, Stream& stream) {
  stream.text("\"gone\":[");
  bool first = true;
  for (const KnownFinding& finding : comparison.gone) {
    if (!stream.open()) return;
    stream.separator(std::exchange(first, false));
    append_known(finding, stream.buffer);
  }
  stream.text("],\n");
}

std::string counts_of(const BaselineCounts& counts) {
  return fmt::format(",\"baseline\":{{\"new\":{},\"worse\":{},\"unchanged\":{},\"gone\":{}}}", counts.fresh,
                     counts.worse, counts.unchanged, counts.gone);
}

}  // namespace

namespace {

void append_report(const Report& report, bool statistics, Stream& stream) {
  stream.text("{\"schema\":\"gapcheck/1\",\"source\":");
  stream.text(json_string(report.source));
  stream.text(",\"input\":");
  stream.text(json_string(report.input));
  if (!report.as_if.empty()) {
    stream.text(",\"as_if\":[");
    for (std::size_t i = 0; i < report.as_if.size(); ++i)
      stream.text((i > 0 ? "," : "") + json_string(report.as_if[i]));
    stream.text("]");
  }
  if (!report.settings.empty()) stream.text(",\"settings\":" + json_string(report.settings));
  if (report.run) {
    stream.text(",\n\"run\":");
    append_run(report, stream.buffer);
  } else {
    stream.text(",\n\"model\":");
    append_model(report.model, stream.buffer);
    append_predicted_limits(report, stream.buffer);
  }
  stream.text(",\n\"contacts\":[");
  bool first = true;
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) {
    stream.separator(std::exchange(first, false));
    append_contact(report, i, stream.buffer);
  }
  stream.text("],\n\"findings\":[");
  const std::vector<std::string> files = quoted_files(report);
  append_findings(report, files, stream);
  const Totals sum = totals(report);
  stream.text("],\n");
  if (report.baseline) append_gone(*report.baseline, stream);
  const std::size_t ignored = report.ignored.size();
  if (ignored > 0) append_ignored_by_source(report, files, stream);
  fmt::format_to(fmt::appender(stream.buffer), "\"summary\":{{\"errors\":{},\"warnings\":{},\"notes\":{}{}{}{}}},\n",
                 sum.errors, sum.warnings, sum.notes, member_unless_zero("consequences", consequences(report)),
                 member_unless_zero("ignored", ignored), report.baseline ? counts_of(counts(*report.baseline)) : "");
  stream.text("\"timing\":");
  append_timing(report.timing, stream.buffer);
  if (report.portability) append_portability(*report.portability, stream.buffer);
  if (statistics) append_statistics(report, stream.buffer);
  stream.text("}");
}

/// The rules of all decks, and what each has found.
void append_rules(const Reports& reports, Stream& stream) {
  const bool with_baseline = baseline_counts(reports).has_value();
  bool first = true;
  for (const RuleCount& rule : rule_counts(reports.all)) {
    stream.separator(std::exchange(first, false));
    Members object(stream.buffer);
    object.string("id", rule.id);
    object.string("rule", rule.rule);
    object.plain("severity", name(rule.severity));
    object.integer("decks", rule.decks);
    object.integer("findings", rule.findings);
    if (with_baseline) stream.text(counts_of(rule.baseline));
    object.close();
  }
}

/// The part after the decks: missing ones, and all findings together.
void append_sum(const Reports& reports, Stream& stream) {
  stream.text("],\n\"unread\":[");
  for (std::size_t i = 0; i < reports.unread.size(); ++i) {
    stream.separator(i == 0);
    stream.text(json_string(reports.unread[i].deck));
  }
  stream.text("],\n\"reasons\":[");
  for (std::size_t i = 0; i < reports.unread.size(); ++i) {
    stream.separator(i == 0);
    stream.text(json_string(reports.unread[i].reason));
  }
  stream.text("],\n\"rules\":[");
  append_rules(reports, stream);
  Totals sum;
  std::size_t ignored = 0, following = 0;
  for (const Report& report : reports.all) {
    sum += totals(report);
    following += consequences(report);
    ignored += report.ignored.size();
  }
  const auto known = baseline_counts(reports);
  fmt::format_to(fmt::appender(stream.buffer),
                 "],\n\"summary\":{{\"decks\":{},\"unread\":{},\"errors\":{},\"warnings\":{},\"notes\":{}{}{}{}}}}}",
                 reports.all.size(), reports.unread.size(), sum.errors, sum.warnings, sum.notes,
                 member_unless_zero("consequences", following), member_unless_zero("ignored", ignored),
                 known ? counts_of(*known) : "");
}

}  // namespace

void json(const Reports& reports, const Sink& sink, bool statistics) {
  Stream stream(sink);
  if (reports.several()) stream.text("{\"schema\":\"gapcheck/1\",\"source\":\"decks\",\"decks\":[");
  for (std::size_t i = 0; i < reports.all.size() && stream.open(); ++i) {
    if (reports.several()) stream.separator(i == 0);
    append_report(reports.all[i], statistics, stream);
  }
  if (reports.several()) append_sum(reports, stream);
  stream.text("\n");
  stream.flush();
}

std::string json(const Report& report) {
  constexpr std::size_t typical_finding = 800;
  std::string result;
  result.reserve((report.penetrations.size() + report.findings.size()) * typical_finding);
  json(report, [&result](std::string_view piece) {
    result += piece;
    return true;
  });
  return result;
}

}  // namespace gapcheck::report
