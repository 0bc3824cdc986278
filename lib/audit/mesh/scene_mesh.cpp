#include "audit/mesh/scene_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "model/entity/faces.hpp"

namespace gapcheck::audit {
namespace {

/// Collects the faces of a mesh, kind by kind.
class FaceList {
 public:
  FaceList(const model::Mesh& mesh, const ElementsInContact* in_contact) : mesh_(mesh), in_contact_(in_contact) {}

  template <std::size_t N>
  void add(const model::Elements<N>& elements, model::ElementKind kind) {
    static_assert(N == 1 || N == 2 || N == 4);
    faces_.reserve(faces_.size() + elements.size());
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      model::SegmentNodes nodes;
      for (std::size_t corner = 0; corner < 4; ++corner) nodes[corner] = elements.nodes[i][std::min(corner, N - 1)];
      add(elements, kind, i, nodes);
    }
  }
  void add_outer(const model::Elements<8>& elements, model::ElementKind kind) {
    std::vector<std::uint32_t> all(elements.size());
    std::iota(all.begin(), all.end(), 0U);
    for (const model::Face& face : model::exterior_faces(elements, all)) add(elements, kind, face.element, face.nodes);
  }
  [[nodiscard]] std::vector<SceneFace> taken() { return std::move(faces_); }

 private:
  template <std::size_t N>
  void add(const model::Elements<N>& elements, model::ElementKind kind, std::uint32_t i,
           const model::SegmentNodes& nodes) {
    SceneFace face;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      face.nodes[corner] = nodes[corner].value;
      if (face.nodes[corner] >= mesh_.nodes.size()) return;
    }
    face.part = elements.part[i];
    face.element = elements.id[i];
    if (in_contact_ != nullptr) face.thickness = static_cast<float>(in_contact_->of(kind).thickness[i]);
    faces_.push_back(face);
  }

  const model::Mesh& mesh_;
  const ElementsInContact* in_contact_;
  std::vector<SceneFace> faces_;
};

/// Shells, outer faces of solids and thick shells, beams, particles.
std::vector<SceneFace> faces_of(const model::Mesh& mesh, const ElementsInContact* in_contact) {
  using enum model::ElementKind;
  FaceList list(mesh, in_contact);
  list.add(mesh.shells, shell);
  list.add_outer(mesh.solids, solid);
  list.add_outer(mesh.thick_shells, thick_shell);
  list.add(mesh.beams, beam);
  list.add(mesh.particles, particle);
  return list.taken();
}

/// The faces of every node.
class FacesOfNodes {
 public:
  FacesOfNodes(const std::vector<SceneFace>& faces, std::size_t nodes) : start_(nodes + 1, 0) {
    for (const SceneFace& face : faces)
      for (const std::uint32_t node : face.nodes) ++start_[node + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    faces_.resize(start_.back());
    for (std::uint32_t f = 0; f < faces.size(); ++f)
      for (const std::uint32_t node : faces[f].nodes) faces_[next[node]++] = f;
  }
  /// Faces that repeat a node come repeatedly.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t node) const {
    return {faces_.data() + start_[node], start_[node + 1] - start_[node]};
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> faces_;
};

/// The nodes of findings in the order in which they matter.
class Seeds {
 public:
  Seeds(const model::Mesh& mesh, const Report& report) : mesh_(mesh) {
    for (const Penetration* record : in_turn(report.penetrations)) {
      add_node(record->node);
      for (const std::int64_t node : record->segment) add_node(node);
    }
    for (const TieFailure& failure : report.tie_failures) add_node(failure.node);
    for (const Finding& finding : report.findings) {
      add_node(finding.node);
      add_element(mesh.shells, finding);
      add_element(mesh.solids, finding);
      add_element(mesh.thick_shells, finding);
      add_element(mesh.beams, finding);
      add_element(mesh.particles, finding);
    }
  }
  [[nodiscard]] const std::vector<std::uint32_t>& nodes() const { return nodes_; }

