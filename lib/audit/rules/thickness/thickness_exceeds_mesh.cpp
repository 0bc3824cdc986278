#include <fmt/format.h>

#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"
#include "records/thickness_source.hpp"

namespace gapcheck::audit::rule::thickness_exceeds_mesh {
namespace {

/// Contact thickness in shortest edges above which neighbours meet themselves.
constexpr double most_edges = 1;

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  std::vector<PartSegments> parts;
  for (const ContactIndex c : contacts_with_thickness(rule, context)) {
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    if (surfaces.two_sided()) continue;  // a surface does not meet itself there
    const contact::Segments& s = surfaces.a.selection.segments;
    const bool limited = surfaces.settings.thickness_limit;
    weigh_by_part(parts, context, c, s, [&](std::size_t i) {
      if (s.kind[i] != contact::SegmentKind::shell) return 0.0;
      if (limited && (s.rule[i] == ThicknessRule::element || s.rule[i] == ThicknessRule::edge_limit)) return 0.0;
      const double edges = 2 * s.half[i] / contact::shortest_edge(s.nodes[i], model.mesh.nodes.x);
      return edges > most_edges ? edges : 0.0;
    });
  }
  const auto words = [&](const PartSegments& p) {
    const contact::Segments& s = *p.segments;
    const std::uint32_t worst = p.worst.item;
    return fmt::format(
        "{}: the contact thickness of {} is larger than their shortest edge, most at {}: {:.4g} ({}) and an edge of "
        "{:.4g}; T-joints and fillets penetrate themselves: lower it or coarsen the mesh",
        part_name(model, p.part()), count_elements(p.worst.count), element_name(model.mesh, s, worst),
        2 * s.half[worst], thickness_source(s.rule[worst]), contact::shortest_edge(s.nodes[worst], model.mesh.nodes.x));
  };
  add_by_part(rule, context, report, parts, words, "parts that are thicker than their mesh is wide");
}

}  // namespace

const Rule definition{{"GC304", "thickness-exceeds-mesh", Severity::warning,
                       "a single-surface contact is thicker than the elements are wide", Need::surfaces},
                      run};

}  // namespace gapcheck::audit::rule::thickness_exceeds_mesh
