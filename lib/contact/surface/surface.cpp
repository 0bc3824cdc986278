#include "contact/surface/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/large_array.hpp"
#include "base/parallel.hpp"
#include "contact/mesh/faces.hpp"
#include "contact/surface/segment_elements.hpp"

namespace gapcheck::contact {
namespace {

using model::ElementKind;

void append(Segments& s, const model::SegmentNodes& nodes, std::uint32_t element, ElementKind element_kind,
            SegmentKind kind) {
  s.nodes.push_back(nodes);
  s.element.push_back(element);
  s.element_kind.push_back(element_kind);
  s.kind.push_back(kind);
}

bool in_box(const model::Box& box, std::span<const NodeIndex> nodes, const std::vector<Vector>& x) {
  return std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex n) { return box.contains(x[n.value]); });
}

/// Parts that an input names, as a mask over Model::parts.
std::vector<bool> part_mask(const model::Model& model, const model::SurfaceInput& input, bool single_surface) {
  std::vector<bool> mask(model.parts.size(), false);
  const auto type = static_cast<model::SurfaceType>(input.type);
  if (type == model::SurfaceType::all || (single_surface && input.id == 0)) {
    mask.assign(mask.size(), true);
  } else if (type == model::SurfaceType::part) {
    if (const auto part = model.part_of_id.find(input.id); part != model.part_of_id.end())
      mask[part->second.value] = true;
  } else {
    const auto& sets = type == model::SurfaceType::branch ? model.sets.branches : model.sets.parts;
    const auto set = sets.find(input.id);
    if (set == sets.end()) return mask;
    for (const PartIndex part : set->second.members) mask[part.value] = true;
    if (type == model::SurfaceType::exempted_part_set) mask.flip();
  }
  return mask;
}

/// Spotwelds are meant to be tied, not kept apart, unless CPARM8 says so (contact rules, sections 4.6 and 13.6).
bool beam_has_contact(const model::Model& model, PartIndex index, const ContactType& type) {
  if (type.family == Family::tied || type.code == ContactCode::transducer) return true;
  const model::Part& part = model.part(index);
  if (!type.spotweld_beams && part.material && model.materials[*part.material].spotweld) return false;
  return !(part.section && model.sections[*part.section].elform == model::discrete_beam);
}

/// Whether a surface is only made of parts whose particles the run makes.
bool only_later_particles(const model::Model& model, const model::SurfaceInput& input) {
  using enum model::SurfaceType;
  const auto type = static_cast<model::SurfaceType>(input.type);
  if (model.later_particles.empty() || (type != part && type != part_set && type != branch)) return false;
  const std::vector<bool> mask = part_mask(model, input, false);
  const auto chosen = [&](PartIndex p) { return mask[p.value]; };
  const auto named = static_cast<std::size_t>(std::count(mask.begin(), mask.end(), true));
  const auto later =
      static_cast<std::size_t>(std::count_if(model.later_particles.begin(), model.later_particles.end(), chosen));
  return named > 0 && named == later;
}

/// Parts that a surface is made of.
struct ChosenParts {
  std::vector<bool> mask;
  std::vector<PartIndex> list;  // ascending
};

/// Elements of the parts, ascending.
template <class ElementArray>
std::vector<std::uint32_t> elements_of(const ElementArray& elements, ElementIndex& index, const ChosenParts& parts) {
  std::size_t total = 0;
  for (const PartIndex part : parts.list) total += index.of(part).size();
  std::vector<std::uint32_t> chosen;
  reserve_in_parallel(chosen, total);
  if (total < elements.size() / 16 || parts.list.size() == 1) {
    for (const PartIndex part : parts.list) chosen.insert(chosen.end(), index.of(part).begin(), index.of(part).end());
    if (parts.list.size() > 1) std::sort(chosen.begin(), chosen.end());
    return chosen;
  }
  for (std::uint32_t e = 0; e < elements.size(); ++e)
    if (elements.part[e] != none<PartIndex> && parts.mask[elements.part[e].value]) chosen.push_back(e);
  return chosen;
}

void append_faces(Segments& s, const model::Elements<8>& elements, ElementIndex& index, ElementKind kind,
                  const ChosenParts& parts, const std::vector<Vector>& x) {
  const auto chosen = elements_of(elements, index, parts);
  if (chosen.empty()) return;
  const auto covered = shell_keys(s);
  for (const Face& face : free_faces(elements, chosen, x))
    if (!covered.contains(segment_key(face.nodes))) append(s, face.nodes, face.element, kind, SegmentKind::solid);
}

