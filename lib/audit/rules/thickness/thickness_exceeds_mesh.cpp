#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"
#include "records/thickness_source.hpp"

namespace gapcheck::audit::rule::thickness_exceeds_mesh {
namespace {

// Neighbours meet themselves from one edge on.
constexpr std::array thresholds{
    Threshold{"edges", 1, 0, 1e6, "contact thickness in shortest edges of a segment, above which it is listed"}};
/// In longest edges: no contact is meant to be that thick. It is in another unit, or has a digit too many.
constexpr double absurd_edges = 50;

double longest_edge(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    longest = std::max(longest, (x[n[(i + 1) % 4].value] - x[n[i].value]).squaredNorm());
  return std::sqrt(longest);
}

bool absurd(const contact::Segments& s, std::size_t i, const std::vector<Vector>& x) {
  const double longest = longest_edge(s.nodes[i], x);
  return longest > 0 && 2 * s.half[i] > absurd_edges * longest;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const std::vector<Vector>& x = model.mesh.nodes.x;
  const double most_edges = context.threshold(rule, thresholds[0]);
  std::vector<PartSegments> parts;
  for (const ContactIndex c : contacts_with_thickness(rule, context)) {
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    const bool limited = surfaces.settings.thickness_limit;
    for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) {
      const contact::Segments& s = side->selection.segments;
      weigh_by_part(parts, context, c, s, [&](std::size_t i) {
        if (s.kind[i] != contact::SegmentKind::shell) return 0.0;
        if (limited && (s.rule[i] == ThicknessRule::element || s.rule[i] == ThicknessRule::edge_limit)) return 0.0;
        // Two surfaces do not meet themselves.
        if (surfaces.two_sided() && !absurd(s, i, x)) return 0.0;
        const double edges = 2 * s.half[i] / contact::shortest_edge(s.nodes[i], x);
        return edges > most_edges ? edges : 0.0;
      });
    }
  }
  const auto words = [&](const PartSegments& p, const char* consequence) {
    const contact::Segments& s = *p.segments;
    const std::uint32_t worst = p.worst.item;
    return fmt::format(
        "{}: the contact thickness of {} is larger than their shortest edge, most at {}: {:.4g} ({}) and an edge of "
        "{:.4g}; {}",
        part_name(model, p.part()), count_elements(p.worst.count), element_name(model.mesh, s, worst),
        2 * s.half[worst], thickness_source(s.rule[worst]), contact::shortest_edge(s.nodes[worst], x), consequence);
  };
  const auto sane = std::stable_partition(parts.begin(), parts.end(),
                                          [&](const PartSegments& p) { return absurd(*p.segments, p.worst.item, x); });
  const std::size_t before = report.findings.size();
  add_by_part(
      rule, context, report, {parts.begin(), sane},
      [&](const PartSegments& p) {
        return words(p, "everything near them penetrates: correct the thickness or its unit");
      },
      "parts that are many times thicker than their mesh is wide");
  for (std::size_t i = before; i < report.findings.size(); ++i) report.findings[i].severity = Severity::error;
  add_by_part(
      rule, context, report, {sane, parts.end()},
      [&](const PartSegments& p) {
        return words(p, "T-joints and fillets penetrate themselves: lower it or coarsen the mesh");
      },
      "parts that are thicker than their mesh is wide");
}

}  // namespace

const Rule definition{.identity = {"GC304", "thickness-exceeds-mesh", Severity::warning,
                                   "a contact is thicker than the elements are wide", Need::surfaces,
                                   "Neighbouring nodes touch each other's segments: forces from nothing"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::thickness_exceeds_mesh
