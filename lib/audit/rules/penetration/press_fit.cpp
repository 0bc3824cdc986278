#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "audit/rules.hpp"
#include "audit/shared/records_of.hpp"
#include "audit/shared_results.hpp"
#include "contact/pair/record_pair.hpp"
#include "contact/stiffness/segment_spring.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::audit::rule::press_fit {
namespace {

/// What the springs of all overlapping nodes do together, at full stiffness.
struct Press {
  double force = 0, area = 0;
};

/// An overlapping node: what its spring is made of, and the part of the surface that faces the other side.
struct PressedNode {
  NodeIndex node;
  Vector into = Vector::Zero();  ///< normal of the segment that it lies in
  double depth = 0, area = 0;
  contact::PairStiffness stiffness;
  contact::NodeStiffness mean;
};

/// The springs of one side's nodes (contact rules, section 6.1).
class PressedSide {
 public:
  PressedSide(const model::Model& model, const model::Contact& contact, const contact::ContactSurfaces& surfaces,
              const contact::SegmentSprings& springs)
      : model_(model), contact_(contact), surfaces_(surfaces), springs_(springs) {}

  [[nodiscard]] Press press(std::span<const Penetration> overlaps, bool on_b) const {
    std::vector<PressedNode> nodes = nodes_of(overlaps, on_b);
    const contact::ContactSide& own = side(on_b);
    for (std::size_t s = 0; s < own.selection.segments.size(); ++s) add_segment(own.selection.segments, s, on_b, nodes);
    Press all;
    for (PressedNode& n : nodes) {
      contact::PairStiffness& k = n.stiffness;
      if (!(k.node > 0)) k.node = k.segment;
      if (!(k.segment > 0)) k.segment = k.node;
      k.node_weighted = n.mean.weight > 0 ? n.mean.value() : k.node;
      all.force += contact::spring_stiffness(model_.controls.penopt, k) * n.depth;
      all.area += n.area;
    }
    return all;
  }

 private:
  [[nodiscard]] const contact::ContactSide& side(bool b) const { return b ? surfaces_.b : surfaces_.a; }
  [[nodiscard]] double scale(bool b) const { return model_.controls.slsfac * (b ? contact_.sfm : contact_.sfs); }
  [[nodiscard]] Vector normal(const model::SegmentNodes& n) const {
    const std::vector<Vector>& x = model_.mesh.nodes.x;
    return (x[n[2].value] - x[n[0].value]).cross(x[n[3].value] - x[n[1].value]).normalized();
  }

  /// Ascending by node.
  [[nodiscard]] std::vector<PressedNode> nodes_of(std::span<const Penetration> overlaps, bool on_b) const {
    std::vector<PressedNode> nodes;
    for (const Penetration& p : overlaps) {
      const auto pair = find_pair(surfaces_, model_.mesh, p);
      if (!pair || pair->node_on_b != on_b) continue;
      const contact::Segments& reference = side(pair->segment_on_b).selection.segments;
      PressedNode node;
      node.node = side(on_b).nodes.node[pair->slot.value];
      node.into = normal(reference.nodes[pair->segment.value]);
      node.depth = p.depth;
      node.stiffness.segment = springs_(reference, pair->segment.value, scale(pair->segment_on_b)).stiffness;
      node.stiffness.thickness = 2 * side(on_b).nodes.half[pair->slot.value];
      nodes.push_back(node);
    }
    std::sort(nodes.begin(), nodes.end(), [](const PressedNode& a, const PressedNode& b) { return a.node < b.node; });
    return nodes;
  }

  void add_segment(const contact::Segments& own, std::size_t s, bool on_b, std::vector<PressedNode>& nodes) const {
    std::optional<contact::SegmentSpring> spring;
    for (std::size_t c = 0; c < contact::corner_count(own.nodes[s]); ++c) {
      const auto found = std::lower_bound(nodes.begin(), nodes.end(), own.nodes[s][c],
                                          [](const PressedNode& n, NodeIndex node) { return n.node < node; });
      if (found == nodes.end() || found->node != own.nodes[s][c]) continue;
      if (!spring) spring = springs_(own, s, scale(on_b));
      if (!(spring->weight > 0)) continue;
      double& least = found->stiffness.node;
      least = found->mean.weight > 0 ? std::min(least, spring->stiffness) : spring->stiffness;
      found->mean += {spring->weight, spring->weight * spring->stiffness};
      if (std::abs(normal(own.nodes[s]).dot(found->into)) > facing) found->area += spring->weight;
    }
  }

