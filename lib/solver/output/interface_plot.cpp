#include "solver/output/interface_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/contact/contact_method.hpp"

namespace gapcheck::solver {
namespace {

model::SegmentNodes sorted_corners(model::SegmentNodes nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

std::array<double, 3> components(const Vector& v) { return {v.x(), v.y(), v.z()}; }

/// A contact that holds its nodes can pull.
bool pulls(const ContactView& view) {
  const std::vector<ContactNode> nodes = view.nodes();
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const ContactNode& node) { return node.kind == ContactNode::Kind::tied; });
}

}  // namespace

/// Of a segment at the present time.
struct InterfacePlot::Geometry {
  Vector normal = Vector::Zero(), r = Vector::Zero(), s = Vector::Zero();  ///< unit vectors
  double area = 0;

  Geometry(const model::SegmentNodes& nodes, const std::vector<Vector>& x) {
    const auto at = [&](std::size_t i) -> const Vector& { return x[nodes[i].value]; };
    const Vector across = (at(2) - at(0)).cross(at(3) - at(1));
    area = across.norm() / 2;
    if (!(area > 0)) return;
    normal = across / (2 * area);
    r = at(1) + at(2) - at(0) - at(3);
    r -= r.dot(normal) * normal;
    const double length = r.norm();
    if (length > 0) r /= length;
    s = normal.cross(r);
  }
};

/// Adds up the forces on the segments of one surface.
class InterfacePlot::Distribution {
 public:
  Distribution(const InterfacePlot& plot, const Surface& surface, const std::vector<Vector>& x,
               results::InterfaceForces& state)
      : plot_(plot), surface_(surface), x_(x), state_(state) {}

  void add(const ContactPoint& point, const Vector& force) {
    std::array<NodeIndex, 4> used{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (point.weights[i] != 0) used[count++] = point.nodes[i];
    if (const auto whole = surface_.by_corners.find(sorted_corners(point.nodes));
        count > 1 && whole != surface_.by_corners.end())
      return add_to(whole->second, point, force);
    const std::vector<std::uint32_t> common = segments_at({used.data(), count});
    if (count > 1 && common.empty()) {
      // No segment has all of them: every node on its own.
      for (std::size_t i = 0; i < 4; ++i)
        if (point.weights[i] != 0) add({{point.nodes[i]}, {1}}, point.weights[i] * force);
      return;
    }
    double area = 0;
    for (const std::uint32_t segment : common) area += area_of(segment);
    if (!(area > 0)) return;
    for (const std::uint32_t segment : common) add_to(segment, point, area_of(segment) / area * force);
  }

  /// Pressures and shear stresses of the forces so far. `signed_pressure`: pulling is negative.
  void finish(bool signed_pressure) {
    for (std::size_t i = surface_.first; i < surface_.end; ++i) {
      const Geometry at(plot_.corners_[i], x_);
      results::SegmentForce& segment = state_.segments[i];
      Vector force = Vector::Zero();
      for (const auto& corner : segment.force) force += Vector(corner[0], corner[1], corner[2]);
      if (!(at.area > 0)) continue;
      const double normal = force.dot(at.normal);
      segment.pressure = (signed_pressure ? -normal : std::abs(normal)) / at.area;
      segment.shear = (force - normal * at.normal).norm() / at.area;
      segment.shear_r = force.dot(at.r) / at.area;
      segment.shear_s = force.dot(at.s) / at.area;
    }
  }

 private:
  [[nodiscard]] double area_of(std::uint32_t segment) const { return Geometry(plot_.corners_[segment], x_).area; }

  [[nodiscard]] std::vector<std::uint32_t> segments_at(std::span<const NodeIndex> nodes) const {
    std::vector<std::uint32_t> list;
    if (nodes.empty()) return list;
    if (const auto found = surface_.by_node.find(nodes[0]); found != surface_.by_node.end()) list = found->second;
    std::erase_if(list, [&](std::uint32_t segment) {
      return std::any_of(nodes.begin(), nodes.end(),
                         [&](NodeIndex node) { return !contact::is_corner(plot_.corners_[segment], node); });
    });
    return list;
  }

  /// The shares of the point's nodes go to the corners that these are; of a triangle, to the first of two.
  void add_to(std::uint32_t segment, const ContactPoint& point, const Vector& force) {
    const model::SegmentNodes& corners = plot_.corners_[segment];
    for (std::size_t i = 0; i < 4; ++i) {
      if (point.weights[i] == 0) continue;
      const auto corner = std::find(corners.begin(), corners.end(), point.nodes[i]);
      if (corner == corners.end()) continue;
      auto& sum = state_.segments[segment].force[static_cast<std::size_t>(corner - corners.begin())];
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] += point.weights[i] * force[static_cast<Eigen::Index>(axis)];
    }
  }

