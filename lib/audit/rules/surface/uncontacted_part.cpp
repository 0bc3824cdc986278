#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::uncontacted_part {
namespace {

/// Elements of the kinds that have a surface, by part.
struct Census {
  std::vector<std::uint32_t> shells, solids, thick_shells;
  explicit Census(const model::Model& model) {
    const auto count = [&](const std::vector<PartIndex>& of, std::vector<std::uint32_t>& number) {
      number.assign(model.parts.size(), 0);
      for (const PartIndex part : of)
        if (part != none<PartIndex>) ++number[part.value];
    };
    count(model.mesh.shells.part, shells);
    count(model.mesh.solids.part, solids);
    count(model.mesh.thick_shells.part, thick_shells);
  }
  [[nodiscard]] std::uint64_t at(std::size_t part) const {
    return std::uint64_t{shells[part]} + solids[part] + thick_shells[part];
  }
};

/// Marks the parts that have one of the nodes.
void mark_parts_at(const model::Mesh& mesh, const std::vector<bool>& nodes, std::vector<bool>& parts) {
  const auto visit = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const PartIndex part = elements.part[e];
      if (part == none<PartIndex> || parts[part.value]) continue;
      const auto& n = elements.nodes[e];
      if (std::any_of(n.begin(), n.end(), [&](NodeIndex i) { return nodes[i.value]; })) parts[part.value] = true;
    }
  };
  visit(mesh.shells);
  visit(mesh.solids);
  visit(mesh.thick_shells);
}

/// Parts of all sides of all contacts, --contact or not: a part is uncontacted only if none has it. `known` is false if
/// a contact may hold unknown parts.
std::vector<bool> parts_in_contact(Context& context, bool& known) {
  const model::Model& model = context.model();
  std::vector<bool> parts(model.parts.size(), false), nodes;
  const auto take = [&](const contact::ContactSide& side) {
    for (const PartIndex part : contact::parts_of(model, side)) parts[part.value] = true;
    if (side.nodes_only) nodes.resize(model.mesh.nodes.size(), false);
    if (side.nodes_only)
      for (const NodeIndex n : side.selection.nodes) nodes[n.value] = true;
  };
  for (const ContactIndex i : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(i);
    const contact::ContactType type = contact::classify(contact);
    if (type.code == contact::ContactCode::transducer || contact.order == 0) continue;
    if (!contact.known || contact.own_layout || type.code == contact::ContactCode::unknown) {
      known = false;
      continue;
    }
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    take(surfaces.a);
    if (surfaces.two_sided()) take(surfaces.b);
  }
  if (!nodes.empty()) mark_parts_at(model.mesh, nodes, parts);
  return parts;
}

/// Null and spotweld materials serve other purposes, and parts without material are reported elsewhere.
bool meant_for_contact(const model::Model& model, const model::Part& part) {
  if (!part.material) return false;
  const model::Material& material = model.materials[*part.material];
  return !material.null_material && !material.spotweld;
}

/// Distance of a point from the surface of a wall, whose edges do not count.
double distance(const model::RigidWall& wall, const Vector& x) {
  const Vector from = x - wall.tail;
  switch (wall.shape) {
    case model::RigidWall::Shape::plane:
    case model::RigidWall::Shape::prism:
      return std::abs(from.dot(wall.normal));
    case model::RigidWall::Shape::cylinder:
      return std::abs((from - from.dot(wall.normal) * wall.normal).norm() - wall.radius);
    case model::RigidWall::Shape::sphere:
      return std::abs(from.norm() - wall.radius);
  }
  return model::RigidWall::infinite;
}

/// For each part the largest distance of its nodes from a wall, over the size of the part.
std::vector<double> distances_from(const model::Model& model, const model::RigidWall& wall) {
  std::vector<double> farthest(model.parts.size(), 0);
  std::vector<Eigen::AlignedBox3d> box(model.parts.size());
  const auto visit = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const PartIndex part = elements.part[e];
      if (part == none<PartIndex>) continue;
      for (const NodeIndex n : elements.nodes[e]) {
        const Vector& x = model.mesh.nodes.x[n.value];
        farthest[part.value] = std::max(farthest[part.value], distance(wall, x));
        box[part.value].extend(x);
      }
    }
  };
  visit(model.mesh.shells);
  visit(model.mesh.solids);
  visit(model.mesh.thick_shells);
  for (std::size_t p = 0; p < farthest.size(); ++p) farthest[p] /= box[p].diagonal().norm();
  return farthest;
}

/// Marks the rigid parts that lie on a rigid wall: the wall stops what meets them, and they only show where it is.
std::vector<bool> pictures_of_walls(const model::Model& model) {
  constexpr double on_it = 0.02;
  std::vector<bool> parts(model.parts.size(), false);
  for (const model::RigidWall& wall : model.rigid_walls) {
    const std::vector<double> distances = distances_from(model, wall);
    for (std::uint32_t p = 0; p < parts.size(); ++p)
      if (distances[p] < on_it && model.rigid(PartIndex{p})) parts[p] = true;
  }
  return parts;
}

std::string what(const Census& census, std::size_t part) {
  std::string text;
  const auto add = [&](std::uint32_t number, std::string_view noun) {
    if (number > 0) text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", number, noun, number == 1 ? "" : "s");
  };
  add(census.shells[part], "shell");
  add(census.solids[part], "solid");
  add(census.thick_shells[part], "thick shell");
  return text;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  if (model.contacts.empty()) return context.skipped(rule, "the deck has no contacts");
  if (context.contacts().size() < model.contacts.size())
    return context.skipped(rule, "it would take the surfaces of contacts that were not selected");
  bool known = true;
  const std::vector<bool> in_contact = parts_in_contact(context, known);
  if (!known) return context.skipped(rule, "some contacts do not tell which parts they hold");
  const Census census(model);
  const std::vector<bool> picture = pictures_of_walls(model);
  std::vector<Found> found;
  for (std::uint32_t p = 0; p < model.parts.size(); ++p)
    if (!in_contact[p] && !picture[p] && census.at(p) > 0 && meant_for_contact(model, model.parts[p]) &&
        context.part_chosen(PartIndex{p}))
      found.push_back({0, static_cast<double>(census.at(p)), p});
  const auto words = [&](const Found& f) {
    const model::Part& part = model.parts[f.item];
    Finding finding = audit::finding(
        rule,
        fmt::format("part {}{}{}{} ({}) is in no contact: whatever meets it passes through; put it into one",
                    part.id.value, part.title.empty() ? "" : " \"", part.title, part.title.empty() ? "" : "\"",
                    what(census, f.item)),
        context.path(part.place.file), part.place.line);
    finding.part = part.id.value;
    return finding;
  };
  const auto rest = [&](const Found& f, std::uint64_t count) {
    const model::Part& part = model.parts[f.item];
    return finding(rule, fmt::format("{} more parts are in no contact", count), context.path(part.place.file), 0);
  };
  add_grouped(report, std::move(found), words, rest);
}

}  // namespace

const Rule definition{
    {"GC415", "uncontacted-part", Severity::note, "a part with shells or solids is in no contact at all",
     Need::surfaces, "Whatever meets the part passes through it"},
    run};

}  // namespace gapcheck::audit::rule::uncontacted_part
