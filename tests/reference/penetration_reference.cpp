#include "reference/penetration_reference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "reference/free_edges.hpp"
#include "reference/orientation.hpp"
#include "reference/release.hpp"
#include "reference/surfaces.hpp"
#include "reference/tie_pass.hpp"

namespace gapcheck::reference {
namespace {

using TiedPairs = std::set<std::pair<std::int64_t, std::int64_t>>;  ///< node, part

/// A tracked node seen from one segment.
struct Seen {
  const Facet* facet = nullptr;
  Closest closest;
  double h = 0;         ///< contact distance
  bool behind = false;  ///< oriented segments
  bool hit = false;
  [[nodiscard]] double depth() const { return behind ? h + closest.distance : h - closest.distance; }
};

struct Verdict {
  std::int64_t node = 0;
  bool found = false, in_band = false, released = false;
  std::string doubt;
  double depth = 0, contact_distance = 0, distance = 1e300;
  Vector direction = Vector::Zero();
  std::vector<std::int64_t> elements;
};

class Pass {
 public:
  Pass(const Scene& scene, const Rules& rules, const Side& tracked, const Side& reference, const Positions& x,
       const TiedPairs& tied)
      : scene_(scene),
        rules_(rules),
        tracked_(tracked),
        reference_(reference),
        x_(x),
        tied_(tied),
        turned_(turned_parts(rules, tracked, reference, x)),
        free_edges_(reference) {}

  [[nodiscard]] std::vector<Verdict> run() const {
    std::vector<Verdict> verdicts;
    for (const auto& [node, half] : tracked_.nodes) {
      if (rules_.by_segments && !is_corner(node)) continue;
      Verdict verdict = judge(node, half);
      if (verdict.found || !verdict.doubt.empty()) verdicts.push_back(verdict);
    }
    return verdicts;
  }

 private:
  /// Nodes of the elements at a node (1.3).
  struct Ring {
    std::set<std::int64_t> all, without_shells;
  };
  [[nodiscard]] Ring ring(std::int64_t node) const {
    Ring ring{{node}, {node}};
    if (!rules_.single) return ring;
    for (const Element& e : scene_.elements) {
      if (std::find(e.nodes.begin(), e.nodes.end(), node) == e.nodes.end()) continue;
      ring.all.insert(e.nodes.begin(), e.nodes.end());
      if (e.kind != Kind::shell) ring.without_shells.insert(e.nodes.begin(), e.nodes.end());
    }
    return ring;
  }
  static bool meets(const Facet& facet, const std::set<std::int64_t>& nodes) {
    return std::any_of(facet.nodes.begin(), facet.nodes.end(), [&](auto n) { return nodes.contains(n); });
  }
  /// A two-sided shell, which only leaves out its own nodes in a single surface (1.3).
  [[nodiscard]] bool meets_own_sheet(const Facet& facet) const {
    return rules_.single && !rules_.by_segments && !facet.line && !facet.coated && !oriented(facet);
  }

  [[nodiscard]] bool is_corner(std::int64_t node) const {
    return std::any_of(tracked_.facets.begin(), tracked_.facets.end(),
                       [&](const Facet& f) { return !f.line && f.has(node); });
  }

  [[nodiscard]] bool oriented(const Facet& f) const { return f.solid || (rules_.oriented && !f.line); }

  /// A node is behind a segment by its normal; beside an edge or corner, behind all segments that meet there (3.4).
  [[nodiscard]] bool is_behind(const Facet& facet, const Closest& c, const Vector& query, bool& in_plane) const {
    const std::size_t count = facet.triangle ? 3 : 4;
    const std::int64_t a = facet.nodes[c.place], b = facet.nodes[(c.place + 1) % count];
    for (const Facet& other : reference_.facets) {
      if (&other != &facet && c.feature == Feature::face) continue;
      if (!oriented(other) || !other.has(a)) continue;
      if (c.feature == Feature::edge && !other.has(b)) continue;
      const Closest own = &other == &facet ? c : closest_of(other, corners(other.nodes, x_), query);
      const int turn = other.solid || other.coated ? 1 : turned_.at(other.part);
      const double front = turn * own.normal.dot(query - c.point);
      in_plane = in_plane || std::abs(front) < 1e-9 * c.distance;
      if (front >= 0) return false;
    }
    return true;
  }

