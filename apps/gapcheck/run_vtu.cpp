#include "run_vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "solver/output/plot.hpp"

namespace gapcheck::app {
namespace {

using report::VtuArray;
using report::VtuGrid;

/// Per node the data of the contact with the deepest penetration there, and the forces of all contacts.
void add_contacts(const solver::Run& run, VtuGrid& grid) {
  const std::vector<double> none(grid.points.size(), 0.0);
  VtuArray penetration{"contact_penetration", 1, none};
  VtuArray pressure{"contact_pressure", 1, none};
  VtuArray state{"contact_state", 1, none, true};
  VtuArray force{"contact_force", 3, std::vector<double>(3 * grid.points.size(), 0.0)};
  const auto add = [&](const solver::ContactPoint& point, const Vector& on_it) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        force.values[std::size_t{3} * point.nodes[i].value + axis] += point.weights[i] * on_it[static_cast<int>(axis)];
  };
  std::vector<solver::ContactLink> links;
  for (const solver::ContactView& contact : run.contacts()) {
    links.clear();
    contact.source->links(contact.position, links);
    for (const solver::ContactLink& link : links) {
      add(link.tracked, link.force);
      add(link.reference, -link.force);
    }
    for (const solver::ContactNode& node : contact.nodes()) {
      const std::uint32_t at = node.node.value;
      if (state.values[at] != 0 && node.penetration <= penetration.values[at]) continue;
      penetration.values[at] = node.penetration;
      pressure.values[at] = node.pressure;
      state.values[at] = 1 + static_cast<double>(node.kind);
    }
  }
  for (VtuArray* array : {&penetration, &pressure, &state, &force}) grid.point_data.push_back(std::move(*array));
}

/// The cells' arrays; each element adds one entry to all of them.
struct CellData {
  VtuArray part{"part", 1, {}, true}, element{"element", 1, {}, true}, thickness{"thickness", 1, {}};
  VtuArray plastic{"plastic_strain", 1, {}}, stress{"stress", 6, {}};

  void add(std::int64_t part_id, std::int64_t id, double thick, double strain, const std::array<double, 6>& s) {
    part.values.push_back(static_cast<double>(part_id));
    element.values.push_back(static_cast<double>(id));
    thickness.values.push_back(thick);
    plastic.values.push_back(strain);
    stress.values.insert(stress.values.end(), s.begin(), s.end());
  }
};

}  // namespace

VtuGrid vtu_grid(const results::D3plot& mesh, const results::D3plotState& state, const solver::Run& run) {
  VtuGrid grid;
  grid.points = state.coordinates;
  CellData cells;
  const auto deleted = [](const std::vector<bool>& list, std::size_t i) { return i < list.size() && list[i]; };
  for (std::size_t i = 0; i < mesh.shells.ids.size(); ++i) {
    if (deleted(state.deleted_shells, i)) continue;
    grid.add_cell(mesh.shells.nodes[i]);
    double strain = 0;
    for (std::size_t k = 0; k < state.layers; ++k)
      strain = std::max(strain, state.shell_points[i * state.layers + k].plastic_strain);
    cells.add(mesh.shells.parts[i], mesh.shells.ids[i], state.shells[i].thickness, strain,
              state.shell_points[i * state.layers].stress);
  }
  for (std::size_t i = 0; i < mesh.solids.ids.size(); ++i) {
    if (deleted(state.deleted_solids, i)) continue;
    grid.add_cell(mesh.solids.nodes[i]);
    cells.add(mesh.solids.parts[i], mesh.solids.ids[i], 0, state.solids[i].plastic_strain, state.solids[i].stress);
  }
  for (std::size_t i = 0; i < mesh.beams.ids.size(); ++i) {
    grid.add_cell(mesh.beams.nodes[i]);
    cells.add(mesh.beams.parts[i], mesh.beams.ids[i], 0, 0, {});
  }
  VtuArray displacement{"displacement", 3, {}}, velocity{"velocity", 3, {}}, node{"node", 1, {}, true};
  for (std::size_t i = 0; i < grid.points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      displacement.values.push_back(state.coordinates[i][k] - mesh.coordinates[i][k]);
      velocity.values.push_back(state.velocities[i][k]);
    }
  for (const std::int64_t id : mesh.node_ids) node.values.push_back(static_cast<double>(id));
  grid.point_data = {std::move(displacement), std::move(velocity), std::move(node)};
  add_contacts(run, grid);
  grid.cell_data = {std::move(cells.part), std::move(cells.element), std::move(cells.thickness),
                    std::move(cells.plastic), std::move(cells.stress)};
  return grid;
}

VtuSeries::VtuSeries(const solver::Run& run, std::string directory)
    : directory_(std::move(directory)), mesh_(solver::plot_mesh(run.model(), run.initial().x)) {}

solver::SolverStatus VtuSeries::add(const results::D3plotState& state, const solver::Run& run) {
  entries_.push_back({state.time, fmt::format("state_{:04}.vtu", entries_.size() + 1)});
  const auto write = [&](const std::string& name, const std::string& text) {
    return write_file((std::filesystem::path(directory_) / name).string(), text);
  };
  Status written = write(entries_.back().file, report::vtu(vtu_grid(mesh_, state, run)));
  if (written.ok()) written = write("run.pvd", report::pvd(entries_));
  if (written.ok()) return {};
  const Diagnostic& error = written.error();
  return solver::Failure{solver::Failure::Kind::output, error.file + ": " + error.message};
}

}  // namespace gapcheck::app
