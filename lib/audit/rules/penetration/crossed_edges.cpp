#include "contact/crossing/crossed_edges.hpp"

#include <fmt/format.h>

#include <set>

#include "audit/grouped.hpp"
#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/element_text.hpp"
#include "audit/shared_results.hpp"

namespace gapcheck::audit::rule::crossed_edges {
namespace {

using contact::EdgeCrossing;

std::vector<std::pair<ContactIndex, EdgeCrossing>> all_crossed_edges(Context& context) {
  const model::Model& model = context.model();
  contact::CrossingOptions options;
  options.mode = context.options().exact ? geometry::Mode::exact : geometry::Mode::filtered;
  options.search = context.options().brute_force ? contact::BoxSearch::brute_force : contact::BoxSearch::tree;
  std::vector<std::pair<ContactIndex, EdgeCrossing>> all;
  std::set<std::array<NodeIndex, 4>> seen;
  for (const ContactIndex i : context.contacts()) {
    if (!contact::looks_at_edges(model.contact(i), contact::classify(model.contact(i)))) continue;
    for (const EdgeCrossing& c :
         contact::find_crossed_edges(model, i, context.surfaces(i), options, context.results().crossing_counters())) {
      auto e = std::minmax({c.edge_a[0], c.edge_a[1]}), f = std::minmax({c.edge_b[0], c.edge_b[1]});
      if (f < e) std::swap(e, f);
      if (seen.insert({e.first, e.second, f.first, f.second}).second) all.emplace_back(i, c);
    }
  }
  return all;
}

std::string describe(const model::Model& model, const contact::CrossingSegment& s,
                     const std::array<NodeIndex, 2>& edge) {
  const auto& id = model.mesh.nodes.id;
  std::string element = fmt::format("{} ({})", element_text(model.mesh, {s.kind, s.element}), part_text(model, s.part));
  if (s.kind == model::ElementKind::beam) return element;
  return fmt::format("the edge {}-{} of {}", id[edge[0].value], id[edge[1].value], element);
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const auto crossings = all_crossed_edges(context);
  std::vector<Found> found;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const EdgeCrossing& c = crossings[i].second;
    if (context.part_chosen(c.a.part) || context.part_chosen(c.b.part))
      found.push_back({part_pair(c.a.part, c.b.part), 0, i});
  }
  const auto words = [&](const Found& f, std::string message) {
    const auto& [contact, c] = crossings[f.item];
    Finding out = finding_at(rule, context, model.contact(contact), std::move(message));
    place_at_element(out, context, {c.a.kind, c.a.element});
    out.element_part = part_id(model, c.a.part);
    out.part = part_id(model, c.b.part);
    out.point = c.point;
    return out;
  };
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const EdgeCrossing& c = crossings[f.item].second;
        return words(f,
                     fmt::format("{} and {} cross at {}; move one of them, or give them a common node",
                                 describe(model, c.a, c.edge_a), describe(model, c.b, c.edge_b), point_text(c.point)));
      },
      [&](const Found& f, std::uint64_t count) {
        const EdgeCrossing& c = crossings[f.item].second;
        return words(f, fmt::format("{} more pair{} of edges of {}{} cross", count, count == 1 ? "" : "s",
                                    part_text(model, c.a.part),
                                    c.a.part == c.b.part ? "" : " and " + part_text(model, c.b.part)));
      },
      collect_segments(context, [&](const Found& f, const auto& add) {
        const auto& c = crossings[f.item].second;
        add(c.a.nodes);
        add(c.b.nodes);
      }));
}

}  // namespace

const Rule definition{{"GC104", "crossed-edges", Severity::warning,
                       "two edges or beams cross each other in a contact that looks at edges",
                       Need::surfaces | Need::crossings, "The edges stay hooked, or are forced apart at once"},
                      run};

}  // namespace gapcheck::audit::rule::crossed_edges