  /// How far behind a segment a node still counts (3.4).
  [[nodiscard]] double extent(const Facet& facet) const {
    if (!facet.solid) return 0.5 * shorter_diagonal(facet, x_);
    const Corners c = corners(facet.nodes, x_);
    const Vector normal = (c[2] - c[0]).cross(c[3] - c[1]).normalized(), middle = (c[0] + c[1] + c[2] + c[3]) / 4;
    double deepest = 0;
    for (const Element& e : scene_.elements)
      if (e.id == facet.element)
        for (const std::int64_t n : e.nodes) deepest = std::max(deepest, normal.dot(middle - at(x_, n)));
    return deepest;
  }

  [[nodiscard]] std::optional<Seen> see(const Facet& facet, double half, Verdict& verdict) const {
    const Vector& query = at(x_, verdict.node);
    const Corners around = corners(facet.nodes, x_);
    Seen seen{&facet, {}, half + facet.thickness / 2, false, false};
    const double behind = oriented(facet) ? extent(facet) : 0;
    Vector low = around[0], high = around[0];
    for (const Vector& c : around) low = low.cwiseMin(c), high = high.cwiseMax(c);
    if ((query - high).cwiseMax(low - query).maxCoeff() > 1.01 * std::max(seen.h, behind)) return std::nullopt;
    const Closest c = seen.closest = closest_of(facet, around, query);
    const double scale = std::max(query.cwiseAbs().maxCoeff(), c.point.cwiseAbs().maxCoeff());
    const double doubt = 1e-9 * (seen.h + 1e-3 * scale);
    if (c.distance > std::max(seen.h, behind) + doubt) return seen;
    bool in_plane = false;
    if (oriented(facet)) seen.behind = is_behind(facet, c, query, in_plane);
    const bool in_band = c.beyond_band <= 0;
    const bool may_be_behind = in_band && !(facet.solid && on_own_surface(facet, verdict.node));
    if (in_plane && (seen.h > c.distance || (may_be_behind && c.distance <= behind)))
      verdict.doubt = "in the plane of a segment";
    seen.hit = seen.behind ? in_band && c.distance <= behind : seen.h - c.distance > doubt;
    if (!seen.behind && std::abs(seen.h - c.distance) <= doubt) verdict.doubt = "touching";
    if (seen.behind && may_be_behind && std::abs(c.distance - behind) <= doubt)
      verdict.doubt = "as deep as a segment sees";
    if (rules_.free_edges_end && seen.hit && free_edges_.level_with_end(facet, c, around, query))
      verdict.doubt = "level with the end of an edge";
    if (rules_.free_edges_end && free_edges_.beside(facet, c)) seen.hit = false;
    if (!seen.hit) return seen;
    if (std::abs(c.beyond_band) < 1e-7) verdict.doubt = "on the border of the band";
    if (!c.certain) verdict.doubt = "no certain projection";
    if (c.distance < 1e-12 * scale) verdict.doubt = "on the segment";
    return seen;
  }

  /// Segments that share a node with the tracked one's elements, or to whose part it is tied, do not exist for it;
  /// shells share nodes with other shells and yet meet them.
  [[nodiscard]] bool left_out(const Facet& facet, std::int64_t node, const Ring& ring) const {
    return tied_.contains({node, facet.part}) || meets(facet, meets_own_sheet(facet) ? ring.without_shells : ring.all);
  }