 private:
  /// The deepest of each contact, then the second ones, and so on.
  static std::vector<const Penetration*> in_turn(const std::vector<Penetration>& records) {
    struct Entry {
      std::size_t rank;
      const Penetration* record;
    };
    std::vector<Entry> entries;
    entries.reserve(records.size());
    for (std::size_t i = 0; i < records.size(); ++i)
      entries.push_back(
          {i > 0 && records[i].contact == records[i - 1].contact ? entries.back().rank + 1 : 0, &records[i]});
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.rank < b.rank; });
    std::vector<const Penetration*> list;
    list.reserve(entries.size());
    for (const Entry& entry : entries) list.push_back(entry.record);
    return list;
  }
  void add_node(std::int64_t id) {
    if (id == 0) return;
    if (const auto node = mesh_.nodes.lookup.find(id)) nodes_.push_back(*node);
  }
  template <std::size_t N>
  void add_element(const model::Elements<N>& elements, const Finding& finding) {
    if (finding.element == 0) return;
    const auto element = elements.lookup.find(finding.element);
    if (!element) return;
    for (const NodeIndex node : elements.nodes[*element])
      if (node.value < mesh_.nodes.size()) nodes_.push_back(node.value);
  }

  const model::Mesh& mesh_;
  std::vector<std::uint32_t> nodes_;
};

bool drawable(const Vector& x, const Vector& origin) {
  constexpr double farthest = 1e18;
  return ((x - origin).array().abs() <= farthest).all();
}

/// Positions of the faces around the seeds, ring by ring; `cut` where the limit ended it.
std::vector<std::uint32_t> around(const std::vector<std::uint32_t>& seeds, const std::vector<SceneFace>& faces,
                                  std::span<const Vector> x, const Vector& origin, const SceneLimits& limits,
                                  bool& cut) {
  const FacesOfNodes faces_of_nodes(faces, x.size());
  std::vector<bool> taken(faces.size(), false), seen(x.size(), false);
  std::vector<std::uint32_t> chosen, queue, next;
  const auto visit = [&](std::uint32_t node, std::vector<std::uint32_t>& list) {
    if (!seen[node]) list.push_back(node);
    seen[node] = true;
  };
  for (const std::uint32_t node : seeds) visit(node, queue);
  for (std::uint32_t ring = 0; ring < limits.rings && !queue.empty(); ++ring, queue.swap(next), next.clear()) {
    for (const std::uint32_t node : queue) {
      for (const std::uint32_t f : faces_of_nodes.of(node)) {
        if (taken[f]) continue;
        taken[f] = true;
        const auto& corners = faces[f].nodes;
        if (!std::all_of(corners.begin(), corners.end(), [&](std::uint32_t n) { return drawable(x[n], origin); }))
          continue;
        if (chosen.size() == limits.faces) {
          cut = true;
          return chosen;
        }
        chosen.push_back(f);
        for (const std::uint32_t corner : corners) visit(corner, next);
      }
    }
  }
  return chosen;
}

/// Adds the faces that are not chosen yet.
void add_rest(const std::vector<SceneFace>& faces, std::span<const Vector> x, const Vector& origin,
              std::vector<std::uint32_t>& chosen) {
  std::vector<bool> taken(faces.size(), false);
  for (const std::uint32_t f : chosen) taken[f] = true;
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    if (!taken[f] && std::all_of(faces[f].nodes.begin(), faces[f].nodes.end(),
                                 [&](std::uint32_t n) { return drawable(x[n], origin); }))
      chosen.push_back(f);
}

