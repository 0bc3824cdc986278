#include "reference/penetration_reference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "reference/closest.hpp"

namespace gapcheck::reference {
namespace {

using model::Model;
using Positions = std::vector<Vector>;

struct Facet {
  std::array<NodeIndex, 4> nodes;
  bool triangle = false, solid = false;
  double half = 0;   ///< half the contact thickness
  double depth = 0;  ///< solids: volume / area
  PartIndex part = none<PartIndex>;
};

/// One side of a contact: facets to be met, nodes that are tracked (with half their thickness), bricks with an inside.
struct Side {
  std::vector<Facet> facets;
  std::map<NodeIndex, double> nodes;
  std::vector<std::pair<std::array<NodeIndex, 8>, PartIndex>> bricks;
  std::vector<std::vector<NodeIndex>> elements;
};

struct Thickness {
  double override_value = 0, scale = 1;
  bool edge_limit = false;
};

constexpr int brick_faces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

bool has(const std::array<NodeIndex, 4>& nodes, NodeIndex node) {
  return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

double own_thickness(const Model& model, std::uint32_t shell) {
  const auto& part = model.part(model.mesh.shells.part[shell]);
  std::array<double, 4> t = model.sections[*part.section].thickness;
  for (const auto& own : model.mesh.shells.own_thickness) {
    if (own.shell != shell) continue;
    for (std::size_t i = 0; i < 4; ++i) t[i] = own.thickness[i] > 0 ? own.thickness[i] : t[i];
  }
  return (t[0] + t[1] + t[2] + t[3]) / 4;
}

double shell_thickness(const Model& model, std::uint32_t shell, const Thickness& rule, const Positions& x) {
  const auto& part = model.part(model.mesh.shells.part[shell]);
  if (part.contact && part.contact->optt > 0) return part.contact->optt;
  if (rule.override_value > 0) return rule.override_value;
  if (model.controls.th > 0) return model.controls.th;
  double t = own_thickness(model, shell) * rule.scale;
  if (part.contact && part.contact->sft > 0) t *= part.contact->sft;
  if (!rule.edge_limit) return t;
  const auto& n = model.mesh.shells.nodes[shell];
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 4; ++i) {
    const double length = (x[n[(i + 1) % 4].value] - x[n[i].value]).norm();
    if (n[i] != n[(i + 1) % 4]) shortest = std::min(shortest, length);
  }
  return std::min(t, 0.4 * shortest);
}

Corners corners(const std::array<NodeIndex, 4>& nodes, const Positions& x) {
  return {x[nodes[0].value], x[nodes[1].value], x[nodes[2].value], x[nodes[3].value]};
}

Vector middle(const std::array<NodeIndex, 8>& nodes, const Positions& x) {
  Vector sum = Vector::Zero();
  for (NodeIndex n : nodes) sum += x[n.value];
  return sum / 8;
}

double facet_area(const Corners& c) {
  return 0.5 * ((c[1] - c[0]).cross(c[2] - c[0]).norm() + (c[2] - c[0]).cross(c[3] - c[0]).norm());
}

/// Volume as the sum of pyramids from the middle over all faces, each face as two triangles.
double brick_volume(const std::array<NodeIndex, 8>& nodes, const Positions& x) {
  const Vector m = middle(nodes, x);
  double volume = 0;
  for (const auto& face : brick_faces) {
    std::array<Vector, 4> c;
    for (std::size_t i = 0; i < 4; ++i) c[i] = x[nodes[static_cast<std::size_t>(face[i])].value] - m;
    volume += std::abs(c[0].dot(c[1].cross(c[2]))) / 6 + std::abs(c[0].dot(c[2].cross(c[3]))) / 6;
  }
  return volume;
}

void add_shells(Side& side, const Model& model, const std::set<PartIndex>& parts, const Thickness& rule,
                const Positions& x) {
  const auto& shells = model.mesh.shells;
  for (std::uint32_t e = 0; e < shells.size(); ++e) {
    if (!parts.contains(shells.part[e])) continue;
    const double half = shell_thickness(model, e, rule, x) / 2;
    const auto& n = shells.nodes[e];
    side.facets.push_back({n, n[2] == n[3], false, half, 0, shells.part[e]});
    side.elements.emplace_back(n.begin(), n.end());
    for (NodeIndex node : n) side.nodes[node] = std::max(side.nodes[node], half);
  }
}

void add_solids(Side& side, const Model& model, const std::set<PartIndex>& parts, const Positions& x) {
  const auto& solids = model.mesh.solids;
  std::map<std::array<NodeIndex, 4>, std::vector<Facet>> faces;
  for (std::uint32_t e = 0; e < solids.size(); ++e) {
    if (!parts.contains(solids.part[e])) continue;
    const auto& n = solids.nodes[e];
    side.bricks.emplace_back(n, solids.part[e]);
    side.elements.emplace_back(n.begin(), n.end());
    const double volume = brick_volume(n, x);
    for (const auto& face : brick_faces) {
      Facet facet;
      for (std::size_t i = 0; i < 4; ++i) facet.nodes[i] = n[static_cast<std::size_t>(face[i])];
      facet.solid = true;
      facet.part = solids.part[e];
      facet.depth = volume / facet_area(corners(facet.nodes, x));
      auto key = facet.nodes;
      std::sort(key.begin(), key.end());
      faces[key].push_back(facet);
    }
  }
  for (const auto& [key, owners] : faces) {
    if (owners.size() > 1) continue;
    side.facets.push_back(owners.front());
    for (NodeIndex node : key) side.nodes.try_emplace(node, 0.0);
  }
}

std::set<PartIndex> parts_of(const Model& model, const model::SurfaceInput& input) {
  std::set<PartIndex> parts;
  const auto type = static_cast<model::SurfaceType>(input.type);
  if (type == model::SurfaceType::all || input.id == 0) {
    for (const auto& [id, index] : model.part_of_id) parts.insert(index);
  } else if (type == model::SurfaceType::part) {
    if (const auto found = model.part_of_id.find(input.id); found != model.part_of_id.end())
      parts.insert(found->second);
  } else if (type == model::SurfaceType::part_set) {
    if (const auto set = model.sets.parts.find(input.id); set != model.sets.parts.end())
      parts.insert(set->second.members.begin(), set->second.members.end());
  }
  return parts;
}

Side make_side(const Model& model, const model::SurfaceInput& input, const Thickness& rule, const Positions& x) {
  Side side;
  const auto parts = parts_of(model, input);
  add_shells(side, model, parts, rule, x);
  add_solids(side, model, parts, x);
  return side;
}

enum class Where { outside, unsure, inside };

/// Against the mean plane of every face; within the warp of a face nothing is said.
Where where(const std::array<NodeIndex, 8>& brick, const Vector& query, const Positions& x) {
  const Vector m = middle(brick, x);
  Where result = Where::inside;
  for (const auto& face : brick_faces) {
    std::array<Vector, 4> c;
    for (std::size_t i = 0; i < 4; ++i) c[i] = x[brick[static_cast<std::size_t>(face[i])].value];
    const Vector origin = (c[0] + c[1] + c[2] + c[3]) / 4;
    Vector outward = (c[2] - c[0]).cross(c[3] - c[1]).normalized();
    if (outward.dot(m - origin) > 0) outward = -outward;
    double warp = 1e-9 * (c[2] - c[0]).norm();
    for (const Vector& corner : c) warp = std::max(warp, 1.01 * std::abs(outward.dot(corner - origin)));
    const double height = outward.dot(query - origin);
    if (height > warp) return Where::outside;
    if (height > -warp) result = Where::unsure;
  }
  return result;
}

struct Verdict {
  NodeIndex node;
  bool found = false, doubtful = false;
  PenetrationKind kind = PenetrationKind::edge_zone;
  double depth = 0, contact_distance = 0, distance = 1e300;
  Vector direction = Vector::Zero();
};

struct Pass {
  const Model& model;
  const Side &tracked, &reference;
  bool single_surface;
  double penmax;
  const Positions& x;

