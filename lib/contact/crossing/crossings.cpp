#include "contact/crossing/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/large_array.hpp"
#include "base/parallel.hpp"
#include "base/union_find.hpp"
#include "contact/crossing/cross_around.hpp"
#include "contact/crossing/heights_over.hpp"
#include "contact/surface/neighbours.hpp"
#include "contact/surface/segment_elements.hpp"
#include "geometry/intersect.hpp"

namespace gapcheck::contact {
namespace {

using geometry::Triangle;

bool share_a_node(const model::SegmentNodes& a, const model::SegmentNodes& b) {
  unsigned shared = 0;  // without branches: this is asked of every pair
  for (const NodeIndex n : a)
    shared |= unsigned{n == b[0]} | unsigned{n == b[1]} | unsigned{n == b[2]} | unsigned{n == b[3]};
  return shared != 0;
}

/// One side with a box around each segment that takes part.
struct Side {
  const Segments& segments;
  const std::vector<Vector>& x;
  const model::Mesh& mesh;
  double fraction;  ///< of a segment's size: the tolerance
  std::vector<Bounds> boxes;

  Side(const Segments& s, const model::Model& model, const CrossingPairs& pairs, bool lines,
       const CrossingOptions& options)
      : segments(s),
        x(options.x != nullptr ? *options.x : model.mesh.nodes.x),
        mesh(model.mesh),
        fraction(options.tolerance),
        boxes(large_array<Bounds>(s.size())) {
    parallel_for(s.size(), 8192, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if ((s.kind[i] == SegmentKind::line && !lines) || !pairs.takes_part(part_of(mesh, s, i))) continue;
        for (const NodeIndex n : s.nodes[i]) boxes[i].add(x[n.value]);
        const Vector room = Vector::Constant(2 * tolerance(i));
        boxes[i].low -= room;
        boxes[i].high += room;
      }
    });
  }
  [[nodiscard]] double tolerance(std::size_t i) const {
    const auto& n = segments.nodes[i];
    const Vector size = (x[n[2].value] - x[n[0].value]).cwiseAbs().cwiseMax((x[n[3].value] - x[n[1].value]).cwiseAbs());
    return fraction * size.maxCoeff();
  }
  /// Leaves only the boxes that meet `other`.
  void keep(const Bounds& other) {
    for (Bounds& box : boxes)
      if (!box.meets(other)) box = {};
  }
  [[nodiscard]] Bounds bounds() const {
    Bounds all;
    for (const Bounds& box : boxes)
      if (!box.empty()) all.add(box.low), all.add(box.high);
    return all;
  }
  [[nodiscard]] CrossingSegment segment(SegmentIndex i) const {
    return {segments.nodes[i.value], segments.element_kind[i.value], segments.element[i.value],
            part_of(mesh, segments, i.value)};
  }
  /// Segments at each node; built on first use, by any thread.
  [[nodiscard]] const Neighbours& neighbours() const {
    std::call_once(once_, [&] { neighbours_ = std::make_unique<const Neighbours>(segments, mesh); });
    return *neighbours_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Neighbours> neighbours_;
};

/// Heights over the plane of a triangle.
class Plane {
 public:
  explicit Plane(const Triangle& t) : origin_(t[0]), normal_((t[1] - t[0]).cross(t[2] - t[0]).stableNormalized()) {}
  [[nodiscard]] double height(const Vector& x) const { return normal_.dot(x - origin_); }
  /// How far the points stick out on the side where they stick out less.
  [[nodiscard]] double depth(const model::SegmentNodes& nodes, const std::vector<Vector>& x) const {
    double low = 0, high = 0;
    for (const NodeIndex n : nodes) {
      low = std::min(low, height(x[n.value]));
      high = std::max(high, height(x[n.value]));
    }
    return std::min(-low, high);
  }

 private:
  Vector origin_, normal_;
};

/// One of the triangles of a segment: its corners, and which corners of the segment they are.
struct Piece {
  Triangle x;
  std::array<std::size_t, 3> corner;
};

struct Pieces {
  std::array<Piece, 2> list;
  std::size_t count = 1;
  Pieces(const model::SegmentNodes& n, const std::vector<Vector>& x) {
    const auto piece = [&](std::size_t i, std::size_t j, std::size_t k) {
      return Piece{{x[n[i].value], x[n[j].value], x[n[k].value]}, {i, j, k}};
    };
    list[0] = piece(0, 1, 2);
    list[1] = piece(0, 2, 3);
    if (n[2] != n[3]) count = 2;
  }
  [[nodiscard]] std::span<const Piece> all() const { return {list.data(), count}; }
  /// Of a triangle, both are its own.
  [[nodiscard]] std::array<Plane, 2> planes() const {
    const Plane first(list[0].x);
    return {first, count > 1 ? Plane(list[1].x) : first};
  }
};

/// Position of a triangle relative to a plane, within a tolerance.
struct Reach {
  enum class Kind : std::uint8_t {
    none,     ///< at most a corner on it
    through,  ///< on both sides
    edge,     ///< two corners on it, the third on one side
  } kind = Kind::none;
  std::size_t third = 0;  ///< edge: the corner that is not on the plane (of the triangle)
  int side = 0;           ///< edge: its position

