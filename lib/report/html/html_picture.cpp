#include "report/html/html_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>

#include "report/html/html_json.hpp"
#include "report/write/json_members.hpp"

namespace gapcheck::report {
namespace {

/// A point in single precision; NaN if there is none, or it cannot be drawn.
std::array<float, 3> local(const std::optional<Vector>& point, const Vector& origin) {
  constexpr double farthest = 1e18;
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  if (!point) return {nan, nan, nan};
  const Vector x = *point - origin;
  if (!(x.array().abs() <= farthest).all()) return {nan, nan, nan};
  return {static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2])};
}

std::string part_json(const SceneMesh::Part& part) {
  Buffer out;
  Members object(out);
  object.raw("id", id_text(part.id));
  object.string("title", part.title);
  object.integer("first", part.first_face);
  object.integer("faces", part.faces);
  object.close();
  return fmt::to_string(out);
}

template <std::size_t N>
std::string packed(const std::vector<std::array<std::uint32_t, N>>& rows) {
  std::string out = "\"";
  append_base64(packed_differences({rows.empty() ? nullptr : rows.front().data(), rows.size() * N}), out);
  return out + '"';
}

/// Points of nodes, by the part that has them.
class ScenePoints {
 public:
  explicit ScenePoints(const SceneMesh& scene) {
    std::vector<std::int64_t> parts(scene.points.size(), 0);
    for (const SceneMesh::Part& part : scene.parts)
      for (std::uint32_t f = part.first_face; f < part.first_face + part.faces && f < scene.faces.size(); ++f)
        for (const std::uint32_t point : scene.faces[f])
          if (point < parts.size()) parts[point] = part.id;
    const std::size_t count = std::min(scene.points.size(), scene.point_nodes.size());
    for (std::uint32_t i = 0; i < count; ++i) entries_.push_back({scene.point_nodes[i], parts[i], i});
    std::sort(entries_.begin(), entries_.end());
  }
  /// The point of a node in this part, otherwise in any; no_position: none.
  [[nodiscard]] std::uint32_t of(std::int64_t node, std::int64_t part) const {
    const auto exact = std::lower_bound(entries_.begin(), entries_.end(), Entry{node, part, 0});
    if (exact != entries_.end() && exact->node == node && exact->part == part) return exact->point;
    constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
    const auto any = std::lower_bound(entries_.begin(), entries_.end(), Entry{node, lowest, 0});
    return node != 0 && any != entries_.end() && any->node == node ? any->point : no_position;
  }

 private:
  struct Entry {
    std::int64_t node, part;
    std::uint32_t point;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> entries_;
};

/// The points of each finding's node and of the corners of its segment.
void add_links(const ScenePoints& points, const std::vector<HtmlFinding>& findings, Members& object) {
  std::vector<std::array<std::uint32_t, 1>> nodes;
  std::vector<std::array<std::uint32_t, 4>> corners;
  for (const HtmlFinding& finding : findings) {
    nodes.push_back({points.of(finding.item.node, finding.item.part)});
    auto& row = corners.emplace_back();
    row.fill(no_position);
    for (std::size_t i = 0; i < std::min(row.size(), finding.segment.size()); ++i)
      row[i] = points.of(finding.segment[i], finding.item.element_part);
  }
  object.raw("node_points", binary(nodes));
  object.raw("corners", binary(corners));
}

/// The greatest depth of all penetrations at each point, also of those that are not in the page: 255 is the deepest.
void add_depths(const SceneMesh& scene, const ScenePoints& points, const Report& report, Members& object) {
  const auto counts = [](const Penetration& record) { return std::isfinite(record.depth) && record.depth > 0; };
  double deepest = 0;
  for (const Penetration& record : report.penetrations)
    if (counts(record)) deepest = std::max(deepest, record.depth);
  std::string depths(deepest > 0 ? scene.points.size() : 0, '\0');
  for (const Penetration& record : report.penetrations) {
    const std::uint32_t point = counts(record) ? points.of(record.node, record.part) : no_position;
    if (point >= depths.size()) continue;
    const auto value = static_cast<unsigned char>(std::ceil(255 * (record.depth / deepest)));
    depths[point] = static_cast<char>(std::max(value, static_cast<unsigned char>(depths[point])));
  }
  std::string text = "\"";
  append_base64(depths, text);
  object.raw("point_depths", text + '"');
  object.number("deepest", deepest);
}

/// The points of nodes that move, and where they go.
void add_moves(const SceneMesh& scene, const Report& report, Members& object) {
  if (report.moves.empty()) return;
  std::vector<std::array<std::uint32_t, 1>> points;
  std::vector<std::array<float, 3>> places;
  for (std::uint32_t p = 0; p < std::min(scene.points.size(), scene.point_nodes.size()); ++p) {
    const auto move = std::lower_bound(report.moves.begin(), report.moves.end(), scene.point_nodes[p],
                                       [](const NodeMove& m, std::int64_t node) { return m.node < node; });
    if (move == report.moves.end() || move->node != scene.point_nodes[p]) continue;
    const auto place = local(move->to, scene.origin);
    if (!(std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]))) continue;
    points.push_back({p});
    places.push_back(place);
  }
  object.raw("moved_points", binary(points));
  object.raw("moved_to", binary(places));
}