  /// The elements of the node and the segment have a node in common.
  [[nodiscard]] bool in_ring(NodeIndex node, const Facet& facet) const {
    if (has(facet.nodes, node)) return true;
    if (!single_surface) return false;
    return std::any_of(tracked.elements.begin(), tracked.elements.end(), [&](const auto& element) {
      return std::find(element.begin(), element.end(), node) != element.end() &&
             std::any_of(element.begin(), element.end(), [&](NodeIndex n) { return has(facet.nodes, n); });
    });
  }

  /// Where the node lies to the bricks of each part that has any near; parts that are left out: outside.
  [[nodiscard]] std::map<PartIndex, Where> volumes(NodeIndex node) const {
    std::map<PartIndex, Where> result;
    for (const auto& [brick, part] : reference.bricks) {
      if (std::find(brick.begin(), brick.end(), node) != brick.end()) continue;
      const Where place = where(brick, x[node.value], x);
      if (place != Where::outside) result[part] = std::max(result[part], place);
    }
    return result;
  }

  [[nodiscard]] double release_limit(const Facet& facet, double h) const {
    if (!facet.solid) return (penmax > 0 ? penmax : 0.4) * 2 * h;
    return (penmax > 0 ? penmax : 0.5) * (single_surface ? 0.4 : 1.0) * facet.depth;
  }