  Reach(const Triangle& t, const Plane& plane, double tolerance) {
    std::array<int, 3> sign{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double h = plane.height(t[i]);
      sign[i] = h > tolerance ? 1 : h < -tolerance ? -1 : 0;
    }
    const auto [low, high] = std::minmax_element(sign.begin(), sign.end());
    if (*low < 0 && *high > 0) kind = Kind::through;
    if (std::count(sign.begin(), sign.end(), 0) != 2) return;
    kind = Kind::edge;
    third =
        static_cast<std::size_t>(std::find_if(sign.begin(), sign.end(), [](int v) { return v != 0; }) - sign.begin());
    side = sign[third];
  }
};

/// Decides pairs of segments; for use from several threads.
class Decider {
 public:
  Decider(const Side& a, const Side& b, const CrossingOptions& options, CrossingCounters& counters)
      : a_(a), b_(b), options_(options), counters_(counters) {}

  /// Fills ends and depth; false if they do not cross.
  bool cross(SegmentIndex i, SegmentIndex j, Crossing& out) const {
    const double tolerance = std::max(a_.tolerance(i.value), b_.tolerance(j.value));
    const bool line_a = a_.segments.kind[i.value] == SegmentKind::line;
    const bool line_b = b_.segments.kind[j.value] == SegmentKind::line;
    if (line_a && line_b) return false;
    if (line_a) return pierce(a_, i, b_, j, tolerance, out);
    if (line_b) return pierce(b_, j, a_, i, tolerance, out);
    const model::SegmentNodes &nodes_a = a_.segments.nodes[i.value], &nodes_b = b_.segments.nodes[j.value];
    const Pieces of_a(nodes_a, a_.x), of_b(nodes_b, b_.x);
    // How far either segment sticks out of the planes of the other one's pieces.
    const std::array<Plane, 2> planes_a = of_a.planes(), planes_b = of_b.planes();
    std::array<double, 2> of_b_out{}, of_a_out{};
    for (std::size_t k = 0; k < of_a.count; ++k) of_b_out[k] = planes_a[k].depth(nodes_b, b_.x);
    for (std::size_t k = 0; k < of_b.count; ++k) of_a_out[k] = planes_b[k].depth(nodes_a, a_.x);
    bool any = false;
    for (std::size_t k = 0; k < of_a.count; ++k)
      for (std::size_t l = 0; l < of_b.count; ++l) {
        const Piece &p = of_a.list[k], &q = of_b.list[l];
        const double depth = std::min(of_a_out[l], of_b_out[k]);
        geometry::Line line;
        double least = tolerance;  // shorter ones are corners that touch
        if (depth > tolerance && geometry::triangles_cross(p.x, q.x, options_.mode, counters_.decisions))
          line = geometry::common_line(p.x, q.x);
        else {
          line = line_of_meshes({i, p, planes_a[k]}, {j, q, planes_b[l]}, tolerance);
          least = 2 * tolerance;
        }
        if (!(line.length() > least)) continue;
        add(out, line, any);
        out.depth = std::max(out.depth, depth);
        any = true;
      }
    return any;
  }

 private:
  /// A beam's axis against a segment.
  bool pierce(const Side& lines, SegmentIndex line, const Side& faces, SegmentIndex face, double tolerance,
              Crossing& out) const {
    const model::SegmentNodes& ends = lines.segments.nodes[line.value];
    const Vector &p = lines.x[ends[0].value], &q = lines.x[ends[1].value];
    const Pieces pieces(faces.segments.nodes[face.value], faces.x);
    for (const Piece& piece : pieces.all()) {
      if (!geometry::segment_crosses(p, q, piece.x, options_.mode, counters_.decisions)) continue;
      const Plane plane(piece.x);
      const double of_p = plane.height(p), of_q = plane.height(q);
      out.depth = std::min(std::abs(of_p), std::abs(of_q));
      if (!(out.depth > tolerance)) continue;
      out.from = out.to = p + of_p / (of_p - of_q) * (q - p);
      return true;
    }
    return false;
  }