  /// A node is behind a segment only if no other one of the body is nearer, however far that one sees; shells are one
  /// body (3.4).
  [[nodiscard]] bool behind_another(const Seen& hit, const Ring& neighbours, Verdict& verdict) const {
    const auto body = [](const Facet& f) { return f.solid ? f.part : 0; };
    const Vector& query = at(x_, verdict.node);
    for (const Facet& other : reference_.facets) {
      if (!oriented(other) || body(other) != body(*hit.facet) || left_out(other, verdict.node, neighbours)) continue;
      const double distance = closest_of(other, corners(other.nodes, x_), query).distance;
      const double less = hit.closest.distance - distance;
      if (less > 1e-9 * distance && less < 2e-9 * distance) verdict.doubt = "as near";
      if (less > 1e-9 * distance) return true;
    }
    return false;
  }

  [[nodiscard]] bool of_body(std::int64_t part, std::int64_t node) const {
    const auto& bricks = reference_.bodies.at(part).bricks;
    return std::any_of(bricks.begin(), bricks.end(), [&](const Element* brick) {
      return std::find(brick->nodes.begin(), brick->nodes.end(), node) != brick->nodes.end();
    });
  }

  /// Behind all faces of a brick, and not one of its corners.
  [[nodiscard]] bool inside(const Element& brick, std::int64_t node) const {
    if (std::find(brick.nodes.begin(), brick.nodes.end(), node) != brick.nodes.end()) return false;
    const auto faces = faces_of(brick, x_);
    return std::all_of(faces.begin(), faces.end(), [&](const Facet& face) {
      const Corners c = corners(face.nodes, x_);
      const Vector normal = (c[2] - c[0]).cross(c[3] - c[1]), middle = (c[0] + c[1] + c[2] + c[3]) / 4;
      return normal.dot(at(x_, node) - middle) < 0;
    });
  }

  /// 3.4: in contacts with two surfaces a corner of the body itself is on its surface, unless another element has it.
  [[nodiscard]] bool on_own_surface(const Facet& facet, std::int64_t node) const {
    return !rules_.single && of_body(facet.part, node) && !inside(*facet.brick, node);
  }

  /// Before a nearer outer face of the body that is no segment, or a corner of the body: outside (3.4).
  [[nodiscard]] bool outside(const Seen& hit, std::int64_t node, Verdict& verdict) const {
    if (!rules_.single && of_body(hit.facet->part, node)) return on_own_surface(*hit.facet, node);
    const Body& body = reference_.bodies.at(hit.facet->part);
    double nearest = hit.closest.distance;
    bool before = false, clamped = false;
    for (const Facet& face : body.faces) {
      if (std::any_of(reference_.facets.begin(), reference_.facets.end(),
                      [&](const Facet& f) { return f.element == face.element && f.nodes == face.nodes; }))
        continue;
      const Closest c = closest_of(face, corners(face.nodes, x_), at(x_, node));
      if (c.distance >= nearest * (1 - 1e-9)) continue;
      nearest = c.distance;
      before = c.normal.dot(at(x_, node) - c.point) >= 0;
      clamped = c.feature != Feature::face;
    }
    if (clamped) verdict.doubt = "beside a face that is no segment";
    return before;
  }

  /// A face of a brick along which a corner of another brick slides does not count (3.4); the reference leaves these
  /// nodes out.
  [[nodiscard]] bool may_slide(const Seen& seen, std::int64_t node) const {
    return seen.facet->solid && seen.closest.distance <= 1.01e-6 * shorter_diagonal(*seen.facet, x_) &&
           std::any_of(tracked_.facets.begin(), tracked_.facets.end(),
                       [&](const Facet& f) { return f.solid && f.has(node); });
  }

