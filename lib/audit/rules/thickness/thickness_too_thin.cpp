#include <fmt/format.h>

#include <array>

#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"
#include "audit/shared/length_unit.hpp"
#include "records/thickness_source.hpp"

namespace gapcheck::audit::rule::thickness_too_thin {
namespace {

/// Where the unit of length is not known: share of the shortest edge. A time step is about edge / c, so a node at speed
/// v moves v / c edges in it; 0.003 is 15 m/s in steel, a car that hits a wall.
constexpr std::array thresholds{
    Threshold{"millimetres", recommended_millimetres, 0, 1e6,
              "contact thickness below which it is listed, where the unit is known"},
    Threshold{"edges", 0.003, 0, 1e6, "the same in shortest edges of a segment, where the unit is not known"}};

/// Required thickness over the shell segment's thickness; 0: thick enough, or not a shell.
double thinness(const Context& context, double least_millimetres, double least_share_of_edge, double millimetre,
                const contact::ContactSettings& settings, const contact::Segments& s, std::size_t i) {
  const model::Model& model = context.model();
  if (s.kind[i] != contact::SegmentKind::shell || s.element[i] == none<PartIndex>.value) return 0;
  const double t = 2 * s.half[i];
  const double least = millimetre > 0 ? least_millimetres * millimetre
                                      : least_share_of_edge * contact::shortest_edge(s.nodes[i], model.mesh.nodes.x);
  if (!(t < least) || s.rule[i] == ThicknessRule::edge_limit) return 0;
  const PartIndex part = part_of(model.mesh, s, i);
  if (part == none<PartIndex> || !model.part(part).section) return 0;
  // Rigid tools intentionally have no contact thickness, and rigid elements do not set the time step.
  if (model.rigid(part) && (settings.shlthk == 1 || millimetre <= 0)) return 0;
  return least / t;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const LengthUnit unit = length_unit(context);
  const double least_millimetres = context.threshold(rule, thresholds[0]),
               least_share_of_edge = context.threshold(rule, thresholds[1]);
  std::vector<PartSegments> parts;
  for (const ContactIndex c : contacts_with_thickness(rule, context)) {
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    if (surfaces.settings.shlthk == 0) continue;  // GC305
    for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) {
      const contact::Segments& s = side->selection.segments;
      weigh_by_part(parts, context, c, s, [&](std::size_t i) {
        return thinness(context, least_millimetres, least_share_of_edge, unit.millimetre, surfaces.settings, s, i);
      });
    }
  }
  const auto words = [&](const PartSegments& p) {
    const contact::Segments& s = *p.segments;
    const std::uint32_t worst = p.worst.item;
    const std::string limit = unit.known() ? fmt::format("{:.4g} ({} mm{})", least_millimetres * unit.millimetre,
                                                         least_millimetres, unit.clause())
                                           : fmt::format("{} of their shortest edge", least_share_of_edge);
    return fmt::format(
        "{}: the contact thickness of {} is below {}, the thinnest is {} with {:.4g} ({}): nodes may pass through; "
        "raise it "
        "with OPTT of *PART_CONTACT or SST",
        part_name(model, p.part()), count_elements(p.worst.count), limit, element_name(model.mesh, s, worst),
        2 * s.half[worst], thickness_source(s.rule[worst]));
  };
  const std::size_t before = report.findings.size();
  add_by_part(rule, context, report, parts, words, "parts with too thin elements");
  if (unit.assumption.empty()) return;
  for (std::size_t i = before; i < report.findings.size(); ++i) report.findings[i].severity = Severity::note;
}

}  // namespace

const Rule definition{.identity = {"GC303", "thickness-too-thin", Severity::warning,
                                   "a contact thickness is so small that nodes may pass through", Need::surfaces,
                                   "Nodes pass through the thin contact zone within a few steps"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::thickness_too_thin