void select_parts(Selection& selection, const model::Model& model, std::vector<bool> mask, const ContactType& type,
                  const std::vector<Vector>& x, MeshIndex& index) {
  const model::Mesh& mesh = model.mesh;
  Segments& s = selection.segments;
  ChosenParts parts{std::move(mask), {}};
  for (std::uint32_t p = 0; p < parts.mask.size(); ++p)
    if (parts.mask[p]) parts.list.emplace_back(p);
  const auto shells = elements_of(mesh.shells, index.shells, parts);
  reserve_in_parallel(s.nodes, shells.size());
  reserve_in_parallel(s.element, shells.size());
  s.element_kind.reserve(shells.size());
  s.kind.reserve(shells.size());
  for (const std::uint32_t e : shells) append(s, mesh.shells.nodes[e], e, ElementKind::shell, SegmentKind::shell);
  if (mesh.solids.size() > 0) append_faces(s, mesh.solids, index.solids, ElementKind::solid, parts, x);
  if (mesh.thick_shells.size() > 0)
    append_faces(s, mesh.thick_shells, index.thick_shells, ElementKind::thick_shell, parts, x);
  for (const std::uint32_t e : elements_of(mesh.beams, index.beams, parts)) {
    if (!beam_has_contact(model, mesh.beams.part[e], type)) continue;
    const auto& n = mesh.beams.nodes[e];
    append(s, {n[0], n[1], n[1], n[1]}, e, ElementKind::beam, SegmentKind::line);
  }
  for (const std::uint32_t e : elements_of(mesh.particles, index.particles, parts))
    selection.nodes.push_back(mesh.particles.nodes[e][0]);
}

void set_missing(Selection& selection, std::string_view what, std::int64_t id) {
  selection.empty_reason = fmt::format("{} {} does not exist", what, id);
  selection.unknown_id = id != 0;
}

/// A segment that repeats a corner anywhere is a triangle.
model::SegmentNodes distinct_corners(const model::SegmentNodes& nodes) {
  model::SegmentNodes kept{};
  std::size_t n = 0;
  for (const NodeIndex node : nodes)
    if (std::find(kept.begin(), kept.begin() + n, node) == kept.begin() + n) kept[n++] = node;
  return n == 3 ? model::SegmentNodes{kept[0], kept[1], kept[2], kept[2]} : nodes;
}

void select_segments(Selection& selection, const model::Model& model, std::int64_t id, const std::vector<Vector>& x,
                     MeshIndex& index) {
  const auto set = model.sets.segments.find(id);
  if (set == model.sets.segments.end()) {
    set_missing(selection, "segment set", id);
    return;
  }
  const auto& segments = set->second.members;
  const std::vector<SegmentElement> owners = find_segment_elements(model.mesh, segments, index);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Face face{distinct_corners(segments[i]), owners[i].element};
    const bool found = owners[i].element != no_position;
    const bool solid = found && owners[i].kind == ElementKind::solid;
    const bool thick = found && owners[i].kind == ElementKind::thick_shell;
    if (solid || thick)
      turn_outward(face, (solid ? model.mesh.solids : model.mesh.thick_shells).nodes[face.element], x);
    append(selection.segments, face.nodes, face.element, owners[i].kind,
           solid || thick ? SegmentKind::solid : SegmentKind::shell);
  }
}

void select_shells(Selection& selection, const model::Model& model, std::int64_t id) {
  const auto set = model.sets.shells.find(id);
  if (set == model.sets.shells.end()) {
    set_missing(selection, "shell set", id);
    return;
  }
  for (const std::uint32_t e : set->second.members)
    append(selection.segments, model.mesh.shells.nodes[e], e, ElementKind::shell, SegmentKind::shell);
}

void select_nodes(Selection& selection, const model::Model& model, std::int64_t id) {
  const auto set = model.sets.nodes.find(id);
  if (set == model.sets.nodes.end())
    set_missing(selection, "node set", id);
  else
    selection.nodes = set->second.members;
}

void keep_box(Selection& selection, const model::Box& box, const std::vector<Vector>& x) {
  Segments kept;
  const Segments& all = selection.segments;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (in_box(box, all.nodes[i], x))
      append(kept, all.nodes[i], all.element[i], all.element_kind[i], all.kind[i]);
    else if (std::any_of(all.nodes[i].begin(), all.nodes[i].end(),
                         [&](NodeIndex n) { return box.contains(x[n.value]); }))
      append(selection.cut, all.nodes[i], all.element[i], all.element_kind[i], all.kind[i]);
  }
  // A node inside counts, though its segment reaches out.
  for (const auto& corners : selection.cut.nodes)
    selection.nodes.insert(selection.nodes.end(), corners.begin(), corners.end());
  selection.segments = std::move(kept);
  std::erase_if(selection.nodes, [&](NodeIndex n) { return !box.contains(x[n.value]); });
}

}  // namespace

double shortest_edge(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    const NodeIndex a = n[i], b = n[(i + 1) % 4];
    if (a != b) shortest = std::min(shortest, (x[a.value] - x[b.value]).squaredNorm());
  }
  return std::sqrt(shortest);
}