  void consider(Verdict& verdict, const Facet& facet, double node_half, bool in_solid) const {
    const Vector& query = x[verdict.node.value];
    const Closest c = closest(corners(facet.nodes, x), facet.triangle, query);
    const bool buried = in_solid && facet.solid;
    const double h = node_half + facet.half, depth = buried ? h + c.distance : h - c.distance;
    const double scale = std::max(query.cwiseAbs().maxCoeff(), c.point.cwiseAbs().maxCoeff());
    const double doubt = 1e-9 * (h + 1e-3 * scale);
    // Next to a face of a solid the rules ask whether the node slides along it; this reference does not know.
    const auto diagonal = [&](std::size_t i, std::size_t k) {
      return (x[facet.nodes[k].value] - x[facet.nodes[i].value]).norm();
    };
    if (facet.solid && c.distance <= 0.0101 * std::min(diagonal(0, 2), diagonal(1, 3))) verdict.doubtful = true;
    if (depth < -doubt) return;
    if (std::abs(depth) <= doubt || std::abs(c.beyond_band) < 1e-7 || !c.certain || c.distance < 1e-12 * scale)
      verdict.doubtful = true;
    if (depth <= 1e-9 * h) return;
    const double limit = release_limit(facet, h);
    const PenetrationKind kind = c.beyond_band > 0 ? PenetrationKind::edge_zone
                                 : depth > limit   ? PenetrationKind::released
                                                   : PenetrationKind::initial;
    if (std::abs(depth - limit) <= doubt) verdict.doubtful = true;
    const bool in_band = kind != PenetrationKind::edge_zone;
    const bool had_band = verdict.found && verdict.kind != PenetrationKind::edge_zone;
    if (verdict.found && in_band == had_band) {
      // Which of two segments equally near comes first is not a matter of the rules.
      const bool tie = std::abs(c.distance - verdict.distance) <= doubt;
      if (tie && (kind != verdict.kind || std::abs(depth - verdict.depth) > doubt)) verdict.doubtful = true;
      if (c.distance >= verdict.distance) return;
    }
    if (had_band && !in_band) return;
    verdict.found = true;
    verdict.kind = kind;
    verdict.depth = depth, verdict.contact_distance = h, verdict.distance = c.distance;
    verdict.direction = (buried ? c.point - query : query - c.point).normalized();
  }

  [[nodiscard]] std::vector<Verdict> run() const {
    std::vector<Verdict> verdicts;
    for (const auto& [node, half] : tracked.nodes) {
      Verdict verdict;
      verdict.node = node;
      const auto places = volumes(node);
      for (const auto& [part, place] : places) verdict.doubtful |= place == Where::unsure;
      for (const Facet& facet : reference.facets) {
        if (!in_ring(node, facet))
          consider(verdict, facet, half, places.contains(facet.part) && places.at(facet.part) == Where::inside);
      }
      if (verdict.found || verdict.doubtful) verdicts.push_back(verdict);
    }
    return verdicts;
  }
};

Outcome outcome_of(const model::Contact& contact, const model::Controls& controls) {
  const std::int64_t ignore = contact.mpp_ignore.value_or(contact.ignore.value_or(controls.ignore));
  return ignore != 0 ? Outcome::kept : contact.snlog == 1 ? Outcome::forced : Outcome::moved;
}

/// Writes the verdicts down and moves the nodes, all together. Returns false if a doubtful one may have moved.
bool settle(const std::vector<Verdict>& verdicts, const model::Contact& contact, const Model& model, Findings& findings,
            Positions& x) {
  const Outcome outcome = outcome_of(contact, model.controls);
  bool sure = true;
  for (const Verdict& v : verdicts) {
    const std::int64_t id = model.mesh.nodes.id[v.node.value];
    if (v.doubtful) {
      findings.doubts.push_back({contact.id.value, id});
      sure = sure && outcome != Outcome::moved;
    }
    if (!v.found) continue;
    const Outcome own = v.kind == PenetrationKind::edge_zone  ? Outcome::reported
                        : v.kind == PenetrationKind::released ? Outcome::released
                                                              : outcome;
    findings.records.push_back({contact.id.value, id, v.kind, own, v.depth, v.contact_distance});
    if (own == Outcome::moved) x[v.node.value] += 1.002 * v.depth * v.direction;
  }
  return sure;
}

/// False if later coordinates are in doubt.
bool judge(const Model& model, const model::Contact& contact, Findings& findings, Positions& x) {
  const bool single = contact.keyword == "CONTACT_AUTOMATIC_SINGLE_SURFACE";
  const bool two_way = contact.keyword == "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE";
  const Thickness rule_a{contact.sst, contact.sfst, single && model.controls.ssthk == 0};
  const Thickness rule_b{contact.mst, contact.sfmt, false};
  const auto pass = [&](bool a_is_tracked) {
    const Side a = make_side(model, contact.a, rule_a, x), b = single ? a : make_side(model, contact.b, rule_b, x);
    const Pass work{model, a_is_tracked ? a : b, a_is_tracked ? b : a, single, contact.penmax, x};
    return settle(work.run(), contact, model, findings, x);
  };
  findings.judged.push_back(contact.id.value);
  const bool sure = pass(true);
  if (!two_way || single) return sure;
  if (sure) return pass(false);
  findings.judged.pop_back();
  return false;
}

}  // namespace

Findings find_penetrations(const Model& model) {
  static const std::set<std::string> covered{"CONTACT_AUTOMATIC_SINGLE_SURFACE", "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE",
                                             "CONTACT_AUTOMATIC_NODES_TO_SURFACE",
                                             "CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"};
  Findings findings;
  Positions x = model.mesh.nodes.x;
  for (const auto& contact : model.contacts) {
    if (!covered.contains(contact.keyword) || contact.soft == 2) continue;
    if (!judge(model, contact, findings, x)) break;
  }
  return findings;
}

}  // namespace gapcheck::reference