  [[nodiscard]] Verdict judge(std::int64_t node, double half) const {
    Verdict verdict;
    verdict.node = node;
    const auto neighbours = ring(node);
    std::vector<Seen> all;
    for (const Facet& facet : reference_.facets) {
      if (left_out(facet, node, neighbours)) continue;
      const auto seen = see(facet, half, verdict);
      if (!seen || (seen->closest.beyond_band > 0 && meets(facet, neighbours.all))) continue;
      all.push_back(*seen);
    }
    for (const Seen& seen : all) {
      if (!seen.hit) continue;
      if (seen.behind && behind_another(seen, neighbours, verdict)) continue;
      if (seen.behind && seen.facet->solid && outside(seen, node, verdict)) continue;
      choose(verdict, seen);
    }
    if (std::any_of(all.begin(), all.end(), [&](const Seen& s) { return may_slide(s, node); }))
      verdict.doubt = "next to a face of a brick";
    return verdict;
  }

  /// 3.4: the closest segment, those in whose band the node lies before others.
  void choose(Verdict& verdict, const Seen& seen) const {
    const Closest& c = seen.closest;
    const bool in_band = c.beyond_band <= 0;
    const double depth = seen.depth(), doubt = 1e-9 * (seen.h + 1e-3 * c.point.cwiseAbs().maxCoeff());
    if (verdict.found && in_band == verdict.in_band) {
      const bool tie = std::abs(c.distance - verdict.distance) <= 1e-9 * c.distance;
      if (tie && std::abs(depth - verdict.depth) <= doubt) return verdict.elements.push_back(seen.facet->element);
      if (tie) verdict.doubt = "two segments equally near";
      if (c.distance >= verdict.distance) return;
    }
    if (verdict.found && verdict.in_band && !in_band) return;
    const double limit = release_depth(rules_, *seen.facet, seen.h, x_);
    if (std::abs(depth - limit) <= doubt) verdict.doubt = "on the release limit";
    verdict.found = true;
    verdict.in_band = in_band;
    verdict.released = depth > limit;
    verdict.depth = depth, verdict.contact_distance = seen.h, verdict.distance = c.distance;
    const Vector away = at(x_, verdict.node) - c.point;
    verdict.direction = (seen.behind ? Vector(-away) : away).normalized();
    verdict.elements = {seen.facet->element};
  }

  const Scene& scene_;
  const Rules& rules_;
  const Side &tracked_, &reference_;
  const Positions& x_;
  const TiedPairs& tied_;
  Turns turned_;
  FreeEdges free_edges_;
};

/// 7.1
Outcome outcome_of(const Rules& rules) {
  const Contact& c = rules.contact;
  if (rules.by_segments) return Outcome::kept;
  const int ignore = c.mpp && c.mpp_ignore != 0 ? int(c.mpp_ignore) : c.ignore != 0 ? c.ignore : rules.controls.ignore;
  if (ignore != 0 && rules.kind.can(model::Ability::reads_ignore)) return Outcome::kept;
  return c.snlog == 1 ? Outcome::forced : Outcome::moved;
}

class Run {
 public:
  explicit Run(const Scene& scene) : scene_(scene), x_{Vector::Zero()} {
    for (const Node& node : scene.nodes) x_.push_back(node.x);
    for (const Element& e : scene.elements)
      if (scene.part(e.part).rigid) tie_state_.rigid.insert(e.nodes.begin(), e.nodes.end());
  }

  Findings all() {
    for (const Contact& contact : scene_.contacts)
      if (!judge(contact)) break;
    return std::move(findings_);
  }

 private:
  /// False if later coordinates are in doubt.
  bool judge(const Contact& contact) {
    const Rules rules(contact, scene_);
    using model::Treatment;
    // 7.6: the overlap of INTERFERENCE contacts is meant.
    if (rules.kind.ties() && !rules.single) return ties(rules);
    if (rules.kind.ties() || rules.kind.treatment == Treatment::none || rules.kind.family == model::Family::other ||
        rules.kind.can(model::Ability::interference))
      return true;
    findings_.judged.push_back(contact.id);
    // 1.2: EDGEONLY holds no nodes off segments.
    if (rules.kind.can(model::Ability::edges_only) && !rules.by_segments) return true;
    // 7.4, 7.5: segment against segment, both ways.
    const bool both_ways = !rules.single && (rules.two_way || rules.by_segments);
    // 7.3: both passes have the surfaces that the contact finds, with their boxes and thickness.
    const Side a = make_side(scene_, rules, Which::a, x_),
               b = rules.single ? a : make_side(scene_, rules, Which::b, x_);
    const bool sure = pass(rules, a, b);
    if (!both_ways) return sure;
    if (sure) return pass(rules, b, a);
    findings_.judged.pop_back();
    return false;
  }