Selection select(const model::Model& model, const model::SurfaceInput& input, const ContactType& type,
                 const std::vector<Vector>& x, MeshIndex& index) {
  Selection selection;
  const bool single = type.treatment == Treatment::single_surface;
  using enum model::SurfaceType;
  const auto kind = static_cast<model::SurfaceType>(input.type);
  if (input.type < 0 || input.type > 7) {
    selection.empty_reason = fmt::format("surface type {} is not one of 0 to 7", input.type);
    return selection;
  }
  if (single && input.id == 0) {
    select_parts(selection, model, part_mask(model, input, single), type, x, index);
  } else {
    switch (kind) {
      case segment_set:
        select_segments(selection, model, input.id, x, index);
        break;
      case shell_set:
        select_shells(selection, model, input.id);
        break;
      case node_set:
        select_nodes(selection, model, input.id);
        break;
      case part_set:
      case exempted_part_set:
        if (!model.sets.parts.contains(input.id)) set_missing(selection, "part set", input.id);
        select_parts(selection, model, part_mask(model, input, single), type, x, index);
        break;
      case part:
        if (!model.part_of_id.contains(input.id)) set_missing(selection, "part", input.id);
        select_parts(selection, model, part_mask(model, input, single), type, x, index);
        break;
      case all:
        select_parts(selection, model, part_mask(model, input, single), type, x, index);
        break;
      case branch:
        if (!model.sets.branches.contains(input.id)) set_missing(selection, "branch", input.id);
        select_parts(selection, model, part_mask(model, input, single), type, x, index);
        break;
    }
  }
  if (input.box != 0) {
    if (const auto box = model.boxes.find(input.box); box != model.boxes.end()) keep_box(selection, box->second, x);
  }
  if (input.box < 0) selection.note = fmt::format("box {} (a contact volume) is not honoured", input.box);
  if (selection.segments.size() == 0 && selection.nodes.empty() && selection.empty_reason.empty()) {
    selection.later = only_later_particles(model, input);
    selection.empty_reason =
        selection.later ? "its particles do not exist before solids fail" : "what it names has no segments or nodes";
  }
  return selection;
}

void fill_thickness(Segments& s, const model::Model& model, const ThicknessSide& side, const std::vector<Vector>& x) {
  s.half.resize(s.size());
  s.rule.resize(s.size());
  constexpr std::size_t grain = 8192;
  parallel_for(s.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const PartIndex part = part_of(model.mesh, s, i);
      const model::PartContact* own = nullptr;
      if (part != none<PartIndex> && model.part(part).contact) own = &*model.part(part).contact;
      Thickness t;
      if (s.element_kind[i] == ElementKind::solid || s.element_kind[i] == ElementKind::thick_shell) {
        t = solid_thickness(side);
        // A coated solid is wrapped in a dummy shell.
        if (t.value > 0) s.kind[i] = SegmentKind::shell;
      } else if (s.element_kind[i] == ElementKind::beam) {
        double radius = 0;
        if (part != none<PartIndex> && model.part(part).section)
          radius = model.sections[*model.part(part).section].beam_radius;
        t = beam_thickness(radius, own, side);
      } else {
        const double element = s.element[i] == no_position ? 0 : element_thickness(model, s.element[i]);
        const double edge = side.edge_limit ? shortest_edge(s.nodes[i], x) : 0;
        t = shell_thickness(element, edge, own, part != none<PartIndex> && model.rigid(part), side);
      }
      s.half[i] = t.value / 2;
      s.rule[i] = t.rule;
    }
  });
}

namespace {

/// True if a segment's corners run in the same direction as its shell's.
bool same_side(const model::SegmentNodes& segment, const model::SegmentNodes& shell) {
  const std::size_t corners = shell[2] == shell[3] ? 3 : 4;
  for (std::size_t i = 0; i < corners; ++i)
    if (shell[i] == segment[0]) return shell[(i + 1) % corners] == segment[1];
  return true;
}

}  // namespace

void fill_offsets(Segments& s, const model::Model& model) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.element_kind[i] != ElementKind::shell || s.element[i] == no_position) continue;
    const double offset = mid_surface_offset(model, s.element[i]);
    if (offset == 0) continue;
    s.offset.resize(s.size(), 0);
    s.offset[i] = same_side(s.nodes[i], model.mesh.shells.nodes[s.element[i]]) ? offset : -offset;
  }
}

PartIndex part_of(const model::Mesh& mesh, const Segments& s, std::size_t i) {
  if (s.element[i] == no_position) return none<PartIndex>;
  switch (s.element_kind[i]) {
    case ElementKind::shell:
      return mesh.shells.part[s.element[i]];
    case ElementKind::solid:
      return mesh.solids.part[s.element[i]];
    case ElementKind::thick_shell:
      return mesh.thick_shells.part[s.element[i]];
    case ElementKind::beam:
      return mesh.beams.part[s.element[i]];
    default:
      return none<PartIndex>;
  }
}

std::int64_t element_id(const model::Mesh& mesh, const Segments& s, std::size_t i) {
  if (s.element[i] == no_position) return 0;
  switch (s.element_kind[i]) {
    case ElementKind::shell:
      return mesh.shells.id[s.element[i]];
    case ElementKind::solid:
      return mesh.solids.id[s.element[i]];
    case ElementKind::thick_shell:
      return mesh.thick_shells.id[s.element[i]];
    case ElementKind::beam:
      return mesh.beams.id[s.element[i]];
    default:
      return 0;
  }
}

}  // namespace gapcheck::contact
