#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "audit/grouped.hpp"
#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/element_text.hpp"
#include "audit/shared_results.hpp"
#include "contact/crossing/crossings.hpp"

namespace gapcheck::audit::rule::crossed_elements {
namespace {

using contact::Crossing;
using contact::CrossingSegment;

std::string describe(const model::Model& model, const CrossingSegment& s) {
  return fmt::format("{} ({})", element_text(model.mesh, {s.kind, s.element}), part_text(model, s.part));
}

/// Of the element; of a segment without one, its smallest node.
std::int64_t id_of(const model::Model& model, const CrossingSegment& s) {
  if (s.element != no_position) return element_id(model.mesh, {s.kind, s.element});
  std::int64_t least = model.mesh.nodes.id[s.nodes[0].value];
  for (const NodeIndex n : s.nodes) least = std::min(least, model.mesh.nodes.id[n.value]);
  return least;
}

bool solid(model::ElementKind kind) {
  return kind == model::ElementKind::solid || kind == model::ElementKind::thick_shell;
}

Finding words(const RuleIdentity& rule, const Context& context, const Crossing& c, std::string message) {
  const model::Model& model = context.model();
  Finding f = finding_at(rule, context, model.contact(c.contact), std::move(message));
  place_at_element(f, context, {c.a.kind, c.a.element});
  // Solids have no thickness in contact: what they penetrate they also cross, and the contact can push them apart.
  if (solid(c.a.kind) && solid(c.b.kind)) f.severity = Severity::warning;
  f.element_part = part_id(model, c.a.part);
  f.part = part_id(model, c.b.part);
  f.point = 0.5 * (c.from + c.to);
  return f;
}

std::string pair_text(const model::Model& model, const Crossing& c) {
  const bool beam = c.a.kind == model::ElementKind::beam || c.b.kind == model::ElementKind::beam;
  const std::string both = fmt::format("{} and {}", describe(model, c.a), describe(model, c.b));
  const std::string advice = "separate the parts, or merge their nodes if they are joined";
  if (beam) return fmt::format("{} cross at {}; {}", both, point_text(c.from), advice);
  return fmt::format("{} cross along {:.4g}, from {} to {}; {}", both, c.length(), point_text(c.from), point_text(c.to),
                     advice);
}

std::string rest_text(const model::Model& model, const Crossing& c, std::uint64_t count) {
  const bool one = c.a.part == c.b.part;
  return fmt::format("{} more pairs of elements of {}{} cross", count, part_text(model, c.a.part),
                     one ? "" : " and " + part_text(model, c.b.part));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  contact::CrossingOptions options;
  options.mode = context.options().exact ? geometry::Mode::exact : geometry::Mode::filtered;
  options.search = context.options().brute_force ? contact::BoxSearch::brute_force : contact::BoxSearch::tree;
  // Of contacts that hold the same pair the one with the smallest id reports it, whatever their order.
  std::vector<ContactIndex> contacts = context.contacts();
  std::stable_sort(contacts.begin(), contacts.end(),
                   [&](ContactIndex a, ContactIndex b) { return model.contact(a).id < model.contact(b).id; });
  std::vector<Crossing> crossings = contact::find_crossings(model, contacts, context.results().surface_store(), options,
                                                            context.results().crossing_counters());
  std::vector<Found> found;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    Crossing& c = crossings[i];
    if (!context.part_chosen(c.a.part) && !context.part_chosen(c.b.part)) continue;
    std::int64_t a = id_of(model, c.a), b = id_of(model, c.b);
    if (std::tuple(c.b.kind, b) < std::tuple(c.a.kind, a)) std::swap(c.a, c.b), std::swap(a, b);
    found.push_back({part_pair(c.a.part, c.b.part), rough_weight(c.length()), i, {a, b}});
  }
  add_grouped(
      report, std::move(found),
      [&](const Found& f) { return words(rule, context, crossings[f.item], pair_text(model, crossings[f.item])); },
      [&](const Found& f, std::uint64_t count) {
        return words(rule, context, crossings[f.item], rest_text(model, crossings[f.item], count));
      },
      collect_segments(context, [&](const Found& f, const auto& add) {
        const auto& c = crossings[f.item];
        add(c.a.nodes);
        add(c.b.nodes);
      }));
}

}  // namespace

// Severity error: nodes start on the wrong side, and the contact holds them there.
const Rule definition{{"GC103", "crossed-elements", Severity::error,
                       "two elements of a contact pass through each other", Need::surfaces | Need::crossings,
                       "The parts stay caught in each other, since contact pushes to the side where a node already is"},
                      run};

}  // namespace gapcheck::audit::rule::crossed_elements