/// Puts the chosen faces into the scene, part by part in the order of the deck.
void add_faces(const model::Model& model, const std::vector<SceneFace>& faces, std::vector<std::uint32_t> chosen,
               SceneMesh& scene) {
  std::sort(chosen.begin(), chosen.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(faces[a].part.value, a) < std::tuple(faces[b].part.value, b);
  });
  const std::vector<Vector>& x = model.mesh.nodes.x;
  std::vector<std::uint32_t> point(x.size(), no_position);  // of a node; stale where it belongs to an earlier part
  std::uint32_t first_point = 0;
  PartIndex part;
  for (const std::uint32_t f : chosen) {
    if (scene.parts.empty() || faces[f].part != part) {
      part = faces[f].part;
      first_point = static_cast<std::uint32_t>(scene.points.size());
      const bool known = part.value < model.parts.size();
      scene.parts.push_back({known ? model.part(part).id.value : 0, known ? model.part(part).title : "",
                             static_cast<std::uint32_t>(scene.faces.size()), 0});
    }
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
      std::uint32_t& known = point[faces[f].nodes[i]];
      if (known == no_position || known < first_point) {
        known = static_cast<std::uint32_t>(scene.points.size());
        const Vector local = x[faces[f].nodes[i]] - scene.origin;
        scene.points.push_back(
            {static_cast<float>(local[0]), static_cast<float>(local[1]), static_cast<float>(local[2])});
        scene.point_nodes.push_back(model.mesh.nodes.id[faces[f].nodes[i]]);
      }
      corners[i] = known;
    }
    scene.faces.push_back(corners);
    scene.face_elements.push_back(faces[f].element);
    scene.face_thickness.push_back(faces[f].thickness);
    ++scene.parts.back().faces;
  }
}

void add_nodes(const model::Nodes& nodes, const Report& report, SceneMesh& scene) {
  std::vector<std::int64_t> ids;
  for (const TieFailure& failure : report.tie_failures) ids.push_back(failure.node);
  for (const Finding& finding : report.findings)
    if (!finding.point && finding.node != 0) ids.push_back(finding.node);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const std::int64_t id : ids)
    if (const auto node = nodes.lookup.find(id)) scene.nodes.emplace_back(id, nodes.x[*node]);
}

}  // namespace

SceneFrame scene_frame(std::span<const Vector> x) {
  constexpr std::size_t samples = 5000;
  SceneFrame frame;
  std::vector<double> sample;
  double length = 0;
  const std::size_t step = std::max<std::size_t>(1, x.size() / samples);
  for (int axis = 0; axis < 3; ++axis) {
    sample.clear();
    for (std::size_t i = 0; i < x.size(); i += step)
      if (std::isfinite(x[i][axis])) sample.push_back(x[i][axis]);
    if (sample.empty()) return {};
    std::sort(sample.begin(), sample.end());
    const std::size_t margin = sample.size() / 50;
    frame.origin[axis] = sample[sample.size() / 2];
    frame.low[axis] = sample[margin];
    frame.high[axis] = sample[sample.size() - 1 - margin];
    length = std::max(length, frame.high[axis] - frame.low[axis]);
  }
  // Nothing that far away can be drawn in single precision.
  length = std::min(length, 1e17);
  frame.low = frame.low.cwiseMax(frame.origin - Vector::Constant(length)) - Vector::Constant(length);
  frame.high = frame.high.cwiseMin(frame.origin + Vector::Constant(length)) + Vector::Constant(length);
  return frame;
}

SceneMesh scene_mesh(const model::Model& model, const Report& report, const SceneLimits& limits,
                     const ElementsInContact* in_contact) {
  SceneMesh scene;
  const std::vector<Vector>& x = model.mesh.nodes.x;
  const SceneFrame frame = scene_frame(x);
  scene.origin = frame.origin;
  const std::vector<SceneFace> faces = faces_of(model.mesh, in_contact);
  scene.model_faces = faces.size();
  const Seeds seeds(model.mesh, report);
  std::vector<std::uint32_t> chosen = around(seeds.nodes(), faces, x, scene.origin, limits, scene.faces_cut);
  if (faces.size() <= std::min(limits.whole, limits.faces)) add_rest(faces, x, scene.origin, chosen);
  add_faces(model, faces, std::move(chosen), scene);
  add_outline(faces, x, frame, limits.outline_edges, scene);
  add_nodes(model.mesh.nodes, report, scene);
  return scene;
}

}  // namespace gapcheck::audit
