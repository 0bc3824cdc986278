#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/acting_contact.hpp"
#include "audit/shared/element_text.hpp"
#include "audit/shared_results.hpp"
#include "contact/crossing/enclosed_bodies.hpp"

namespace gapcheck::audit::rule::enclosed_solid {
namespace {

using contact::EnclosedBody;

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  contact::CrossingOptions options;
  options.mode = context.options().exact ? geometry::Mode::exact : geometry::Mode::filtered;
  options.search = context.options().brute_force ? contact::BoxSearch::brute_force : contact::BoxSearch::tree;
  ActingContact acting(
      model, context.contacts(), [&](ContactIndex c) -> auto& { return context.surfaces(c); });
  const std::vector<EnclosedBody> bodies = contact::find_enclosed_bodies(
      model, [&](PartIndex p, PartIndex q) { return acting(p, q); }, options, context.results().crossing_counters());
  std::vector<Found> found;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (context.part_chosen(bodies[i].inner) || context.part_chosen(bodies[i].outer))
      found.push_back({part_pair(bodies[i].inner, bodies[i].outer), static_cast<double>(bodies[i].solids), i});
  const auto words = [&](const Found& f, std::string message) {
    const EnclosedBody& body = bodies[f.item];
    Finding out = finding_at(rule, context, model.contact(body.contact), std::move(message));
    place_at_element(out, context, {model::ElementKind::solid, body.first_solid});
    out.element_part = part_id(model, body.inner);
    out.part = part_id(model, body.outer);
    out.point = body.point;
    return out;
  };
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const EnclosedBody& body = bodies[f.item];
        const bool one = body.solids == 1;
        return words(f, fmt::format("{} solid{} of {} (from solid {} on) lie{} wholly inside {}; cut the space out of "
                                    "{}, or exclude the pair from the contact",
                                    body.solids, one ? "" : "s", part_text(model, body.inner),
                                    model.mesh.solids.id[body.first_solid], one ? "s" : "",
                                    part_text(model, body.outer), part_text(model, body.outer)));
      },
      [&](const Found& f, std::uint64_t count) {
        const EnclosedBody& body = bodies[f.item];
        return words(f, fmt::format("{} more bod{} of {} inside {}", count, count == 1 ? "y" : "ies",
                                    part_text(model, body.inner), part_text(model, body.outer)));
      });
}

}  // namespace

const Rule definition{
    {"GC105", "enclosed-solid", Severity::warning,
     "a body of solids lies wholly inside another that it is in contact with", Need::surfaces | Need::crossings,
     "The inner body is never pushed out: contact sees it from inside"},
    run};

}  // namespace gapcheck::audit::rule::enclosed_solid
