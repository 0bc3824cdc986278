#include "report/html/html_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "report/baseline/baseline.hpp"
#include "report/html/html_json.hpp"
#include "report/html/html_picture.hpp"
#include "report/item/describe.hpp"
#include "report/item/sums.hpp"
#include "report/write/json_members.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t most_pairs = 500, depth_bins = 24, ratio_bins = 20;

/// Texts that occur more than once, by their positions.
class Texts {
 public:
  std::size_t position(std::string_view text) {
    const auto [entry, is_new] = positions_.try_emplace(std::string(text), positions_.size());
    if (is_new) list_.push_back(entry->first);
    return entry->second;
  }
  [[nodiscard]] std::string json() const {
    std::string out = "[";
    for (const std::string& text : list_) out += (out.size() > 1 ? "," : "") + json_string(text);
    return out + "]";
  }

 private:
  std::map<std::string, std::size_t> positions_;
  std::vector<std::string> list_;
};

void add_head(const Report& report, const HtmlOptions& options, std::size_t shown, Members& data) {
  const Totals total = totals(report);
  data.string("version", options.version);
  data.string("source", report.source);
  data.string("input", report.as_if.empty() ? report.input
                                            : fmt::format("{} as if {}", report.input, fmt::join(report.as_if, ", ")));
  data.object("totals", [&](Members& object) {
    object.integer("errors", total.errors);
    object.integer("warnings", total.warnings);
    object.integer("notes", total.notes);
  });
  data.integer("shown", shown);
  data.integer("found", report.penetrations.size() + report.tie_failures.size() + report.findings.size() +
                            report.ignored.size());
  data.integer("ignored", report.ignored.size());
  data.string("moves", report.said_of_moves);
  data.string("baseline", report.baseline ? summary(*report.baseline) : "");
  const ModelCounts& m = report.model;
  data.object("model", [&](Members& object) {
    object.integer("nodes", m.nodes);
    object.integer("shells", m.shells);
    object.integer("solids", m.solids);
    object.integer("thick shells", m.thick_shells);
    object.integer("beams", m.beams);
    object.integer("discrete elements", m.discrete);
    object.integer("mass elements", m.masses);
    object.integer("particles", m.particles);
    object.integer("parts", m.parts);
    object.integer("contacts", m.contacts);
  });
  if (report.run) {
    using enum SolverRun::Termination;
    data.string("solver", report.run->version);
    data.string("run title", report.run->title);
    data.string("termination", report.run->termination == normal  ? "normal termination"
                               : report.run->termination == error ? "error termination"
                                                                  : "");
  }
}

std::string contact_summary_json(const ContactSummary& contact) {
  Buffer out;
  Members object(out);
  object.raw("id", id_text(contact.id));
  object.integer("order", contact.order);
  object.string("title", contact.title);
  object.string("keyword", contact.keyword);
  object.string("type", contact.type);
  object.integer("tracked_nodes", contact.tracked_nodes);
  object.integer("segments", contact.segments);
  object.integer("penetrations", contact.penetrations + contact.segment_penetrations + contact.mortar_penetrations +
                                     contact.edge_penetrations);
  object.integer("released", contact.released);
  object.integer("edge_zone", contact.edge_zone);
  object.number("max_penetration", contact.max_penetration);
  object.integer("ties", contact.ties);
  object.integer("untied", contact.untied);
  object.string("not_checked", contact.not_checked);
  if (contact.ties_judged) object.raw("tied", "true");
  object.string("file", contact.file);
  object.integer("line", contact.line);
  object.close();
  return fmt::to_string(out);
}

/// Findings column by column.
std::string findings_json(const std::vector<HtmlFinding>& findings, Texts& texts) {
  Buffer out;
  Members object(out);
  const auto text = [&](std::string_view name, auto of) {
    object.raw(name, json_array(findings,
                                [&](const HtmlFinding& f) { return fmt::format("{}", texts.position(of(f.item))); }));
  };
  const auto id = [&](std::string_view name, std::int64_t Item::*member) {
    object.raw(name, json_array(findings, [&](const HtmlFinding& f) { return id_text(f.item.*member); }));
  };
  const auto number = [&](std::string_view name, double Item::*member) {
    object.raw(name, json_array(findings, [&](const HtmlFinding& f) {
                 const double value = f.item.*member;
                 return value >= 0 && std::isfinite(value) ? fmt::format("{}", value) : std::string("null");
               }));
  };
  object.raw("number", json_array(findings, [](const HtmlFinding& f) { return fmt::format("{}", f.number); }));
  text("id", [](const Item& item) { return item.id; });
  text("rule", [](const Item& item) { return item.rule; });
  object.raw("severity", json_array(findings, [](const HtmlFinding& f) {
               return fmt::format("{}", static_cast<int>(f.item.severity));
             }));
  id("contact", &Item::contact);
  id("node", &Item::node);
  id("part", &Item::part);
  id("element", &Item::element);
  id("element_part", &Item::element_part);
  number("penetration", &Item::penetration);
  number("contact_distance", &Item::contact_distance);
  text("outcome", [](const Item& item) { return item.outcome; });
  text("file", [](const Item& item) { return item.file; });
  object.raw("line", json_array(findings, [](const HtmlFinding& f) { return fmt::format("{}", f.item.line); }));
  object.raw("count", json_array(findings, [](const HtmlFinding& f) { return fmt::format("{}", f.item.count); }));
  text("state", [](const Item& item) {
    return item.ignored != nullptr ? std::string_view("ignored") : item.state ? name(*item.state) : std::string_view();
  });
  object.raw("ignored_by", json_array(findings, [&](const HtmlFinding& f) {
               return fmt::format("{}", texts.position(f.item.ignored != nullptr ? describe(*f.item.ignored) : ""));
             }));
  text("message", [](const Item& item) { return std::string_view(item.message); });
  object.raw("segment", json_array(findings, [](const HtmlFinding& f) { return json_array(f.segment, id_text); }));
  object.close();
  return fmt::to_string(out);
}