  const InterfacePlot& plot_;
  const Surface& surface_;
  const std::vector<Vector>& x_;
  results::InterfaceForces& state_;
};

InterfacePlot::InterfacePlot(const Run& run, contact::SurfaceStore& surfaces) {
  const model::Model& model = run.model();
  mesh_.title = model.title;
  for (const ContactIndex contact : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& card = model.contact(contact);
    const ContactMethod method = choose_method(card).method;
    if (method == ContactMethod::none || method == ContactMethod::transducer) continue;
    if (!card.print_a && !card.print_b) continue;
    const contact::ContactSurfaces& sides = surfaces.at(contact);
    if (card.print_a) add_surface(model, contact, false, sides.a.selection.segments);
    if (card.print_b && sides.two_sided()) add_surface(model, contact, true, sides.b.selection.segments);
  }
  for (const NodeIndex node : nodes_) {
    mesh_.node_ids.push_back(model.mesh.nodes.id[node.value]);
    mesh_.coordinates.push_back(components(run.initial().x[node.value]));
  }
}

void InterfacePlot::add_surface(const model::Model& model, ContactIndex contact, bool side_b,
                                const contact::Segments& segments) {
  Surface surface;
  surface.contact = contact;
  surface.side_b = side_b;
  surface.first = corners_.size();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments.kind[i] == contact::SegmentKind::line) continue;
    const auto number = static_cast<std::uint32_t>(corners_.size());
    const model::SegmentNodes& nodes = segments.nodes[i];
    if (!surface.by_corners.try_emplace(sorted_corners(nodes), number).second) continue;  // named twice
    std::array<std::uint32_t, 4> placed{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [found, is_new] = position_.try_emplace(nodes[k], static_cast<std::uint32_t>(nodes_.size()));
      if (is_new) nodes_.push_back(nodes[k]);
      placed[k] = found->second;
      std::vector<std::uint32_t>& there = surface.by_node[nodes[k]];
      if (there.empty() || there.back() != number) there.push_back(number);
    }
    corners_.push_back(nodes);
    mesh_.segments.push_back(placed);
    mesh_.surface_of.push_back(static_cast<std::uint32_t>(surfaces_.size()));
  }
  surface.end = corners_.size();
  if (surface.end == surface.first) return;
  mesh_.surfaces.push_back({model.contact(contact).id.value, side_b ? 1U : 0U, model.contact(contact).title});
  surfaces_.push_back(std::move(surface));
}

results::InterfaceForces InterfacePlot::state(const Run& run) const {
  const State& now = run.stepper().state();
  results::InterfaceForces state;
  state.time = now.time;
  for (const NodeIndex node : nodes_) {
    state.coordinates.push_back(components(now.x[node.value]));
    state.velocities.push_back(components(now.v[node.value]));
  }
  state.segments.resize(corners_.size());
  const std::vector<ContactView> views = run.contacts();
  for (const Surface& surface : surfaces_) {
    Distribution forces(*this, surface, now.x, state);
    bool pulling = false;
    for (const ContactView& view : views) {
      if (view.state().contact != surface.contact) continue;
      pulling = pulling || pulls(view);
      const bool single = view.state().single_surface;
      std::vector<ContactLink> links;
      view.source->links(view.position, links);
      for (const ContactLink& link : links) {
        if (single || link.exchanged == surface.side_b) forces.add(link.tracked, link.force);
        if (single || link.exchanged != surface.side_b) forces.add(link.reference, -link.force);
      }
    }
    forces.finish(pulling);
  }
  return state;
}

}  // namespace gapcheck::solver
