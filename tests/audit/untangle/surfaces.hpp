#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audit/fix/plates.hpp"
#include "audit/untangle/crossing_pairs.hpp"
#include "audit/untangle/cut_surface.hpp"
#include "keyword/deck.hpp"

namespace gapcheck::audit_test {

/// A deck's model with the surfaces of its first contact.
struct ContactScene {
  explicit ContactScene(const std::string& text) {
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
    model.emplace(std::move(model::read_model(deck.value(), diagnostics)).value());
    store.emplace(*model);
    surface.emplace(store->at(ContactIndex{0}).a, model->mesh, model->mesh.nodes.x);
  }
  [[nodiscard]] NodeIndex node(std::int64_t id) const { return NodeIndex{*model->mesh.nodes.lookup.find(id)}; }
  [[nodiscard]] std::vector<std::int64_t> ids(const std::vector<NodeIndex>& nodes) const {
    std::vector<std::int64_t> list;
    for (const NodeIndex n : nodes) list.push_back(model->mesh.nodes.id[n.value]);
    return list;
  }
  [[nodiscard]] audit::ElementOfKind shell(std::int64_t id) const {
    const auto& all = model->mesh.shells.id;
    for (std::uint32_t i = 0; i < all.size(); ++i)
      if (all[i] == id) return {model::ElementKind::shell, i};
    ADD_FAILURE() << "no shell " << id;
    return {};
  }
  [[nodiscard]] std::vector<audit::ElementPair> crossings() {
    std::vector<audit::ElementPair> list;
    for (const auto& c : audit::contact_crossings(*model, *store, model->mesh.nodes.x)) list.push_back(c.elements);
    return list;
  }

  std::optional<model::Model> model;
  std::optional<contact::SurfaceStore> store;
  std::optional<audit::CutSurface> surface;
};

/// A plate of part 1 in the plane z = 0, and a plate of part 2 that stands upright (z up) on a line parallel to y, from
/// height `low` on. Sides of 5; `nx`, `ny` of each.
inline std::string upright_deck(const Plate& flat, double x, double y, double low, int columns, int rows,
                                double height = 5) {
  std::string nodes, elements;
  const auto node = [&](int i, int j) { return 2001 + j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      nodes += fmt::format("{:8}{:16}{:16}{:16}\n", node(i, j), x, y + 5.0 * i, low + height * j);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      elements += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", 2001 + j * columns + i, 2, node(i, j), node(i + 1, j),
                              node(i + 1, j + 1), node(i, j + 1));
  return "*KEYWORD\n" + elastic_steel + flat.deck() + "*PART\nupright\n         2         1         1\n*NODE\n" +
         nodes + "*ELEMENT_SHELL\n" + elements + single_surface + "*END\n";
}

}  // namespace gapcheck::audit_test