std::string pairs_json(const Report& report) {
  const Sums all = sums(report.penetrations);
  std::vector<PartPair> pairs = all.pairs;
  pairs.insert(pairs.end(), all.edge_pairs.begin(), all.edge_pairs.end());
  const std::size_t count = std::min(pairs.size(), most_pairs);
  std::partial_sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count), pairs.end(),
                    [](const PartPair& a, const PartPair& b) { return a.deepest->depth > b.deepest->depth; });
  const std::size_t more = pairs.size() - count;
  pairs.resize(count);
  Buffer out;
  Members object(out);
  object.integer("more", more);
  object.raw("list", json_array(pairs, [](const PartPair& pair) {
               const double depth = pair.deepest->depth;
               return fmt::format("[{},{},{},{}]", id_text(pair.part), id_text(pair.element_part), pair.nodes,
                                  std::isfinite(depth) ? depth : 0);
             }));
  object.close();
  return fmt::to_string(out);
}

/// Number of records by depth, and by depth over contact distance; nodes of the edge zone do not count.
std::string depths_json(const Report& report) {
  double deepest = 0;
  std::vector<std::uint64_t> depths(depth_bins), ratios(ratio_bins + 1);
  const auto counts = [](const Penetration& record) {
    return record.kind != PenetrationKind::edge_zone && record.depth > 0 && std::isfinite(record.depth);
  };
  for (const Penetration& record : report.penetrations)
    if (counts(record)) deepest = std::max(deepest, record.depth);
  for (const Penetration& record : report.penetrations) {
    if (!counts(record)) continue;
    ++depths[std::min(static_cast<std::size_t>(record.depth / deepest * depth_bins), depth_bins - 1)];
    const double ratio = record.depth / record.contact_distance;
    if (record.contact_distance > 0)
      ++ratios[ratio > 1 ? ratio_bins : std::min(static_cast<std::size_t>(ratio * ratio_bins), ratio_bins - 1)];
  }
  Buffer out;
  Members object(out);
  object.number("deepest", deepest);
  object.array("depths", depths);
  object.array("ratios", ratios);
  object.close();
  return fmt::to_string(out);
}

/// Positions of nodes from the caller, otherwise from the scene.
NodePosition with_scene(const Report& report, const NodePosition& position) {
  return [&report, &position](std::int64_t node) -> std::optional<Vector> {
    if (position)
      if (auto known = position(node)) return known;
    if (!report.scene) return std::nullopt;
    const auto& nodes = report.scene->nodes;
    const auto found = std::lower_bound(nodes.begin(), nodes.end(), node,
                                        [](const auto& entry, std::int64_t id) { return entry.first < id; });
    return found != nodes.end() && found->first == node ? std::optional(found->second) : std::nullopt;
  };
}

/// '<' begins nothing in JSON outside of texts.
std::string without_less_than(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

}  // namespace

std::string html_data(const Report& report, const NodePosition& position, const HtmlOptions& options) {
  const std::vector<HtmlFinding> findings = html_findings(report, with_scene(report, position), options);
  const std::span contacts(report.contacts.data(), std::min(report.contacts.size(), options.contacts));
  Texts texts;
  Buffer out;
  Members data(out);
  add_head(report, options, findings.size(), data);
  data.raw("contacts", json_array(contacts, contact_summary_json));
  data.integer("contacts_in_all", report.contacts.size());
  data.raw("findings", findings_json(findings, texts));
  data.raw("texts", texts.json());
  data.raw("pairs", pairs_json(report));
  data.raw("histogram", depths_json(report));
  data.raw("picture", picture_json(report, findings));
  data.close();
  return without_less_than({out.data(), out.size()});
}

}  // namespace gapcheck::report
