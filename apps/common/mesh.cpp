#include "common/mesh.hpp"

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "keyword/deck.hpp"
#include "results/d3plot/d3plot.hpp"

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

Result<results::MeshSource> read_deck_mesh(const std::string& path, Diagnostics& diagnostics,
                                           std::optional<model::Model>* kept) {
  const auto deck = keyword::read_deck(path, {}, diagnostics);
  if (!deck) return deck.error();
  auto read = model::read_model(deck.value(), diagnostics);
  if (!read) return read.error();
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

Result<results::MeshSource> find_mesh(const std::string& deck, const std::string& d3plot, const std::string& beside,
                                      Diagnostics& diagnostics, std::optional<model::Model>* model) {
  if (!deck.empty()) return read_deck_mesh(deck, diagnostics, model);
  const auto guess = std::filesystem::path(beside).replace_filename("d3plot");
  std::error_code ignored;
  if (d3plot.empty() && !std::filesystem::is_regular_file(guess, ignored)) return results::MeshSource{};
  const auto plot = results::read_d3plot(d3plot.empty() ? guess.string() : d3plot);
  if (plot) return results::mesh_source(plot.value());
  if (!d3plot.empty()) return plot.error();
  // Nobody asked for this file: what it cannot give is missing as if it were not there.
  diagnostics.warning(plot.error().file, plot.error().line, plot.error().message);
  return results::MeshSource{};
}

void add_parts(Report& report, const results::MeshSource& mesh) {
  const auto fill = [&](auto& record) {
    if (record.part != 0) return;
    if (const auto found = mesh.parts.find(record.node); found != mesh.parts.end()) record.part = found->second;
  };
  for (Penetration& record : report.penetrations) fill(record);
  for (TieFailure& failure : report.tie_failures) fill(failure);
}

report::NodePosition positions(const results::MeshSource& mesh) {
  return [&mesh](std::int64_t node) -> std::optional<Vector> {
    const auto found = mesh.coordinates.find(node);
    if (found == mesh.coordinates.end()) return std::nullopt;
    return found->second;
  };
}

}  // namespace gapcheck::app
