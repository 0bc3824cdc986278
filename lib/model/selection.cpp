#include "model/selection.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "model/entity/faces.hpp"

namespace gapcheck::model {
namespace {

constexpr SetKind element_kinds[] = {SetKind::shell, SetKind::solid, SetKind::thick_shell, SetKind::beam,
                                     SetKind::discrete};

bool is_element(SetKind kind) {
  return std::find(std::begin(element_kinds), std::end(element_kinds), kind) != std::end(element_kinds);
}

}  // namespace

/// Calls visitor(table) with the elements of a kind; for other kinds does nothing.
template <class Visitor>
void Selection::visit(SetKind kind, const Visitor& visitor) const {
  const Mesh& mesh = model_.mesh;
  switch (kind) {
    case SetKind::shell:
      return visitor(static_cast<const Elements<4>&>(mesh.shells));
    case SetKind::solid:
      return visitor(mesh.solids);
    case SetKind::thick_shell:
      return visitor(mesh.thick_shells);
    case SetKind::beam:
      return visitor(mesh.beams);
    case SetKind::discrete:
      return visitor(mesh.discrete);
    case SetKind::node:
    case SetKind::part:
    case SetKind::segment:
    case SetKind::branch:
      return;
  }
}

/// The elements for which select(table, position) holds.
template <class Select>
Members Selection::elements(SetKind kind, const Select& select) const {
  Members result;
  visit(kind, [&](const auto& table) {
    if (!budget_.spend(table.size())) return;
    for (std::uint32_t i = 0; i < table.size(); ++i)
      if (select(table, i)) result.positions.push_back(i);
  });
  return result;
}

template <class Select>
Members Selection::surface(const Select& select) const {
  Members result;
  for (const SetKind kind : {SetKind::shell, SetKind::solid, SetKind::thick_shell})
    result.append(faces_of(kind, elements(kind, select)));
  return result;
}

std::optional<std::uint32_t> Selection::find(SetKind kind, std::int64_t id) const {
  if (kind == SetKind::node) return model_.mesh.nodes.lookup.find(id);
  if (kind == SetKind::part) {
    const auto part = model_.part_of_id.find(id);
    return part == model_.part_of_id.end() ? std::nullopt : std::optional(part->second.value);
  }
  std::optional<std::uint32_t> found;
  visit(kind, [&](const auto& table) { found = table.lookup.find(id); });
  return found;
}

Members Selection::range(SetKind kind, std::int64_t first, std::int64_t last, std::int64_t step) const {
  Members result;
  const auto add = [&](std::int64_t id, std::uint32_t position) {
    if (!budget_.spend(1)) return false;
    // Unsigned, because the distance from the first id may not fit into a signed number.
    const auto way = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(first);
    if (step <= 1 || way % static_cast<std::uint64_t>(step) == 0) result.positions.push_back(position);
    return true;
  };
  if (kind == SetKind::node) {
    model_.mesh.nodes.lookup.for_each_in(first, last, add);
  } else if (kind == SetKind::part) {
    for (auto part = model_.part_of_id.lower_bound(first); part != model_.part_of_id.end(); ++part)
      if (part->first > last || !add(part->first, part->second.value)) break;
  } else {
    visit(kind, [&](const auto& table) { table.lookup.for_each_in(first, last, add); });
  }
  return result;
}

Members Selection::all(SetKind kind) const {
  const auto everything = [](const auto&, std::uint32_t) { return true; };
  if (kind == SetKind::segment) return surface(everything);
  if (is_element(kind)) return elements(kind, everything);
  const std::size_t count = kind == SetKind::node ? model_.mesh.nodes.size() : model_.parts.size();
  Members result;
  if (!budget_.spend(count)) return result;
  result.positions.resize(count);
  std::iota(result.positions.begin(), result.positions.end(), 0U);
  return result;
}

Members Selection::in_box(SetKind kind, const Box& box) const {
  const std::vector<Vector>& x = model_.mesh.nodes.x;
  const auto inside = [&](NodeIndex node) { return node == none<NodeIndex> || box.contains(x[node.value]); };
  const auto element_inside = [&](const auto& table, std::uint32_t i) {
    return std::all_of(table.nodes[i].begin(), table.nodes[i].end(), inside);
  };
  if (kind == SetKind::segment) return surface(element_inside);
  if (kind == SetKind::part) return parts_inside(inside);
  if (is_element(kind)) return elements(kind, element_inside);
  Members result;
  if (!budget_.spend(x.size())) return result;
  for (std::uint32_t i = 0; i < x.size(); ++i)
    if (inside(NodeIndex(i))) result.positions.push_back(i);
  return result;
}

template <class Inside>
Members Selection::parts_inside(const Inside& inside) const {
  std::vector<std::uint8_t> has_elements(model_.parts.size()), reaches_out(model_.parts.size());
  for (const SetKind kind : element_kinds)
    visit(kind, [&](const auto& table) {
      if (!budget_.spend(table.size())) return;
      for (std::uint32_t i = 0; i < table.size(); ++i) {
        if (table.part[i] == none<PartIndex>) continue;
        has_elements[table.part[i].value] = 1;
        if (!std::all_of(table.nodes[i].begin(), table.nodes[i].end(), inside)) reaches_out[table.part[i].value] = 1;
      }
    });
  Members result;
  for (std::uint32_t i = 0; i < has_elements.size() && !budget_.exhausted(); ++i)
    if (has_elements[i] != 0 && reaches_out[i] == 0) result.positions.push_back(i);
  return result;
}

Members Selection::faces_of(SetKind kind, const Members& members) const {
  Members result;
  // A solid has up to six faces, each of four nodes.
  if (!budget_.spend(24 * members.positions.size())) return result;
  const Mesh& mesh = model_.mesh;
  if (kind == SetKind::shell)
    for (const std::uint32_t i : members.positions) result.segments.push_back(mesh.shells.nodes[i]);
  else
    for (const Face& face : exterior_faces(kind == SetKind::solid ? mesh.solids : mesh.thick_shells, members.positions))
      result.segments.push_back(face.nodes);
  return result;
}

std::vector<std::uint8_t> Selection::marked_parts(const Members& parts) const {
  std::vector<std::uint8_t> marks(model_.parts.size());
  for (const std::uint32_t part : parts.positions) marks[part] = 1;
  return marks;
}

Members Selection::nodes_of(SetKind kind, const Members& members) const {
  Members result;
  // Clearing the marks costs something too: many small sets of a large model.
  if (!budget_.spend(model_.mesh.nodes.size() / 64 + 8 * members.cost())) return result;
  std::vector<std::uint8_t> seen(model_.mesh.nodes.size());
  const auto add = [&](const auto& nodes) {
    for (const NodeIndex node : nodes) {
      if (node == none<NodeIndex> || seen[node.value] != 0) continue;
      seen[node.value] = 1;
      result.positions.push_back(node.value);
    }
  };
  if (kind == SetKind::segment) {
    for (const SegmentNodes& segment : members.segments) add(segment);
    return result;
  }
  if (kind != SetKind::part) {
    visit(kind, [&](const auto& table) {
      for (const std::uint32_t i : members.positions) add(table.nodes[i]);
    });
    return result;
  }
  const std::vector<std::uint8_t> wanted = marked_parts(members);
  const auto add_elements = [&](const auto& table) {
    if (!budget_.spend(table.size())) return;
    for (std::size_t i = 0; i < table.size(); ++i)
      if (table.part[i] != none<PartIndex> && wanted[table.part[i].value] != 0) add(table.nodes[i]);
  };
  for (const SetKind element : element_kinds) visit(element, add_elements);
  add_elements(model_.mesh.particles);
  return result;
}

std::optional<Members> Selection::convert(Members members, SetKind from, SetKind to) const {
  if (from == to || (from == SetKind::part && to == SetKind::branch)) return members;
  if (to == SetKind::node) return nodes_of(from, members);
  if (from == SetKind::part) {
    const std::vector<std::uint8_t> wanted = marked_parts(members);
    const auto select = [&](const auto& table, std::uint32_t i) {
      return table.part[i] != none<PartIndex> && wanted[table.part[i].value] != 0;
    };
    return to == SetKind::segment ? surface(select) : elements(to, select);
  }
  const bool has_faces = from == SetKind::shell || from == SetKind::solid || from == SetKind::thick_shell;
  if (to == SetKind::segment && has_faces) return faces_of(from, members);
  return std::nullopt;
}

}  // namespace gapcheck::model
