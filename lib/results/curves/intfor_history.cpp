#include "results/curves/intfor_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "results/d3plot/intfor.hpp"

namespace gapcheck::results {
namespace {

/// One side of a contact, or a surface whose title names none.
EntityHistory new_surface(const InterfaceSurface& surface, bool forces) {
  EntityHistory history{"intfor", surface.contact != 0 ? "contact" : surface.title, 6, {}, {}};
  const std::string of = surface.contact != 0 ? fmt::format("side {} ", "AB"[surface.side & 1]) : "";
  history.columns.push_back({"pressure", of + "largest pressure"});
  if (forces)
    for (const char* name : {"x-force", "y-force", "z-force", "resultant force"})
      history.columns.push_back({"force", of + name});
  return history;
}

}  // namespace

void read_intfor(RunResults& run, Diagnostics& diagnostics) {
  const std::string path = run.path("intfor");
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return;
  const auto intfor = Intfor::open(path);
  if (!intfor) return diagnostics.warning(path, 0, intfor.error().message);
  const InterfaceMesh& mesh = intfor.value().mesh();
  std::vector<EntityHistory> surfaces;
  for (const InterfaceSurface& surface : mesh.surfaces)
    surfaces.push_back(new_surface(surface, intfor.value().has_forces()));
  for (std::size_t i = 0; i < intfor.value().times().size(); ++i) {
    const InterfaceForces state = intfor.value().read(i);
    const std::vector<SurfaceForce> sums = surface_forces(mesh, state);
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      const auto& f = sums[k].force;
      EntityState row{state.time, {mesh.surfaces[k].contact}, {sums[k].largest_pressure}};
      if (intfor.value().has_forces())
        row.values.insert(row.values.end(), {f[0], f[1], f[2], std::hypot(f[0], f[1], f[2])});
      surfaces[k].states.push_back(std::move(row));
    }
  }
  for (EntityHistory& history : surfaces) run.entities.push_back(std::move(history));
}

}  // namespace gapcheck::results
