#include "audit/untangle/wrong_pieces.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "audit/untangle/flood.hpp"
#include "base/quad.hpp"
#include "contact/search/box_pairs.hpp"
#include "geometry/intersect.hpp"

namespace gapcheck::audit {
namespace {

/// One surface is shifted by this share of its segments, in a direction in which no mesh has lines, before cuts are
/// counted: then no node and no edge of one lies exactly on the other.
constexpr double shift_share = 1e-6;
const Vector shift_direction = Vector(0.5377, 0.2147, 0.8154);

using MeshEdge = std::pair<NodeIndex, NodeIndex>;

struct EdgeCut {
  MeshEdge edge;
  SegmentIndex through;   ///< segment of the other surface
  double first_side = 1;  ///< the side of it on which edge.first is
};

std::vector<MeshEdge> edges_around(const contact::Segments& segments, std::span<const SegmentIndex> list) {
  std::vector<MeshEdge> edges;
  for (const SegmentIndex s : list)
    for_each_edge(segments, s, [&](NodeIndex a, NodeIndex b) { edges.emplace_back(std::min(a, b), std::max(a, b)); });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double mean_diagonal(const CutSurface& surface, std::span<const SegmentIndex> list) {
  double sum = 0;
  for (const SegmentIndex s : list) {
    const auto& n = surface.segments().nodes[s.value];
    sum += (surface.x()[n[2].value] - surface.x()[n[0].value]).norm();
  }
  return list.empty() ? 0 : sum / static_cast<double>(list.size());
}

/// The triangles of a segment: quads have two, along the diagonal from their first corner, as for crossings.
std::vector<geometry::Triangle> triangles(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  std::vector<geometry::Triangle> list{{x[n[0].value], x[n[1].value], x[n[2].value]}};
  if (n[2] != n[3]) list.push_back({x[n[0].value], x[n[2].value], x[n[3].value]});
  return list;
}

/// Edges of one surface that pass through the other an odd number of times, each with one of these segments.
std::vector<EdgeCut> find_cuts(const CutSurface& of, std::span<const SegmentIndex> around, const CutSurface& other,
                               std::span<const SegmentIndex> other_around) {
  const contact::Segments& faces = other.segments();
  const std::vector<MeshEdge> edges = edges_around(of.segments(), around);
  const Vector shift = shift_share * mean_diagonal(of, around) * shift_direction;
  std::vector<contact::Bounds> of_edges(edges.size()), of_faces(other_around.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const NodeIndex n : {edges[i].first, edges[i].second}) of_edges[i].add(of.x()[n.value] + shift);
  for (std::size_t i = 0; i < other_around.size(); ++i)
    for (const NodeIndex n : faces.nodes[other_around[i].value]) of_faces[i].add(other.x()[n.value]);
  std::mutex mutex;
  std::map<std::uint32_t, std::vector<EdgeCut>> passages;
  geometry::DecisionCounters counters;
  contact::for_each_box_pair(of_edges, of_faces, [&](std::uint32_t e, std::uint32_t f) {
    const auto& n = faces.nodes[other_around[f].value];
    const auto& [a, b] = edges[e];
    if (std::find(n.begin(), n.end(), a) != n.end() || std::find(n.begin(), n.end(), b) != n.end()) return;
    const Vector p = of.x()[a.value] + shift, q = of.x()[b.value] + shift;
    for (const geometry::Triangle& t : triangles(n, other.x())) {
      if (geometry::passage(p, q, t, geometry::Mode::filtered, counters) != geometry::Passage::through) continue;
      const double height = (t[1] - t[0]).cross(t[2] - t[0]).dot(p - t[0]);
      const std::lock_guard lock(mutex);
      passages[e].push_back({edges[e], other_around[f], height > 0 ? 1.0 : -1.0});
    }
  });
  std::vector<EdgeCut> cuts;
  for (auto& [edge, list] : passages) {
    if (list.size() % 2 == 0) continue;
    cuts.push_back(*std::min_element(list.begin(), list.end(), [](const EdgeCut& l, const EdgeCut& r) {
      return l.through.value < r.through.value;
    }));
  }
  return cuts;
}

/// True if most of the segments that are cut through belong to solids.
bool through_solids(const std::vector<EdgeCut>& cuts, const contact::Segments& faces) {
  const auto count = std::count_if(cuts.begin(), cuts.end(), [&](const EdgeCut& c) {
    return faces.kind[c.through.value] == contact::SegmentKind::solid;
  });
  return 2 * static_cast<std::size_t>(count) > cuts.size();
}

/// The number of the region with the right nodes; nothing if there is none.
std::optional<std::uint32_t> right_region(const Flood& flood, const std::vector<EdgeCut>& cuts, bool behind_solids) {
  if (!behind_solids) return flood.largest();
  std::map<std::uint32_t, double> in_front;
  for (const EdgeCut& c : cuts) {
    in_front[flood.region(c.edge.first)] += c.first_side;
    in_front[flood.region(c.edge.second)] -= c.first_side;
  }
  const auto most = std::max_element(in_front.begin(), in_front.end(),
                                     [](const auto& l, const auto& r) { return l.second < r.second; });
  if (most == in_front.end() || !(most->second > 0)) return std::nullopt;
  return most->first;
}

void sort_once(std::vector<NodeIndex>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

struct PieceChoice {
  WrongPiece piece;
  bool behind_solids = false;
};

/// One of two surfaces at a contour.
struct SurfaceAtContour {
  const CutSurface* surface = nullptr;
  std::vector<SegmentIndex> around;
};

/// The wrong piece of one surface.
class PieceFinder {
 public:
  PieceFinder(const SurfaceAtContour& of, const SurfaceAtContour& other)
      : of_(*of.surface), other_(*other.surface), cuts_(find_cuts(of_, of.around, other_, other.around)) {
    choice_.behind_solids = through_solids(cuts_, other_.segments());
    for (const EdgeCut& c : cuts_) {
      closed_.insert(c.edge);
      ends_.push_back(c.edge.first);
      ends_.push_back(c.edge.second);
      faces_.push_back({c.through, 1});
    }
    sort_once(ends_);
  }
  /// Nothing if the contour does not divide the surface.
  [[nodiscard]] std::optional<PieceChoice> find(std::uint64_t& work) { return find(work, {}); }
  [[nodiscard]] bool cuts_nothing() const { return cuts_.empty(); }
  /// The same among nodes that are above or below the other surface, at most `reach` away.
  [[nodiscard]] std::optional<PieceChoice> find_facing(double reach, std::uint64_t& work) {
    FaceRegion region(other_);
    contact::Bounds all;
    all.low.setConstant(-1e300);
    all.high.setConstant(1e300);
    if (cuts_.empty() || !region.grow(faces_, all, work)) return std::nullopt;
    return find(work, [&](NodeIndex n) {
      const std::uint64_t steps = region.faces().size();
      if (work < steps) return false;
      work -= steps;
      const NearestFace nearest = region.nearest(n);
      return nearest.above && nearest.distance <= reach;
    });
  }

 private:
  std::optional<PieceChoice> find(std::uint64_t& work, const Flood::Allowed& allowed) {
    if (cuts_.empty()) return std::nullopt;
    // What is inside a solid may be the larger part.
    const auto until = choice_.behind_solids ? Flood::Until::all_known : Flood::Until::one_left;
    const auto flood = Flood::over(of_.segments(), of_.neighbours(), ends_, closed_, allowed, until, work);
    if (!flood) return std::nullopt;
    for (const EdgeCut& c : cuts_)
      if (flood->region(c.edge.first) == flood->region(c.edge.second)) return std::nullopt;
    const auto right = right_region(*flood, cuts_, choice_.behind_solids);
    if (!right || !take(*flood, *right)) return std::nullopt;
    return std::move(choice_);
  }
  /// False if a wrong region has not been grown to its end.
  bool take(const Flood& flood, std::uint32_t right) {
    WrongPiece& piece = choice_.piece;
    piece = {};
    std::map<std::uint32_t, double> sides;
    std::set<std::uint32_t> wrong;
    for (const EdgeCut& c : cuts_) {
      const bool first_right = flood.region(c.edge.first) == right;
      if (!first_right && flood.region(c.edge.second) != right) continue;  // beyond another wrong piece
      wrong.insert(flood.region(first_right ? c.edge.second : c.edge.first));
      piece.rim.push_back(first_right ? c.edge.first : c.edge.second);
      sides[c.through.value] += first_right ? c.first_side : -c.first_side;
    }
    for (const std::uint32_t region : wrong) {
      if (flood.open(region)) return false;
      const std::vector<NodeIndex> nodes = flood.nodes(region);
      piece.nodes.insert(piece.nodes.end(), nodes.begin(), nodes.end());
    }
    sort_once(piece.nodes);
    sort_once(piece.rim);
    for (const auto& [segment, side] : sides)
      if (side != 0) piece.faces.push_back({SegmentIndex{segment}, side > 0 ? 1.0 : -1.0});
    return true;
  }

  const CutSurface& of_;
  const CutSurface& other_;
  std::vector<EdgeCut> cuts_;
  std::set<MeshEdge> closed_;
  std::vector<NodeIndex> ends_;
  std::vector<FaceSide> faces_;
  PieceChoice choice_;
};

bool solids_only(const SurfaceAtContour& at) {
  return std::all_of(at.around.begin(), at.around.end(), [&](SegmentIndex s) {
    return at.surface->segments().kind[s.value] == contact::SegmentKind::solid;
  });
}

/// Segments that only graze each other, between their corners: these are on the right side, and not far enough on it.
/// So are those of solids whose edges and corners cut into each other: which side is right is known.
WrongPiece grazing_piece(const SurfaceAtContour& of, std::span<const ElementOfKind> elements,
                         const SurfaceAtContour& other, std::span<const ElementOfKind> other_elements,
                         const model::Mesh& mesh) {
  WrongPiece piece;
  Vector middle = Vector::Zero();
  for (const ElementOfKind& element : elements)
    for (const NodeIndex n : nodes_of(mesh, element))
      if (!of.surface->neighbours().at(n).empty()) piece.rim.push_back(n);
  sort_once(piece.rim);
  for (const NodeIndex n : piece.rim) middle += of.surface->x()[n.value] / static_cast<double>(piece.rim.size());
  const contact::Segments& segments = other.surface->segments();
  const std::vector<Vector>& x = other.surface->x();
  for (const SegmentIndex s : other.around) {
    const ElementOfKind element{segments.element_kind[s.value], segments.element[s.value]};
    if (std::find(other_elements.begin(), other_elements.end(), element) == other_elements.end()) continue;
    const auto& n = segments.nodes[s.value];
    const double height = quad_normal(n, x).dot(middle - x[n[0].value]);
    const bool front = segments.kind[s.value] == contact::SegmentKind::solid || height > 0;
    piece.faces.push_back({s, front ? 1.0 : -1.0});
  }
  return piece;
}

}  // namespace

std::vector<WrongPiece> find_wrong_pieces(const Contour& contour, const model::Mesh& mesh, const CutSurface& first,
                                          const CutSurface& second, double reach, std::uint64_t& work) {
  std::array<SurfaceAtContour, 2> at{
      {{&first, first.around(mesh, contour.elements[0])}, {&second, second.around(mesh, contour.elements[1])}}};
  if (at[0].around.empty() || at[1].around.empty()) return {};
  std::array<PieceFinder, 2> finders{PieceFinder(at[0], at[1]), PieceFinder(at[1], at[0])};
  std::array<std::optional<PieceChoice>, 2> found{finders[0].find(work), finders[1].find(work)};
  if (!found[0] && !found[1]) found = {finders[0].find_facing(reach, work), finders[1].find_facing(reach, work)};
  const bool grazing = finders[0].cuts_nothing() && finders[1].cuts_nothing();
  if (grazing || (!found[0] && !found[1] && solids_only(at[0]) && solids_only(at[1]))) {
    for (std::size_t i = 0; i < 2; ++i)
      found[i].emplace().piece = grazing_piece(at[i], contour.elements[i], at[1 - i], contour.elements[1 - i], mesh);
    found[0]->behind_solids = found[1]->behind_solids = true;  // both are kept
  }
  for (std::size_t i = 0; i < 2; ++i)
    if (found[i]) found[i]->piece.other_is_second = i == 0;
  // A solid knows its inside; of two sheets one has to give way.
  const bool solids = (found[0] && found[0]->behind_solids) || (found[1] && found[1]->behind_solids);
  for (auto& choice : found)
    if (choice && solids && !choice->behind_solids) choice.reset();
  if (!solids && found[0] && found[1])
    found[found[1]->piece.nodes.size() < found[0]->piece.nodes.size() ? 0 : 1].reset();
  std::vector<WrongPiece> pieces;
  for (auto& choice : found)
    if (choice) pieces.push_back(std::move(choice->piece));
  return pieces;
}

}  // namespace gapcheck::audit