  bool ties(const Rules& rules) {
    using model::TieForm;
    if (rules.kind.tie == TieForm::automatic_tied || rules.kind.tie == TieForm::weld) return true;
    const std::int64_t id = rules.contact.id;
    TieCounts counts{id, 0, 0, 0};
    bool sure = true;
    const std::vector<TieOutcome> outcomes = judge_ties(scene_, rules, tie_state_, x_);
    for (const TieOutcome& out : outcomes) {
      if (!out.doubt.empty()) findings_.doubts.push_back({id, out.node, out.doubt}), sure = false;
      counts.out_of_reach += out.out_of_reach;
      if (!out.judged) continue;
      ++(out.tied ? counts.ties : counts.untied);
      if (out.reason) findings_.tie_records.push_back({id, out.node, *out.reason, out.tied ? out.distance : -1});
      if (out.tied) tied_.insert({out.node, out.part});
      if (out.constrained) tie_state_.constrained.insert(out.node);
      if (out.moved) x_[static_cast<std::size_t>(out.node)] = out.target;
    }
    findings_.tie_counts.push_back(counts);
    findings_.judged.push_back(id);
    return sure;
  }

  bool pass(const Rules& rules, const Side& tracked, const Side& reference) {
    return settle(Pass(scene_, rules, tracked, reference, x_, tied_).run(), rules);
  }

  /// 12.1: one record per node and contact; one in a band goes before one outside (3.4).
  bool counts(std::int64_t contact, const Verdict& v) {
    const auto before = std::find_if(findings_.records.begin(), findings_.records.end(),
                                     [&](const Record& r) { return r.contact == contact && r.node == v.node; });
    if (before == findings_.records.end()) return true;
    if (before->kind != PenetrationKind::edge_zone || !v.in_band) return false;
    findings_.records.erase(before);
    return true;
  }

  /// Writes the verdicts down and moves the nodes, all together. Returns false if a doubtful one may have moved.
  bool settle(const std::vector<Verdict>& verdicts, const Rules& rules) {
    bool sure = true;
    for (const Verdict& v : verdicts) {
      const Contact& c = rules.contact;
      Outcome outcome = outcome_of(rules);
      if (!v.doubt.empty()) {
        findings_.doubts.push_back({c.id, v.node, v.doubt});
        sure = sure && outcome != Outcome::moved;
      }
      if (!v.found || (rules.by_segments && !v.in_band)) continue;
      if (!counts(c.id, v)) continue;
      PenetrationKind kind = PenetrationKind::initial;
      if (c.mortar)
        kind = PenetrationKind::mortar;
      else if (rules.by_segments)
        kind = PenetrationKind::segment;
      else if (!v.in_band)
        kind = PenetrationKind::edge_zone, outcome = Outcome::reported;
      else if (v.released)
        kind = PenetrationKind::released, outcome = Outcome::released;
      findings_.records.push_back({c.id, v.node, kind, outcome, v.depth, v.contact_distance, v.elements});
      if (outcome == Outcome::moved) x_[static_cast<std::size_t>(v.node)] += 1.002 * v.depth * v.direction;  // 12.1
    }
    return sure;
  }

  const Scene& scene_;
  Positions x_;
  TiedPairs tied_;
  TieState tie_state_;
  Findings findings_;
};

}  // namespace

Findings find_penetrations(const Scene& scene) { return Run(scene).all(); }

}  // namespace gapcheck::reference
