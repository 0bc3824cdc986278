#include "common/mesh.hpp"

#include <optional>
#include <utility>

#include "keyword/deck.hpp"

namespace gapcheck::app {
namespace {

template <std::size_t N>
void add_elements(const model::Model& model, const model::Elements<N>& elements, results::MeshSource& mesh) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements.part[i] == none<PartIndex>) continue;
    const std::int64_t part = model.part(elements.part[i]).id.value;
    for (const NodeIndex node : elements.nodes[i])
      if (node != none<NodeIndex>) mesh.parts.try_emplace(model.mesh.nodes.id[node.value], part);
  }
}

}  // namespace

Result<results::MeshSource> read_deck_mesh(const std::string& path, const keyword::ReadOptions& options,
                                           Diagnostics& diagnostics, std::optional<model::Model>* kept) {
  const auto deck = keyword::read_deck(path, options, diagnostics);
  if (!deck) return deck.error();
  auto read = model::read_model(deck.value(), diagnostics);
  if (!read) return read.error();
  keyword::note_missing_end(deck.value(), diagnostics);
  const model::Model& model = read.value();
  results::MeshSource mesh;
  const model::Nodes& nodes = model.mesh.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) mesh.coordinates.try_emplace(nodes.id[i], nodes.x[i]);
  add_elements(model, model.mesh.shells, mesh);
  add_elements(model, model.mesh.solids, mesh);
  add_elements(model, model.mesh.thick_shells, mesh);
  add_elements(model, model.mesh.beams, mesh);
  add_elements(model, model.mesh.discrete, mesh);
  add_elements(model, model.mesh.masses, mesh);
  add_elements(model, model.mesh.particles, mesh);
  if (kept != nullptr) *kept = std::move(read).value();
  return mesh;
}

Result<results::MeshSource> find_mesh(const MeshPlaces& places, Diagnostics& diagnostics,
                                      std::optional<model::Model>* model) {
  if (!places.deck.empty()) return read_deck_mesh(places.deck, places.deck_options, diagnostics, model);
  return results::find_mesh(places.d3plot, places.beside, diagnostics);
}

report::NodePosition positions(const results::MeshSource& mesh) {
  return [&mesh](std::int64_t node) -> std::optional<Vector> {
    const auto found = mesh.coordinates.find(node);
    if (found == mesh.coordinates.end()) return std::nullopt;
    return found->second;
  };
}

}  // namespace gapcheck::app
