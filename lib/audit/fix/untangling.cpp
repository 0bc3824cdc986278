#include "audit/fix/untangling.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "contact/crossing/crossings.hpp"

namespace gapcheck::audit {
namespace {

/// Half the contact thickness of a node and how far it is from its mid-surface: as tracked, else of its segments.
struct NodeThickness {
  double half = 0;
  Vector shift = Vector::Zero();

  NodeThickness(const CutSurface& surface, NodeIndex node) {
    const contact::TrackedNodes& tracked = surface.side().nodes;
    const auto found = std::lower_bound(tracked.node.begin(), tracked.node.end(), node);
    if (found != tracked.node.end() && *found == node) {
      const auto slot = static_cast<std::size_t>(found - tracked.node.begin());
      half = tracked.half[slot];
      if (!tracked.shift.empty()) shift = tracked.shift[slot];
      return;
    }
    for (const SegmentIndex s : surface.neighbours().at(node)) half = std::max(half, surface.segments().half[s.value]);
  }
};

double diagonal_of(const CutSurface& surface, SegmentIndex s) {
  const auto& n = surface.segments().nodes[s.value];
  return (surface.x()[n[2].value] - surface.x()[n[0].value]).norm();
}

/// How far pieces at a contour may reach.
double reach_at(const CutSurface& first, const CutSurface& second, const model::Mesh& mesh, const Contour& contour) {
  double size = 0, half = 0;
  std::size_t count = 0;
  for (const auto& [surface, elements] : {std::pair(&first, &contour.elements[0]), {&second, &contour.elements[1]}})
    for (const SegmentIndex s : surface->around(mesh, *elements)) {
      size += diagonal_of(*surface, s);
      half = std::max(half, surface->segments().half[s.value]);
      ++count;
    }
  return Untangling::reach(count > 0 ? size / static_cast<double>(count) : 0, 2 * half);
}

/// True if any pair of the contour is among these.
bool contains_any(const Contour& contour, std::span<const ElementPair> pairs, const std::set<ElementPair>& left_alone) {
  if (left_alone.empty()) return false;
  const auto on = [](const std::vector<ElementOfKind>& list, const ElementOfKind& element) {
    return std::binary_search(list.begin(), list.end(), element);
  };
  return std::any_of(pairs.begin(), pairs.end(), [&](const ElementPair& p) {
    return left_alone.contains(p) && ((on(contour.elements[0], p.first) && on(contour.elements[1], p.second)) ||
                                      (on(contour.elements[1], p.first) && on(contour.elements[0], p.second)));
  });
}

}  // namespace

Untangling::Untangling(const model::Model& model, contact::SurfaceStore& surfaces, const std::vector<Vector>& x,
                       std::span<const ContactCrossing> crossings, const std::set<ElementPair>& left_alone,
                       std::uint64_t& work) {
  for (auto from = crossings.begin(); from != crossings.end();) {
    const auto to =
        std::find_if(from, crossings.end(), [&](const ContactCrossing& c) { return c.contact != from->contact; });
    std::vector<ElementPair> pairs;
    for (auto c = from; c != to; ++c) pairs.push_back(c->elements);
    take_contact(model, surfaces.at(from->contact), from->contact, x, pairs, left_alone, work);
    from = to;
  }
}

void Untangling::take_contact(const model::Model& model, const contact::ContactSurfaces& surfaces, ContactIndex contact,
                              const std::vector<Vector>& x, std::span<const ElementPair> pairs,
                              const std::set<ElementPair>& left_alone, std::uint64_t& work) {
  const CutSurface a(surfaces.a, model.mesh, x);
  std::optional<CutSurface> of_b;
  if (surfaces.two_sided()) of_b.emplace(surfaces.b, model.mesh, x);
  const CutSurface& b = of_b ? *of_b : a;
  for (const Contour& contour : find_contours(model.mesh, pairs)) {
    Hooked hooked{contact, contour.elements, contour.pairs};
    bool any = false;
    if (!contains_any(contour, pairs, left_alone)) {
      // On side A are the first elements, or in contacts with two sides perhaps the second ones.
      const bool turned = a.around(model.mesh, contour.elements[0]).empty();
      const CutSurface &first = turned ? b : a, &second = turned ? a : b;
      for (const WrongPiece& piece :
           find_wrong_pieces(contour, model.mesh, first, second, reach_at(first, second, model.mesh, contour), work)) {
        const CutSurface &own = piece.other_is_second ? first : second, &other = piece.other_is_second ? second : first;
        const double too_deep = take_piece(piece, own, other, contact, work);
        any |= too_deep == 0;
        hooked.too_deep = std::max(hooked.too_deep, too_deep);
      }
    }
    if (!any) hooked_.push_back(std::move(hooked));
  }
}

/// Adds its gaps; returns how deep the piece is if it is too deep, else 0.
double Untangling::take_piece(const WrongPiece& piece, const CutSurface& own, const CutSurface& other,
                              ContactIndex contact, std::uint64_t& work) {
  const auto facing = face_piece(piece, other, work);
  double deepest = 0, distance = 0, size = 0;
  if (!facing || facing->empty()) return std::numeric_limits<double>::infinity();
  std::vector<Found> found;
  Place place;
  for (const Facing& f : *facing) {
    const std::size_t segment = f.face.segment.value;
    const NodeThickness thickness(own, f.node);
    Gap gap;
    gap.contact = contact;
    gap.node = f.node;
    gap.corners = other.segments().nodes[segment];
    gap.side = f.face.side;
    gap.distance = thickness.half + other.segments().half[segment];
    gap.shift = thickness.shift;
    if (!other.segments().offset.empty()) gap.offset = other.segments().offset[segment];
    place.other.insert(gap.corners.begin(), gap.corners.end());
    double depth = gap.distance + (f.wrong ? f.depth : -f.depth);
    if (piece.nodes.empty())
      depth = std::max(depth, 2 * contact::crossing_tolerance * diagonal_of(other, f.face.segment));
    if (f.wrong) deepest = std::max(deepest, f.depth);
    distance = std::max(distance, gap.distance);
    size += diagonal_of(other, f.face.segment);
    if (depth > 0) found.push_back({gap, depth});
  }
  size /= static_cast<double>(facing->size());
  if (deepest > Untangling::reach(size, distance)) return deepest;
  place.piece.insert(piece.nodes.begin(), piece.nodes.end());
  place.piece.insert(piece.rim.begin(), piece.rim.end());
  gaps_.insert(gaps_.end(), found.begin(), found.end());
  places_.push_back(std::move(place));
  return 0;
}

void Untangling::add_to(Gaps& gaps, const model::Mesh& mesh, const std::vector<Vector>& x) const {
  for (const Found& one : gaps_) gaps.add(mesh, one.gap, one.depth, x);
}

bool Untangling::at_crossing(NodeIndex node, const model::SegmentNodes& segment) const {
  const auto on = [&](const std::set<NodeIndex>& nodes) {
    return std::any_of(segment.begin(), segment.end(), [&](NodeIndex n) { return nodes.contains(n); });
  };
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return (place.piece.contains(node) && on(place.other)) || (place.other.contains(node) && on(place.piece));
  });
}

}  // namespace gapcheck::audit