  static constexpr double facing = 0.5;  ///< cosine; faces round the corner of a brick are not pressed
  const model::Model& model_;
  const model::Contact& contact_;
  const contact::ContactSurfaces& surfaces_;
  const contact::SegmentSprings& springs_;
};

/// "grow with curve 7 from 0 to 1 at t = 0.001", "are scaled by 1 all the time (curve 7)".
std::string growth(const model::Model& model, std::int64_t id) {
  const auto curve = model.curves.find(id);
  if (curve == model.curves.end() || curve->second.points.empty())
    return fmt::format("are scaled by curve {}, which is not in the deck", id);
  const auto& points = curve->second.points;
  const auto smaller = [](const auto& a, const auto& b) { return a[1] < b[1]; };
  const auto least = std::min_element(points.begin(), points.end(), smaller);
  const auto full = std::max_element(points.begin(), points.end(), smaller);  // the first of them
  if ((*least)[1] == (*full)[1]) return fmt::format("are scaled by {:g} all the time (curve {})", (*full)[1], id);
  return fmt::format("grow with curve {} from {:g} to {:g} at t = {:g}", id, points.front()[1], (*full)[1],
                     (*full)[0] * curve->second.abscissa_time);
}

/// LCID1 scales the springs in dynamic relaxation, LCID2 in the run.
std::string curve_words(const model::Model& model, const model::Contact& contact) {
  const std::int64_t relaxation = contact.interference_curve_relaxation, run = contact.interference_curve;
  if (run == 0 && relaxation == 0) return "no curve (LCID1, LCID2) scales the springs, so they act in full at once";
  if (run == 0) return fmt::format("curve {} scales the springs in dynamic relaxation only", relaxation);
  if (relaxation == 0) return "the springs " + growth(model, run);
  return fmt::format("in dynamic relaxation the springs {}, in the run they {}", growth(model, relaxation),
                     growth(model, run));
}

Finding describe(const RuleIdentity& rule, Context& context, const contact::SegmentSprings& springs,
                 std::span<const Penetration> overlaps) {
  const model::Model& model = context.model();
  const Penetration& deepest = overlaps.front();
  const ContactIndex c{deepest.contact};
  std::string text =
      fmt::format("an intended overlap: {} node{} up to {:.6g} deep (node {}); {}", overlaps.size(),
                  overlaps.size() == 1 ? "" : "s", deepest.depth, deepest.node, curve_words(model, model.contact(c)));
  const PressedSide sides(model, model.contact(c), context.surfaces(c), springs);
  const Press of_a = sides.press(overlaps, false), of_b = sides.press(overlaps, true);
  const double force = of_a.force + of_b.force, area = std::max(of_a.area, of_b.area);
  if (force > 0 && area > 0)
    text += fmt::format("; until the parts give way, the springs press with up to {:.4g}, a mean pressure of {:.4g}",
                        force, force / area);
  Finding finding = finding_at(rule, context, model.contact(c), std::move(text));
  finding.node = deepest.node;
  finding.part = deepest.part;
  finding.element = deepest.element;
  finding.element_part = deepest.element_part;
  finding.penetration = deepest.depth;
  finding.count = overlaps.size();
  finding.point = deepest.original;
  return finding;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const std::vector<Penetration>& all = context.results().initial().overlaps;
  const model::Model& model = context.model();
  std::optional<contact::ElementSizes> sizes;
  std::optional<contact::SegmentSprings> springs;
  for (const ContactIndex c : context.contacts()) {
    if (!contact::classify(model.contact(c)).can(contact::Ability::interference)) continue;
    const std::span<const Penetration> overlaps = records_of(all, c);
    if (overlaps.empty()) {
      report.findings.push_back(finding_at(rule, context, model.contact(c),
                                           "no node overlaps, so there is nothing to press; check the geometry, or "
                                           "use the type without INTERFERENCE"));
      continue;
    }
    if (!sizes) springs.emplace(model, sizes.emplace(contact::element_sizes(model)));
    report.findings.push_back(describe(rule, context, *springs, overlaps));
  }
}

}  // namespace

const Rule definition{{"GC113", "press-fit", Severity::note,
                       "the intended overlap of an INTERFERENCE contact, and how hard it will press",
                       Need::surfaces | Need::intended_overlaps, "The contact presses, as it should: see how hard"},
                      run};

}  // namespace gapcheck::audit::rule::press_fit
