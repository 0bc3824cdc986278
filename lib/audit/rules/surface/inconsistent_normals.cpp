#include <fmt/format.h>

#include <map>
#include <utility>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::inconsistent_normals {
namespace {

/// Types that see one side of a segment: old and forming ones, and tiebreaks, whose orientation distinguishes tension
/// from compression.
bool oriented(const model::Contact& contact, const contact::ContactType& type) {
  if (type.treatment == contact::Treatment::none) return false;
  if (type.family == contact::Family::old || type.family == contact::Family::forming) return true;
  return contact.kind->breaks();
}

struct Turned {
  std::uint64_t count = 0;
  SegmentIndex first;
  FindingMembers members;
};

void check_side(const RuleIdentity& rule, Context& context, Report& report, ContactIndex contact, char letter,
                const contact::Segments& segments) {
  const model::Model& model = context.model();
  std::map<PartIndex, Turned> by_part;
  for (const contact::Misoriented& m : contact::misoriented_segments(model.mesh, segments)) {
    if (!context.part_chosen(m.part)) continue;
    Turned& turned = by_part[m.part];
    if (turned.count++ == 0) turned.first = m.segment;
    if (context.options().members) add_segment(model.mesh.nodes, segments.nodes[m.segment.value], turned.members);
  }
  for (auto& [part, turned] : by_part) {
    const std::int64_t part_id = part == none<PartIndex> ? 0 : model.part(part).id.value;
    const std::int64_t element = contact::element_id(model.mesh, segments, turned.first.value);
    std::string at =
        element != 0 ? fmt::format("element {}", element) : fmt::format("segment {}", turned.first.value + 1);
    Finding f = finding_at(
        rule, context, model.contact(contact),
        fmt::format("side {}{}: {} segment{} against {} neighbours (first: {}), and this type sees one side only; turn "
                    "the normals, or take an AUTOMATIC type",
                    letter, part_id != 0 ? fmt::format(", part {}", part_id) : "", turned.count,
                    turned.count == 1 ? " is oriented" : "s are oriented", turned.count == 1 ? "its" : "their", at));
    f.part = f.element_part = part_id;
    f.element = element;
    f.count = turned.count;
    f.members = std::move(turned.members);
    const auto& nodes = segments.nodes[turned.first.value];
    f.point = (model.mesh.nodes.x[nodes[0].value] + model.mesh.nodes.x[nodes[2].value]) / 2;
    report.findings.push_back(std::move(f));
  }
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (!contact.known || contact.own_layout) continue;
    const contact::ContactType type = contact::classify(contact);
    if (!oriented(contact, type)) continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    if (type.treatment != contact::Treatment::one_way)
      check_side(rule, context, report, i, 'A', surfaces.a.selection.segments);
    if (surfaces.two_sided()) check_side(rule, context, report, i, 'B', surfaces.b.selection.segments);
  }
}

}  // namespace

const Rule definition{{"GC416", "inconsistent-normals", Severity::warning,
                       "neighbouring segments of an oriented contact face opposite ways", Need::surfaces,
                       "The contact pushes to the wrong side where segments face the other way"},
                      run};

}  // namespace gapcheck::audit::rule::inconsistent_normals