/// Elements and contact thicknesses of the faces, as runs of equal or consecutive ones.
void add_elements(const SceneMesh& scene, Members& object) {
  object.raw("elements", binary(id_runs(scene.face_elements)));
  std::vector<std::array<float, 1>> thickness;
  std::vector<std::array<std::uint32_t, 1>> faces;
  for (const float value : scene.face_thickness) {
    const float known = std::isfinite(value) && value > 0 ? value : 0;
    if (thickness.empty() || thickness.back()[0] != known) {
      thickness.push_back({known});
      faces.push_back({0});
    }
    ++faces.back()[0];
  }
  object.raw("thickness", binary(thickness));
  object.raw("thickness_faces", binary(faces));
}

}  // namespace

std::string packed_differences(std::span<const std::uint32_t> numbers) {
  std::string bytes;
  std::uint32_t last = 0;
  for (const std::uint32_t number : numbers) {
    const auto step = static_cast<std::int64_t>(number) - static_cast<std::int64_t>(last);
    last = number;
    std::uint64_t rest = step < 0 ? 2 * static_cast<std::uint64_t>(-step) - 1 : 2 * static_cast<std::uint64_t>(step);
    for (; rest >= 128; rest /= 128) bytes += static_cast<char>(rest % 128 + 128);
    bytes += static_cast<char>(rest);
  }
  return bytes;
}

std::vector<std::array<std::uint32_t, 2>> id_runs(const std::vector<std::int64_t>& ids) {
  std::vector<std::array<std::uint32_t, 2>> runs;
  for (const std::int64_t id : ids) {
    const bool fits = id > 0 && id < std::int64_t{1} << 32;
    const auto known = fits ? static_cast<std::uint32_t>(id) : 0;
    if (!runs.empty() && known != 0 && runs.back()[0] != 0 && std::uint64_t{runs.back()[0]} + runs.back()[1] == known)
      ++runs.back()[1];
    else
      runs.push_back({known, 1});
  }
  return runs;
}

std::string picture_json(const Report& report, const std::vector<HtmlFinding>& findings) {
  Vector origin = Vector::Zero();
  const auto placed = std::find_if(findings.begin(), findings.end(), [](const HtmlFinding& finding) {
    return finding.position && finding.position->allFinite();
  });
  if (report.scene)
    origin = report.scene->origin;
  else if (placed != findings.end())
    origin = *placed->position;
  std::vector<std::array<float, 3>> positions, vectors;
  for (const HtmlFinding& finding : findings) {
    positions.push_back(local(finding.position, origin));
    vectors.push_back(local(finding.vector, Vector::Zero()));
  }
  Buffer out;
  Members object(out);
  object.array("origin", std::array{origin[0], origin[1], origin[2]});
  object.raw("positions", binary(positions));
  object.raw("vectors", binary(vectors));
  if (const auto& scene = report.scene) {
    const ScenePoints points(*scene);
    add_links(points, findings, object);
    add_depths(*scene, points, report, object);
    object.raw("parts", json_array(scene->parts, part_json));
    object.raw("points", binary(scene->points));
    object.raw("faces", packed(scene->faces));
    add_elements(*scene, object);
    add_moves(*scene, report, object);
    object.raw("outline_points", binary(scene->outline_points));
    object.raw("outline", packed(scene->outline));
    object.integer("model_faces", scene->model_faces);
    object.integer("outline_left_out", scene->outline_left_out);
    object.raw("faces_cut", scene->faces_cut ? "true" : "false");
  }
  object.close();
  return fmt::to_string(out);
}

}  // namespace gapcheck::report
