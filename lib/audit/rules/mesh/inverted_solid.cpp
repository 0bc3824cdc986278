#include <fmt/format.h>

#include <array>
#include <limits>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"
#include "model/entity/faces.hpp"

namespace gapcheck::audit::rule::inverted_solid {
namespace {

using model::ElementKind;

/// Smaller than the rounding of coordinates at a flat corner.
constexpr double flat = 1e-9;

/// Cohesive formulations start without a volume.
bool cohesive(const model::Model& model, PartIndex index) {
  if (index == none<PartIndex> || !model.part(index).section) return false;
  const std::int64_t elform = model.sections[*model.part(index).section].elform;
  return elform >= 19 && elform <= 22;
}

/// Segments of solids in contact, one for each element.
std::vector<std::size_t> one_face_of_each(const contact::ContactMesh& mesh, ElementKind kind, std::size_t elements) {
  std::vector<std::size_t> faces;
  std::vector<std::uint8_t> seen;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const std::uint32_t e = mesh.element(i);
    if (mesh.kind(i) != kind || e == std::numeric_limits<std::uint32_t>::max()) continue;
    if (seen.empty()) seen.resize(elements);
    if (seen[e] == 0) faces.push_back(i);
    seen[e] = 1;
  }
  return faces;
}

void check(const RuleIdentity& rule, Context& context, Report& report, const contact::ContactMesh& mesh,
           ElementKind kind) {
  const model::Model& model = context.model();
  const model::Elements<8>& elements = kind == ElementKind::solid ? model.mesh.solids : model.mesh.thick_shells;
  const std::vector<std::size_t> faces = one_face_of_each(mesh, kind, elements.size());
  const auto quality = [&](std::size_t i) {
    return contact::solid_quality(elements.nodes[mesh.element(faces[i])], model.mesh.nodes.x);
  };
  std::vector<Found> found = find_all(faces.size(), [&](std::size_t i, std::vector<Found>& list) {
    const contact::SolidQuality q = quality(i);
    if (!(q.centre <= flat) && !(q.worst_corner <= flat)) return;
    const PartIndex part = mesh.part(faces[i]);
    if (cohesive(model, part) || !context.part_chosen(part)) return;
    const std::int64_t group = 2 * part_group(mesh, faces[i]) + (q.centre <= flat ? 0 : 1);
    list.push_back({group, -std::min(q.centre, q.worst_corner), i});
  });
  const char* word = kind == ElementKind::solid ? "solid" : "thick shell";
  const auto at = [&](const Found& f, Finding finding) {
    if (f.group % 2 != 0) finding.severity = Severity::warning;
    return finding;
  };
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const contact::SolidQuality q = quality(f.item);
        const std::size_t face = faces[f.item];
        const std::int64_t id = elements.id[mesh.element(face)];
        const std::string message =
            q.centre <= flat
                ? fmt::format(
                      "{} {}{} is turned inside out or has no volume (scaled Jacobian {:.3g} in its middle); correct "
                      "the "
                      "order of its nodes",
                      word, id, of_part(mesh, face), q.centre)
                : fmt::format(
                      "{} {}{} is turned inside out at node {} (scaled Jacobian {:.3g}, {:.3g} in its middle); move "
                      "the node",
                      word, id, of_part(mesh, face), model.mesh.nodes.id[q.corner.value], q.worst_corner, q.centre);
        Finding finding = segment_finding(rule, context, mesh, face, message);
        if (!(q.centre <= flat)) finding.node = model.mesh.nodes.id[q.corner.value];
        return at(f, std::move(finding));
      },
      [&](const Found& f, std::uint64_t count) {
        const std::size_t face = faces[f.item];
        return at(f, segments_finding(rule, context, mesh, face,
                                      fmt::format("{} more {}s{} are turned inside out{}", count, word,
                                                  of_part(mesh, face), f.group % 2 != 0 ? " at a corner" : "")));
      },
      collect_segments(context, [&](const Found& f, const auto& add) {
        const auto& nodes = elements.nodes[mesh.element(faces[f.item])];
        for (const model::SegmentNodes& face : model::SolidFaces(nodes)) add(face);
      }));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh == nullptr) return;
  check(rule, context, report, *mesh, ElementKind::solid);
  check(rule, context, report, *mesh, ElementKind::thick_shell);
}

}  // namespace

const Rule definition{{"GC510", "inverted-solid", Severity::error,
                       "a solid with a face in contact is turned inside out, wholly or at a corner", Need::surfaces,
                       "The solver stops, or the contact pushes inwards"},
                      run};

}  // namespace gapcheck::audit::rule::inverted_solid
