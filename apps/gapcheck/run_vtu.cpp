#include "run_vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/file_writer.hpp"
#include "solver/output/plot.hpp"

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;
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

bool is_grid(const std::string& name) {
  constexpr std::string_view begin = "state_", end = ".vtu";
  return name == "run.pvd" ||
         (name.size() > begin.size() + end.size() && name.starts_with(begin) && name.ends_with(end) &&
          name.find_first_not_of("0123456789", begin.size()) == name.size() - end.size());
}

/// Others indent their elements or write other attributes.
bool is_own_grid(const std::string& path) {
  std::string head(300, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  const auto begins_as = [&](std::string_view type, bool compressed) {
    return head.starts_with(report::vtu_begin(type, compressed));
  };
  // Earlier versions did not compress.
  return head.empty() || begins_as("UnstructuredGrid", true) || begins_as("UnstructuredGrid", false) ||
         begins_as("Collection", false);
}

}  // namespace

std::vector<std::string> grid_files(const std::string& directory) {
  const fs::path folder(directory), place = directory.empty() ? fs::path(".") : folder;
  std::vector<std::string> files;
  std::error_code failed;
  for (fs::directory_iterator entry(place, failed), end; !failed && entry != end; entry.increment(failed))
    if (const fs::path name = entry->path().filename(); is_grid(name.string()))
      files.push_back((folder / name).string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> foreign_grids(const std::string& directory) {
  std::vector<std::string> files = grid_files(directory);
  std::erase_if(files, is_own_grid);
  return files;
}

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
    if (deleted(state.deleted_beams, i)) continue;
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

Status VtuSeries::remove_old() const {
  for (const std::string& file : grid_files(directory_)) {
    std::error_code error;
    fs::remove(file, error);
    if (error) return Diagnostic{Severity::error, file, 0, "cannot be removed: " + error.message()};
  }
  return {};
}

Status VtuSeries::write(const results::D3plotState& state, const solver::Run& run) {
  if (entries_.empty())
    if (Status removed = remove_old(); !removed.ok()) return removed;
  entries_.push_back({state.time, fmt::format("state_{:04}.vtu", entries_.size() + 1)});
  const auto path = [&](const std::string& name) { return (fs::path(directory_) / name).string(); };
  if (Status written = write_file(path(entries_.back().file), report::vtu(vtu_grid(mesh_, state, run))); !written.ok())
    return written;
  return write_file(path("run.pvd"), report::pvd(entries_));
}

solver::SolverStatus VtuSeries::add(const results::D3plotState& state, const solver::Run& run) {
  const Status written = write(state, run);
  if (written.ok()) return {};
  return solver::Failure{solver::Failure::Kind::output, written.error().file + ": " + written.error().message};
}

}  // namespace gapcheck::app
