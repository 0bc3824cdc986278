#include "results/d3plot/mesh_source.hpp"

#include <filesystem>
#include <system_error>

#include "results/d3plot/d3plot.hpp"

namespace gapcheck::results {
namespace {

template <std::size_t N>
void add_parts(const D3plot& plot, const D3plot::Elements<N>& elements, MeshSource& source) {
  for (std::size_t i = 0; i < elements.nodes.size(); ++i)
    for (const std::uint32_t node : elements.nodes[i]) source.parts.try_emplace(plot.node_ids[node], elements.parts[i]);
}

}  // namespace

MeshSource mesh_source(const D3plot& plot) {
  MeshSource source;
  source.coordinates.reserve(plot.node_ids.size());
  source.parts.reserve(plot.node_ids.size());
  for (std::size_t i = 0; i < plot.node_ids.size(); ++i) {
    const auto& x = plot.coordinates[i];
    source.coordinates.try_emplace(plot.node_ids[i], x[0], x[1], x[2]);
  }
  add_parts(plot, plot.shells, source);
  add_parts(plot, plot.solids, source);
  add_parts(plot, plot.thick_shells, source);
  add_parts(plot, plot.beams, source);
  add_parts(plot, plot.particles, source);
  return source;
}

Result<MeshSource> find_mesh(const std::string& named, const std::string& beside, Diagnostics& diagnostics) {
  const auto guess = std::filesystem::path(beside).replace_filename("d3plot");
  std::error_code ignored;
  if (named.empty() && !std::filesystem::is_regular_file(guess, ignored)) return MeshSource{};
  const auto plot = read_d3plot(named.empty() ? guess.string() : named);
  if (plot) return mesh_source(plot.value());
  if (!named.empty()) return plot.error();
  // This file was not requested: what it cannot supply is treated as missing.
  diagnostics.warning(plot.error().file, plot.error().line, plot.error().message);
  return MeshSource{};
}

void add_parts(const MeshSource& mesh, Report& report) {
  const auto fill = [&](auto& record) {
    if (record.part != 0) return;
    if (const auto found = mesh.parts.find(record.node); found != mesh.parts.end()) record.part = found->second;
  };
  for (Penetration& record : report.penetrations) fill(record);
  for (TieFailure& failure : report.tie_failures) fill(failure);
}

}  // namespace gapcheck::results
