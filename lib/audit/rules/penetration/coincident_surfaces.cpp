#include <fmt/format.h>

#include <set>

#include "audit/grouped.hpp"
#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/element_text.hpp"
#include "contact/surface/coincident.hpp"

namespace gapcheck::audit::rule::coincident_surfaces {
namespace {

using contact::Coincidence;

bool null_material(const model::Model& model, PartIndex part) {
  if (part == none<PartIndex>) return false;
  const auto& material = model.part(part).material;
  return material && model.materials[*material].null_material;
}

void check_shells(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const model::Shells& shells = model.mesh.shells;
  const std::vector<Coincidence> pairs = contact::coincident_segments(shells.nodes, model.mesh.nodes.size());
  std::vector<Found> found;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PartIndex a = shells.part[pairs[i].first], b = shells.part[pairs[i].again];
    // Null shells are laid on others on purpose.
    if (null_material(model, a) || null_material(model, b)) continue;
    if (context.part_chosen(a) || context.part_chosen(b)) found.push_back({part_pair(a, b), 0, i});
  }
  const auto words = [&](const Found& f, std::string message) {
    const Coincidence& pair = pairs[f.item];
    Finding out = finding(rule, std::move(message), {}, 0);
    place_at_element(out, context, {model::ElementKind::shell, pair.again});
    out.element_part = part_id(model, shells.part[pair.again]);
    out.part = part_id(model, shells.part[pair.first]);
    return out;
  };
  const auto part = [&](std::uint32_t shell) { return part_text(model, shells.part[shell]); };
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const Coincidence& pair = pairs[f.item];
        return words(f, fmt::format("shell {} ({}) has the same nodes as shell {} ({}): its mass and stiffness "
                                    "count twice; remove one of them, or give it *MAT_NULL if it is a coat",
                                    shells.id[pair.again], part(pair.again), shells.id[pair.first], part(pair.first)));
      },
      [&](const Found& f, std::uint64_t count) {
        const Coincidence& pair = pairs[f.item];
        return words(f, fmt::format("{} more shell{} of {} on the nodes of shells of {}", count, count == 1 ? "" : "s",
                                    part(pair.again), part(pair.first)));
      },
      collect_segments(context, [&](const Found& f, const auto& add) { add(shells.nodes[pairs[f.item].again]); }));
}

/// Segment sets that name a segment twice.
void check_sets(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  std::set<std::int64_t> seen;
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = model.contact(i);
    for (const model::SurfaceInput* side : {&contact.a, &contact.b}) {
      if (!side->given || side->type != static_cast<std::int64_t>(model::SurfaceType::segment_set)) continue;
      const auto set = model.sets.segments.find(side->id);
      if (set == model.sets.segments.end() || !seen.insert(side->id).second) continue;
      const auto pairs = contact::coincident_segments(set->second.members, model.mesh.nodes.size());
      if (pairs.empty()) continue;
      Finding f = finding_at(rule, context, contact,
                             fmt::format("segment set {} names {} segment{} more than once (the first with node {}); "
                                         "remove them, each counts once",
                                         side->id, pairs.size(), pairs.size() == 1 ? "" : "s",
                                         model.mesh.nodes.id[set->second.members[pairs[0].again][0].value]));
      f.count = pairs.size();
      if (context.options().members)
        for (const Coincidence& pair : pairs) add_segment(model.mesh.nodes, set->second.members[pair.again], f.members);
      report.findings.push_back(std::move(f));
    }
  }
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  check_shells(rule, context, report);
  check_sets(rule, context, report);
}

}  // namespace

const Rule definition{{"GC111", "coincident-surfaces", Severity::warning, "two shells or segments have the same nodes",
                       Need::model, "Mass and stiffness count twice where shells lie on each other"},
                      run};

}  // namespace gapcheck::audit::rule::coincident_surfaces