  /// The triangle, and where an edge of it lies in the plane, those beyond that edge.
  static std::vector<Triangle> surface_at(const Side& side, SegmentIndex segment, const Piece& piece,
                                          const Plane& plane, double tolerance) {
    const Reach reach(piece.x, plane, tolerance);
    std::vector<Triangle> surface;
    if (reach.kind == Reach::Kind::none) return surface;
    surface.push_back(piece.x);
    if (reach.kind == Reach::Kind::through) return surface;
    const auto& nodes = side.segments.nodes[segment.value];
    const std::size_t third = piece.corner[reach.third];
    const bool diagonal = nodes[2] != nodes[3] && third % 2 == 1;
    if (diagonal) {
      surface.push_back(Pieces(nodes, side.x).list[third == 1 ? 1 : 0].x);
      return surface;
    }
    const NodeIndex u = nodes[piece.corner[(reach.third + 1) % 3]], v = nodes[piece.corner[(reach.third + 2) % 3]];
    for (const SegmentIndex other : side.neighbours().at(u)) {
      const auto& n = side.segments.nodes[other.value];
      if (other == segment || std::find(n.begin(), n.end(), v) == n.end()) continue;
      const Pieces beyond(n, side.x);
      for (const Piece& one : beyond.all()) surface.push_back(one.x);
    }
    return surface;
  }

  /// True if a surface is on both sides of another one, above and below it. Meshes that cross along their mesh lines do
  /// so; surfaces that lie on each other do not, though the plane of a triangle may cut those that lie farther away.
  static bool goes_through(const std::vector<Triangle>& surface, const std::vector<Triangle>& other, double tolerance) {
    if (surface.empty() || other.empty()) return false;
    const Vector up = (other[0][1] - other[0][0]).cross(other[0][2] - other[0][0]);
    Heights all;
    for (const Triangle& t : surface)
      for (const Triangle& base : other) {
        const Heights heights = heights_over(base, t, tolerance, up);
        all.low = std::min(all.low, heights.low);
        all.high = std::max(all.high, heights.high);
      }
    return all.low < -tolerance && all.high > tolerance;
  }

  struct PieceOf {
    SegmentIndex segment;
    const Piece& piece;
    const Plane& plane;
  };

  /// The line in which two triangles meet within the tolerance, if they belong to surfaces that go through each other.
  geometry::Line line_of_meshes(const PieceOf& p, const PieceOf& q, double tolerance) const {
    const std::vector<Triangle> a = surface_at(a_, p.segment, p.piece, q.plane, tolerance);
    if (a.empty()) return {};
    const std::vector<Triangle> b = surface_at(b_, q.segment, q.piece, p.plane, tolerance);
    if (!goes_through(a, b, tolerance) || !goes_through(b, a, tolerance)) return {};
    const geometry::Line line = geometry::common_line(p.piece.x, q.piece.x, tolerance);
    return cross_around(line, a, b, tolerance) ? line : geometry::Line{};
  }

  /// The ends of several pieces of a line: those farthest apart.
  static void add(Crossing& out, const geometry::Line& line, bool any) {
    if (!any) {
      out.from = line.from;
      out.to = line.to;
      return;
    }
    for (const Vector& end : {line.from, line.to}) {
      const double to_from = (end - out.from).norm(), to_to = (end - out.to).norm();
      if (to_from > out.length() && to_from >= to_to)
        out.to = end;
      else if (to_to > out.length())
        out.from = end;
    }
  }

  const Side& a_;
  const Side& b_;
  const CrossingOptions& options_;
  CrossingCounters& counters_;
};

/// Identifies an element: segments without one are identified by their nodes.
using ElementKey = std::tuple<model::ElementKind, std::uint32_t, model::SegmentNodes>;
ElementKey key(const CrossingSegment& s) {
  return {s.kind, s.element, s.element == no_position ? segment_key(s.nodes) : model::SegmentNodes{}};
}

/// Seven digits, so that the order of summation does not matter.
float rough(double value) { return static_cast<float>(std::clamp(value, -1e38, 1e38)); }

/// Puts the two sides of each crossing in order, sorts by them, and leaves the longest of each pair of elements; of
/// equally long ones the first by position, whatever the order of the nodes.
void tidy(std::vector<Crossing>& crossings) {
  for (Crossing& c : crossings)
    if (key(c.b) < key(c.a)) std::swap(c.a, c.b);
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& l, const Crossing& r) {
    const auto order = [](const Crossing& c) {
      const Vector middle = 0.5 * (c.from + c.to);
      return std::tuple(key(c.a), key(c.b), -rough(c.length()), rough(middle.x()), rough(middle.y()), rough(middle.z()),
                        segment_key(c.a.nodes), segment_key(c.b.nodes));
    };
    return order(l) < order(r);
  });
  const auto same = [](const Crossing& l, const Crossing& r) { return key(l.a) == key(r.a) && key(l.b) == key(r.b); };
  crossings.erase(std::unique(crossings.begin(), crossings.end(), same), crossings.end());
}

