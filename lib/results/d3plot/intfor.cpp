#include "results/d3plot/intfor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/file_bytes.hpp"
#include "base/number.hpp"
#include "results/d3plot/d3plot_header.hpp"
#include "results/d3plot/intfor_write.hpp"

namespace gapcheck::results {
namespace {

constexpr std::uint64_t pressure_values = 4, force_values = 16;
constexpr std::int64_t titles_of_parts = 90001;
constexpr std::uint64_t side_title_bytes = 72;

/// The titles behind the geometry, by surface number. Nothing of them is trusted beyond the end of the file.
std::map<std::int64_t, std::string> titles_behind(std::string_view bytes, WordForm form, std::uint64_t at) {
  std::map<std::int64_t, std::string> titles;
  const std::uint64_t words = bytes.size() / form.bytes, each = 1 + side_title_bytes / form.bytes;
  const auto integer = [&](std::uint64_t word) { return words::integer(bytes.data() + word * form.bytes, form); };
  if (at + 3 > words || words::real(bytes.data() + at * form.bytes, form) != d3plot_end ||
      integer(at + 1) != titles_of_parts)
    return titles;
  const std::int64_t count = integer(at + 2);
  at += 3;
  for (std::int64_t i = 0; i < count && at + each <= words; ++i, at += each)
    titles.emplace(integer(at), trimmed(bytes.substr((at + 1) * form.bytes, side_title_bytes)));
  return titles;
}

}  // namespace

Result<Intfor> Intfor::open(const std::string& path) {
  auto states = D3plotStates::open(path, DatabaseKind::interface_forces);
  if (!states) return states.error();
  Intfor intfor(std::move(states).value());
  const D3plot& mesh = intfor.states_.mesh();
  const std::uint64_t values = intfor.states_.layout().shell_words;
  if (mesh.shells.ids.empty() || values < pressure_values)
    return Diagnostic{Severity::error, path, 0,
                      fmt::format("has {} segments with {} values; an interface force database has four and more",
                                  mesh.shells.ids.size(), values)};
  intfor.has_forces_ = values >= force_values;
  intfor.mesh_.title = mesh.title;
  intfor.mesh_.node_ids = mesh.node_ids;
  intfor.mesh_.coordinates = mesh.coordinates;
  intfor.mesh_.segments = mesh.shells.nodes;
  std::map<std::int64_t, std::string> titles;
  if (const auto file = FileBytes::open(path))
    if (const auto header = read_d3plot_header(file.value().bytes()); header && mesh.geometry_words > 0)
      titles = titles_behind(file.value().bytes(), header->form, mesh.geometry_words);
  std::map<std::int64_t, std::uint32_t> position;
  for (const std::int64_t part : mesh.shells.parts) {
    const auto [found, is_new] = position.try_emplace(part, static_cast<std::uint32_t>(intfor.mesh_.surfaces.size()));
    intfor.mesh_.surface_of.push_back(found->second);
    if (!is_new) continue;
    const std::string title = titles[part];
    InterfaceSurface surface = surface_of_title(title);
    if (surface.contact == 0) surface.title = title.empty() ? fmt::format("surface {}", part) : title;
    intfor.mesh_.surfaces.push_back(std::move(surface));
  }
  return {std::move(intfor)};
}

InterfaceForces Intfor::read(std::size_t i) const {
  const D3plotState plot = states_.read(i);
  InterfaceForces state;
  state.time = plot.time;
  state.coordinates = plot.coordinates;
  state.velocities = plot.velocities;
  state.segments.resize(mesh_.segments.size());
  const std::uint64_t width = states_.layout().shell_words;
  const std::vector<double> values = states_.shell_words(i);
  for (std::size_t k = 0; k < state.segments.size() && (k + 1) * width <= values.size(); ++k) {
    const double* const of = values.data() + k * width;
    SegmentForce& segment = state.segments[k];
    segment.pressure = of[0];
    segment.shear = of[1];
    segment.shear_r = of[2];
    segment.shear_s = of[3];
    if (has_forces_)
      for (std::size_t corner = 0; corner < 4; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis)
          segment.force[corner][axis] = of[pressure_values + 3 * corner + axis];
  }
  return state;
}

std::vector<SurfaceForce> surface_forces(const InterfaceMesh& mesh, const InterfaceForces& state) {
  std::vector<SurfaceForce> sums(mesh.surfaces.size());
  for (std::size_t i = 0; i < state.segments.size(); ++i) {
    SurfaceForce& sum = sums[mesh.surface_of[i]];
    sum.largest_pressure = std::max(sum.largest_pressure, state.segments[i].pressure);
    for (const auto& force : state.segments[i].force)
      for (std::size_t axis = 0; axis < 3; ++axis) sum.force[axis] += force[axis];
  }
  return sums;
}

}  // namespace gapcheck::results
