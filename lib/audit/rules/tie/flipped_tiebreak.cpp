#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"
#include "base/quad.hpp"
#include "contact/pair/orientation.hpp"
#include "contact/surface/neighbours.hpp"
#include "contact/surface/surface_parts.hpp"
#include "geometry/closest_point.hpp"

namespace gapcheck::audit::rule::flipped_tiebreak {
namespace {

using contact::JudgedNode;
using contact::Segments;

/// A node counts as touching within this share of the segment's shorter diagonal: mesh generators round.
constexpr double touching = 1e-4;
/// A tracked face lies against a segment if the cosine of their normals is larger than this: a corner of a body has
/// faces that look along the segment too.
constexpr double facing = 0.5;

/// Types 8 and 9 with oriented surfaces.
bool oriented(const model::Contact& contact) {
  return contact.kind != nullptr && contact.kind->breaks() && !contact::sides_are_remembered(contact) &&
         contact.kind->treatment != model::Treatment::single_surface;
}

/// Faces of solids look outward whatever the order of their nodes.
bool may_face_away(const Segments& s, SegmentIndex i) { return s.element_kind[i.value] == model::ElementKind::shell; }

enum class Side : std::uint8_t { front, behind, unknown };

/// Where the tied nodes of one contact lie.
class Sides {
 public:
  Sides(const model::Mesh& mesh, const contact::ContactSurfaces& surfaces)
      : mesh_(mesh), tracked_(surfaces.a.selection.segments), reference_(surfaces.b.selection.segments) {}

  [[nodiscard]] Side of(const JudgedNode& node) {
    const std::vector<Vector>& x = mesh_.nodes.x;
    const model::SegmentNodes& n = reference_.nodes[node.segment.value];
    const geometry::Facet facet{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
    const geometry::ClosestPoint closest = geometry::closest_point(facet, x[node.node.value]);
    if (std::abs(closest.gap) > touching * node.diagonal) return closest.gap > 0 ? Side::front : Side::behind;
    return of_body(node.node, closest.normal);
  }

 private:
  /// A body of solids that touches the segment lies on the side from which its face there looks at it.
  [[nodiscard]] Side of_body(NodeIndex node, const Vector& normal) {
    if (!neighbours_) neighbours_.emplace(tracked_, mesh_);
    double most = 0;
    for (const SegmentIndex i : neighbours_->at(node)) {
      if (tracked_.element_kind[i.value] == model::ElementKind::shell) continue;
      const double cosine = quad_normal(tracked_.nodes[i.value], mesh_.nodes.x).normalized().dot(normal);
      if (std::abs(cosine) > std::abs(most)) most = cosine;
    }
    if (!(std::abs(most) > facing)) return Side::unknown;
    return most < 0 ? Side::front : Side::behind;
  }

  const model::Mesh& mesh_;
  const Segments &tracked_, &reference_;
  std::optional<contact::Neighbours> neighbours_;
};

struct Votes {
  std::uint64_t front = 0, behind = 0, unknown = 0;
  void add(Side side) { ++(side == Side::front ? front : side == Side::behind ? behind : unknown); }
  Votes& operator+=(const Votes& other) {
    front += other.front;
    behind += other.behind;
    unknown += other.unknown;
    return *this;
  }
};

/// What cannot be judged, for --stats.
struct LeftOut {
  std::uint64_t turned_by_solver = 0, mixed = 0, both_sides = 0, unknown = 0;
  void tell(const RuleIdentity& rule, Context& context) const {
    const auto say = [&](std::uint64_t count, std::string_view what) {
      if (count > 0) context.skipped(rule, fmt::format("{} {}", count, what));
    };
    say(turned_by_solver, "tiebreaks whose segments the solver turns itself (ORIEN)");
    say(mixed, "reference surfaces of tiebreaks whose segments disagree with each other");
    say(both_sides, "reference surfaces of tiebreaks with tied nodes on both sides");
    say(unknown, "reference surfaces of tiebreaks that coincide with what they hold");
  }
};

void check_contact(const RuleIdentity& rule, Context& context, Report& report, ContactIndex c,
                   std::span<const JudgedNode> nodes, LeftOut& left_out) {
  const model::Model& model = context.model();
  const contact::ContactSurfaces& surfaces = context.surfaces(c);
  const Segments& segments = surfaces.b.selection.segments;
  Sides sides(model.mesh, surfaces);
  std::vector<Votes> votes(segments.size());
  bool any = false;
  for (const JudgedNode& node : nodes)
    if (node.tied() && may_face_away(segments, node.segment)) {
      votes[node.segment.value].add(sides.of(node));
      any = true;
    }
  if (!any) return;
  if (contact::solver_turns(model.controls, model.contact(c).b.type)) {
    ++left_out.turned_by_solver;
    return;
  }
  contact::for_each_connected_surface(segments, [&](const contact::ConnectedSurface& surface) {
    Votes all;
    SegmentIndex first = none<SegmentIndex>;
    for (const SegmentIndex i : surface.segments) {
      if (votes[i.value].behind > 0 && (first == none<SegmentIndex> || i < first)) first = i;
      all += votes[i.value];
    }
    if (all.front + all.behind == 0) {
      left_out.unknown += all.unknown > 0 ? 1 : 0;
      return;
    }
    if (!surface.turned.empty()) ++left_out.mixed;
    if (all.behind > 0 && all.front > 0 && surface.turned.empty()) ++left_out.both_sides;
    if (all.behind == 0 || all.front > 0 || !surface.turned.empty()) return;
    const PartIndex part = part_of(model.mesh, segments, first.value);
    const std::int64_t part_id = part == none<PartIndex> ? 0 : model.part(part).id.value;
    const std::size_t count = surface.segments.size();
    Finding f =
        finding_at(rule, context, model.contact(c),
                   fmt::format("side B{}: {} look{} away from the {} tied there, so that pressure counts as tension; "
                               "turn {} towards the tracked side",
                               part_id != 0 ? fmt::format(", part {}", part_id) : "",
                               count == 1 ? "the segment" : fmt::format("all {} connected segments", count),
                               count == 1 ? "s" : "", node_count(all.behind), count == 1 ? "it" : "them"));
    f.part = f.element_part = part_id;
    f.element = element_id(model.mesh, segments, first.value);
    f.count = count;
    const auto& corners = segments.nodes[first.value];
    f.point = (model.mesh.nodes.x[corners[0].value] + model.mesh.nodes.x[corners[2].value]) / 2;
    if (context.options().members)
      for (const SegmentIndex i : surface.segments) add_segment(model.mesh.nodes, segments.nodes[i.value], f.members);
    report.findings.push_back(std::move(f));
  });
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  LeftOut left_out;
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    if (oriented(context.model().contact(c))) check_contact(rule, context, report, c, nodes, left_out);
  });
  left_out.tell(rule, context);
}

}  // namespace

const Rule definition{
    {"GC212", "flipped-tiebreak", Severity::warning,
     "the reference side of a tiebreak looks away from the nodes tied to it", Need::surfaces | Need::ties,
     "The tiebreak sees its nodes from behind: after failure they fall through"},
    run};

}  // namespace gapcheck::audit::rule::flipped_tiebreak
