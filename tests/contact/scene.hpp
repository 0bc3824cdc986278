#pragma once
#include <array>
#include <string>
#include <vector>

#include "contact/initial.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// A model built by hand, without any keyword text.
struct Scene {
  model::Model model;

  /// A shell (thickness) or solid part; returns its position.
  PartIndex part(std::int64_t id, double thickness) {
    model::Section section;
    section.id = id;
    section.kind = model::SectionKind::shell;
    section.thickness.fill(thickness);
    model.sections.push_back(section);
    model::Part p;
    p.id = PartId{id};
    p.section = static_cast<std::uint32_t>(model.sections.size() - 1);
    model.parts.push_back(p);
    const PartIndex index{static_cast<std::uint32_t>(model.parts.size() - 1)};
    model.part_of_id[id] = index;
    return index;
  }

  /// Gives a part a new material with these constants; returns it for changes.
  model::Material& material(PartIndex part, double density, double bulk = 0, double young = 0, double poisson = 0) {
    model::Material& m = model.materials.emplace_back();
    m.density = density;
    m.bulk = bulk;
    m.young = young;
    m.poisson = poisson;
    model.parts[part.value].material = static_cast<std::uint32_t>(model.materials.size() - 1);
    return m;
  }

  NodeIndex node(const Vector& x) {
    auto& nodes = model.mesh.nodes;
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.id.push_back(index + 1);
    nodes.x.push_back(x);
    nodes.line.push_back(0);
    return NodeIndex{index};
  }

  void shell(PartIndex part, const model::SegmentNodes& nodes) {
    auto& shells = model.mesh.shells;
    shells.id.push_back(static_cast<std::int64_t>(shells.size()) + 1);
    shells.nodes.push_back(nodes);
    shells.part.push_back(part);
    shells.line.push_back(0);
  }

  void solid(PartIndex part, const std::array<NodeIndex, 8>& nodes) {
    auto& solids = model.mesh.solids;
    solids.id.push_back(static_cast<std::int64_t>(solids.size()) + 1);
    solids.nodes.push_back(nodes);
    solids.part.push_back(part);
    solids.line.push_back(0);
  }

  /// n × m quads from `corner` along two edge vectors; returns the nodes, row by row.
  std::vector<NodeIndex> plate(PartIndex p, const Vector& corner, const Vector& u, const Vector& v, std::uint32_t n,
                               std::uint32_t m) {
    std::vector<NodeIndex> nodes;
    for (std::uint32_t j = 0; j <= m; ++j)
      for (std::uint32_t i = 0; i <= n; ++i) nodes.push_back(node(corner + i * u + j * v));
    for (std::uint32_t j = 0; j < m; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = j * (n + 1) + i;
        shell(p, {nodes[a], nodes[a + 1], nodes[a + n + 2], nodes[a + n + 1]});
      }
    return nodes;
  }

  /// An axis-aligned brick.
  void brick(PartIndex p, const Vector& low, const Vector& size) {
    std::array<NodeIndex, 8> n{};
    const auto at = [&](double i, double j, double k) { return node(low + size.cwiseProduct(Vector(i, j, k))); };
    n = {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
    solid(p, n);
  }

  model::Contact& contact(const std::string& keyword) {
    model::Contact c;
    set_name("CONTACT_" + keyword, c);
    c.order = static_cast<std::uint32_t>(model.contacts.size()) + 1;
    c.id = ContactId{c.order};
    c.a = {0, 2, 0, true};
    model.contacts.push_back(c);
    return model.contacts.back();
  }

  InitialState run(InitialOptions options = {}) {
    InitialCounters counters;
    SurfaceStore surfaces(model);
    return initialise_contacts(model, surfaces, options, counters);
  }
};

}  // namespace gapcheck::contact
