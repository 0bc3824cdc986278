#include "solver/output/section_cuts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "model/entity/faces.hpp"
#include "solver/condition/section_plane.hpp"

namespace gapcheck::solver {
namespace {

using Cut = CutSection;

constexpr std::array<std::array<std::uint8_t, 2>, 12> brick_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<std::array<std::uint8_t, 4>, 6> brick_faces{
    {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
constexpr std::array<std::array<std::uint8_t, 3>, 4> tetrahedron_faces{{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

template <std::size_t N>
constexpr Cut::Kind kind_of() {
  return N == 8 ? Cut::Kind::solid : N == 4 ? Cut::Kind::shell : Cut::Kind::beam;
}

/// How many corners carry forces: four of a tetrahedron, all of any other element.
template <std::size_t N>
std::size_t corners_of(const std::array<NodeIndex, N>& nodes) {
  if constexpr (N == 8) return model::is_tetrahedron(nodes) ? 4 : 8;
  return N;
}

/// Finds what one section cuts.
class SectionCutter {
 public:
  SectionCutter(const model::Model& model, Cut& cut)
      : model_(model), section_(model.cross_sections[cut.section]), cut_(cut) {}

  void find() {
    if (section_.system != 0)
      return fail(fmt::format("its local system or rigid body (ID = {}, ITYPE = {}) is not calculated", section_.system,
                              section_.kind_of_system));
    section_.plane ? cut_by_plane() : cut_by_sets();
    if (cut_.fault.empty() && cut_.empty()) fail("it has no deformable elements");
  }

 private:
  void fail(std::string why) { cut_.fault = std::move(why); }
  [[nodiscard]] const Vector& x(NodeIndex node) const { return model_.mesh.nodes.x[node.value]; }
  template <std::size_t N>
  [[nodiscard]] bool deformable(const model::Elements<N>& elements, std::size_t i) const {
    const PartIndex part = elements.part[i];
    if (part.value >= model_.parts.size() || model_.rigid(part)) return false;
    const auto missing = [&](NodeIndex node) { return node.value >= model_.mesh.nodes.size(); };
    return std::none_of(elements.nodes[i].begin(), elements.nodes[i].end(), missing);
  }

  void cut_by_plane() {
    if (const std::string fault = SectionPlane::fault(section_); !fault.empty()) return fail(fault);
    const SectionPlane plane(section_);
    std::vector<bool> wanted(model_.parts.size(), section_.parts == 0);
    if (section_.parts != 0) {
      const auto set = model_.sets.parts.find(section_.parts);
      if (set == model_.sets.parts.end()) return fail(fmt::format("part set {} is not defined", section_.parts));
      for (const PartIndex part : set->second.members) wanted[part.value] = true;
    }
    add_cut(model_.mesh.shells, plane, wanted);
    add_cut(model_.mesh.solids, plane, wanted);
    add_cut(model_.mesh.beams, plane, wanted);
  }

  template <std::size_t N>
  void add_cut(const model::Elements<N>& elements, const SectionPlane& plane, const std::vector<bool>& wanted) {
    const auto place = [&](NodeIndex node) -> const Vector& { return x(node); };
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      const auto& nodes = elements.nodes[i];
      if (!deformable(elements, i) || !wanted[elements.part[i].value] || !plane.parts(nodes, place)) continue;
      Cut::Patch patch{kind_of<N>(), i, cut_points(nodes, plane)};
      const auto outside = [&](const Cut::EdgePoint& p) { return !plane.within(x(p.a) + p.share * (x(p.b) - x(p.a))); };
      if (std::any_of(patch.points.begin(), patch.points.end(), outside)) continue;
      unsigned bits = 0;
      for (std::size_t k = 0; k < corners_of(nodes); ++k)
        if (!(plane.ahead(x(nodes[k])) > 0)) bits |= 1u << k;
      add({i, static_cast<std::uint8_t>(bits)}, kind_of<N>());
      cut_.patches.push_back(std::move(patch));
    }
  }

  /// Where the plane crosses the edges; of solids in order around the polygon.
  template <std::size_t N>
  std::vector<Cut::EdgePoint> cut_points(const std::array<NodeIndex, N>& nodes, const SectionPlane& plane) const {
    std::vector<Cut::EdgePoint> points;
    const auto cross = [&](NodeIndex a, NodeIndex b) {
      const double before = plane.ahead(x(a)), behind = plane.ahead(x(b));
      if ((before > 0) != (behind > 0)) points.push_back({a, b, before / (before - behind)});
    };
    if constexpr (N == 8)
      for (const auto& [a, b] : brick_edges) cross(nodes[a], nodes[b]);
    else
      for (std::size_t k = 0; k < (N == 2 ? 1 : N); ++k) cross(nodes[k], nodes[(k + 1) % N]);
    if (N == 4 && points.size() > 2) points.resize(2);
    if (N == 8) sort_around(plane.normal(), points);
    return points;
  }

  void sort_around(const Vector& normal, std::vector<Cut::EdgePoint>& points) const {
    const auto place = [&](const Cut::EdgePoint& p) { return Vector(x(p.a) + p.share * (x(p.b) - x(p.a))); };
    Vector mean = Vector::Zero();
    for (const Cut::EdgePoint& p : points) mean += place(p) / static_cast<double>(points.size());
    const Vector first = normal.unitOrthogonal(), second = normal.cross(first);
    const auto angle = [&](const Cut::EdgePoint& p) {
      return std::atan2((place(p) - mean).dot(second), (place(p) - mean).dot(first));
    };
    std::stable_sort(points.begin(), points.end(),
                     [&](const Cut::EdgePoint& a, const Cut::EdgePoint& b) { return angle(a) < angle(b); });
  }

  void cut_by_sets() {
    const auto set = model_.sets.nodes.find(section_.nodes);
    if (set == model_.sets.nodes.end()) return fail(fmt::format("node set {} (NSID) is not defined", section_.nodes));
    if (section_.others != 0)
      return fail("forces of thick shells and discrete elements (TSID, DSID) are not in it; remove them");
    nodes_.assign(set->second.members.begin(), set->second.members.end());
    std::sort(nodes_.begin(), nodes_.end());
    add_set(model_.mesh.shells, model_.sets.shells, section_.shells, "SSID");
    add_set(model_.mesh.solids, model_.sets.solids, section_.solids, "HSID");
    add_set(model_.mesh.beams, model_.sets.beams, section_.beams, "BSID");
  }

  [[nodiscard]] bool chosen(NodeIndex node) const { return std::binary_search(nodes_.begin(), nodes_.end(), node); }

  template <std::size_t N, class ElementSets>
  void add_set(const model::Elements<N>& elements, const ElementSets& sets, std::int64_t id, std::string_view field) {
    if (id == 0) return;
    const auto set = sets.find(id);
    if (set == sets.end()) return fail(fmt::format("its set of elements {} ({}) is not defined", id, field));
    for (const std::uint32_t i : set->second.members) {
      if (!deformable(elements, i)) continue;
      const auto& nodes = elements.nodes[i];
      unsigned bits = 0;
      for (std::size_t k = 0; k < corners_of(nodes); ++k)
        if (chosen(nodes[k])) bits |= 1u << k;
      if (bits == 0) continue;
      add({i, static_cast<std::uint8_t>(bits)}, kind_of<N>());
      add_faces(nodes, i);
    }
  }

  /// The faces, edges or ends whose nodes are all in the set.
  template <std::size_t N>
  void add_faces(const std::array<NodeIndex, N>& nodes, std::uint32_t element) {
    const auto add_patch = [&](const auto& corners) {
      Cut::Patch patch{kind_of<N>(), element, {}};
      for (const auto k : corners)
        if (!chosen(nodes[k])) return;
      for (const auto k : corners) patch.points.push_back({nodes[k], nodes[k], 0});
      cut_.patches.push_back(std::move(patch));
    };
    if constexpr (N == 8) {
      if (model::is_tetrahedron(nodes))
        for (const auto& face : tetrahedron_faces) add_patch(face);
      else
        for (const auto& face : brick_faces) add_patch(face);
    }
    if constexpr (N == 4)
      for (std::size_t k = 0; k < 4; ++k)
        if (nodes[k] != nodes[(k + 1) % 4]) add_patch(std::array<std::size_t, 2>{k, (k + 1) % 4});
    if constexpr (N == 2)
      for (std::size_t k = 0; k < 2; ++k) add_patch(std::array<std::size_t, 1>{k});
  }

  void add(Cut::Element element, Cut::Kind kind) { cut_.elements[static_cast<std::size_t>(kind)].push_back(element); }

  const model::Model& model_;
  const model::CrossSection& section_;
  Cut& cut_;
  std::vector<NodeIndex> nodes_;  ///< of the set, ascending
};

}  // namespace

std::vector<CutSection> section_cuts(const model::Model& model) {
  std::vector<CutSection> cuts(model.cross_sections.size());
  parallel_for(cuts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      cuts[i].section = static_cast<std::uint32_t>(i);
      SectionCutter(model, cuts[i]).find();
    }
  });
  return cuts;
}

}  // namespace gapcheck::solver