/// Rigid parts that are one body: *CONSTRAINED_RIGID_BODIES merges them.
std::vector<std::uint32_t> rigid_bodies(const model::Model& model) {
  UnionFind bodies(model.parts.size());
  for (const model::RigidGroup& group : model.rigid_groups)
    if (group.kind == model::RigidGroup::Kind::merged_parts)
      for (const PartIndex p : group.parts) bodies.unite(p.value, group.parts[0].value);
  std::vector<std::uint32_t> out(model.parts.size(), no_position);
  for (std::uint32_t p = 0; p < out.size(); ++p)
    if (model.rigid(PartIndex{p})) out[p] = bodies.root(p);
  return out;
}

}  // namespace

CrossingPairs::CrossingPairs(const model::Model& model, ContactId contact)
    : exclusions_(model, contact), spotweld_(model.parts.size()), rigid_body_(rigid_bodies(model)) {
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    const auto& material = model.parts[p].material;
    spotweld_[p] = material && model.materials[*material].spotweld;
  }
}

bool CrossingPairs::counts(PartIndex a, PartIndex b) const {
  if (a == none<PartIndex> || b == none<PartIndex>) return true;
  if (rigid_body_[a.value] != no_position && rigid_body_[a.value] == rigid_body_[b.value]) return false;
  return !exclusions_.excluded(a, b);
}

namespace {

/// Those of one contact. `pairs`: of this contact.
std::vector<Crossing> crossings_of(const model::Model& model, const CrossingPairs& pairs, ContactIndex contact,
                                   const ContactSurfaces& surfaces, const CrossingOptions& options,
                                   CrossingCounters& counters) {
  std::vector<Crossing> found;
  const Segments& segments_a = surfaces.a.selection.segments;
  const Segments& segments_b = surfaces.two_sided() ? surfaces.b.selection.segments : segments_a;
  if (segments_a.size() == 0 || segments_b.size() == 0) return found;
  Side a(segments_a, model, pairs, surfaces.type.edges, options);
  std::optional<Side> other;
  if (surfaces.two_sided()) {
    other.emplace(segments_b, model, pairs, surfaces.type.edges, options);
    a.keep(other->bounds());
    other->keep(a.bounds());
  }
  const Side& b = other ? *other : a;
  const Decider decider(a, b, options, counters);
  std::mutex mutex;
  const auto visit = [&](std::uint32_t box_a, std::uint32_t box_b) {
    const SegmentIndex i{box_a}, j{box_b};
    if (share_a_node(segments_a.nodes[box_a], segments_b.nodes[box_b])) return;
    counters.box_pairs.fetch_add(1, std::memory_order_relaxed);
    Crossing crossing{contact, a.segment(i), b.segment(j)};
    const bool one_element = crossing.a.kind == crossing.b.kind && crossing.a.element == crossing.b.element;
    if ((one_element && crossing.a.element != no_position) || !pairs.counts(crossing.a.part, crossing.b.part)) return;
    if (!decider.cross(i, j, crossing)) return;
    const std::lock_guard lock(mutex);
    found.push_back(crossing);
  };
  if (other)
    for_each_box_pair(a.boxes, b.boxes, visit, options.search);
  else
    for_each_box_pair(a.boxes, visit, options.search);
  tidy(found);
  return found;
}

}  // namespace

std::vector<Crossing> find_crossings(const model::Model& model, ContactIndex contact, const ContactSurfaces& surfaces,
                                     const CrossingOptions& options, CrossingCounters& counters) {
  return crossings_of(model, CrossingPairs(model, model.contact(contact).id), contact, surfaces, options, counters);
}

std::vector<Crossing> find_crossings(const model::Model& model, std::span<const ContactIndex> contacts,
                                     SurfaceStore& surfaces, const CrossingOptions& options,
                                     CrossingCounters& counters) {
  std::vector<Crossing> all;
  std::set<std::pair<ElementKey, ElementKey>> seen;
  std::optional<CrossingPairs> pairs;  // what parts are is found once
  for (const ContactIndex i : contacts) {
    if (classify(model.contact(i)).pairing == Pairing::none) continue;
    if (pairs)
      pairs->turn_to(model, model.contact(i).id);
    else
      pairs.emplace(model, model.contact(i).id);
    for (const Crossing& crossing : crossings_of(model, *pairs, i, surfaces.at(i), options, counters))
      if (seen.emplace(key(crossing.a), key(crossing.b)).second) all.push_back(crossing);
  }
  return all;
}

}  // namespace gapcheck::contact
