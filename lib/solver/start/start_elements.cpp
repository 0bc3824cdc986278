#include "solver/start/start_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contact/surface/element_fate.hpp"
#include "contact/surface/segment_quality.hpp"
#include "model/entity/faces.hpp"

namespace gapcheck::solver {
namespace {

using model::ElementKind;
using Shape = StartElement::Shape;

/// From here on a change of an edge ratio or step counts, relative to it; and one of warp, in degrees.
constexpr double visible_change = 0.01, visible_warp = 1;

/// Edges between corners that are not one node.
contact::EdgeRange solid_edges(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x) {
  contact::EdgeRange range{std::numeric_limits<double>::infinity(), 0};
  for (const model::SegmentNodes& face : model::SolidFaces(nodes))
    for (std::size_t k = 0; k < 4; ++k) {
      const NodeIndex a = face[k], b = face[(k + 1) % 4];
      if (a == b) continue;
      const double length = (x[a.value] - x[b.value]).norm();
      range.shortest = std::min(range.shortest, length);
      range.longest = std::max(range.longest, length);
    }
  return range;
}

double ratio(const contact::EdgeRange& edges) {
  return edges.shortest > 0 ? edges.longest / edges.shortest : std::numeric_limits<double>::infinity();
}

Shape shell_shape(const std::array<NodeIndex, 4>& nodes, const std::vector<Vector>& x, double size) {
  const contact::SegmentQuality quality = contact::segment_quality(nodes, x);
  const double warp = quality.fault == contact::SegmentFault::none ? contact::warp_degrees(quality) : 0;
  return {ratio(contact::edge_range(nodes, x)), warp, size};
}

/// Whether the second value is larger by more than it takes to see it; infinities are equal.
bool grown(double before, double after) { return after > before * (1 + visible_change); }

bool visibly_changed(const Shape& before, const Shape& after) {
  return grown(before.edge_ratio, after.edge_ratio) || grown(after.edge_ratio, before.edge_ratio) ||
         std::abs(after.warp - before.warp) > visible_warp || grown(before.step, after.step) ||
         grown(after.step, before.step);
}

/// Share of the step that is left; 1 where there is none.
double step_left(const StartElement& element) {
  return std::isfinite(element.before.step) && element.before.step > 0 ? element.after.step / element.before.step : 1;
}

template <class Elements>
void set_names(StartElement& element, const model::Model& model, const Elements& elements, std::uint32_t i) {
  element.id = elements.id[i];
  if (elements.part[i] != none<PartIndex>) element.part = model.part(elements.part[i]).id.value;
}

}  // namespace

std::vector<StartElements::Key> StartElements::elements_at(std::span<const NodeIndex> moved) {
  std::vector<Key> keys;
  const auto add = [&](ElementKind kind, contact::ElementIndex& index) {
    for (const NodeIndex node : moved)
      for (const std::uint32_t i : index.at(node)) keys.emplace_back(kind, i);
  };
  add(ElementKind::shell, index_.shells);
  add(ElementKind::solid, index_.solids);
  add(ElementKind::thick_shell, index_.thick_shells);
  add(ElementKind::beam, index_.beams);
  std::ranges::sort(keys);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

StartElement StartElements::measure(const Key& key) const {
  const auto kind = key.first;
  const auto i = key.second;
  const model::Mesh& mesh = model_.mesh;
  const std::vector<Vector>& deck = mesh.nodes.x;
  StartElement e;
  const auto set_fate = [&](const contact::ElementFate& fate) {
    e.inverted = fate.inverted;
    e.flat = fate.flat;
    return fate;
  };
  const auto solid = [&](const model::Elements<8>& elements, std::string_view word) {
    const auto& nodes = elements.nodes[i];
    e.kind = word;
    set_names(e, model_, elements, i);
    const contact::ElementFate fate = set_fate(contact::element_fate(nodes, deck, start_));
    e.before = {ratio(solid_edges(nodes, deck)), 0, fate.before};
    e.after = {ratio(solid_edges(nodes, start_)), 0, fate.after};
  };
  if (kind == ElementKind::shell) {
    const auto& nodes = mesh.shells.nodes[i];
    e.kind = "shell";
    set_names(e, model_, mesh.shells, i);
    const contact::ElementFate fate = set_fate(contact::element_fate(nodes, deck, start_));
    e.before = shell_shape(nodes, deck, fate.before);
    e.after = shell_shape(nodes, start_, fate.after);
  } else if (kind == ElementKind::solid) {
    solid(mesh.solids, "solid");
  } else if (kind == ElementKind::thick_shell) {
    solid(mesh.thick_shells, "thick shell");
  } else {
    const auto& [a, b] = mesh.beams.nodes[i];
    e.kind = "beam";
    set_names(e, model_, mesh.beams, i);
    e.before.size = (deck[b.value] - deck[a.value]).norm();
    e.after.size = (start_[b.value] - start_[a.value]).norm();
    e.flat = e.before.size > 0 && e.after.size < contact::flattened_element * e.before.size;
  }
  e.before.step = step_(kind, i, deck);
  e.after.step = step_(kind, i, start_);
  return e;
}

std::vector<StartElement> StartElements::list_changed(std::span<const NodeIndex> moved,
                                                      const std::map<NodeIndex, std::int64_t>& mover) {
  std::vector<std::pair<Key, StartElement>> found;
  const auto name_mover = [&](std::span<const NodeIndex> nodes, StartElement& element) {
    double farthest = 0;
    for (const NodeIndex n : nodes) {
      const double way = (start_[n.value] - model_.mesh.nodes.x[n.value]).norm();
      const auto who = mover.find(n);
      if (who == mover.end() || way <= farthest) continue;
      farthest = way;
      element.contact = who->second;
    }
  };
  for (const Key& key : elements_at(moved)) {
    StartElement element = measure(key);
    if (!element.collapsed() && !visibly_changed(element.before, element.after)) continue;
    const model::Mesh& mesh = model_.mesh;
    switch (key.first) {
      case ElementKind::shell:
        name_mover(mesh.shells.nodes[key.second], element);
        break;
      case ElementKind::solid:
        name_mover(mesh.solids.nodes[key.second], element);
        break;
      case ElementKind::thick_shell:
        name_mover(mesh.thick_shells.nodes[key.second], element);
        break;
      default:
        name_mover(mesh.beams.nodes[key.second], element);
    }
    found.emplace_back(key, element);
  }
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) {
    if (a.second.collapsed() != b.second.collapsed()) return a.second.collapsed();
    return step_left(a.second) < step_left(b.second);
  });
  for (const auto& [key, element] : found) {
    listed_[key] = list_.size();
    list_.push_back(element);
  }
  return list_;
}

StartShapes StartElements::shapes_at(std::span<const NodeIndex> moved) {
  StartShapes shapes;
  for (const Key& key : elements_at(moved)) {
    ++shapes.touched;
    const auto place = listed_.find(key);
    if (place == listed_.end()) continue;
    const std::size_t i = place->second;
    const StartElement& element = list_[i];
    ++shapes.changed;
    shapes.collapsed += element.collapsed();
    const auto take = [&](std::optional<std::size_t>& worst, bool worse, const auto& value) {
      if (worse && (!worst || value(element) > value(list_[*worst]))) worst = i;
    };
    take(shapes.edge_ratio, grown(element.before.edge_ratio, element.after.edge_ratio),
         [](const StartElement& e) { return e.after.edge_ratio; });
    take(shapes.warp, element.after.warp > element.before.warp + visible_warp,
         [](const StartElement& e) { return e.after.warp; });
    take(shapes.step, grown(element.after.step, element.before.step),
         [](const StartElement& e) { return -e.after.step; });
  }
  return shapes;
}

}  // namespace gapcheck::solver
