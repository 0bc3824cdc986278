#include "results/curves/intfor_history.hpp"

#include <filesystem>

namespace gapcheck::results {

SurfaceHistory read_intfor(const std::string& path, Diagnostics& diagnostics) {
  SurfaceHistory history;
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return history;
  const auto intfor = Intfor::open(path);
  if (!intfor) {
    diagnostics.warning(path, 0, intfor.error().message);
    return history;
  }
  const InterfaceMesh& mesh = intfor.value().mesh();
  history.surfaces = mesh.surfaces;
  history.forces = intfor.value().has_forces();
  for (std::size_t i = 0; i < intfor.value().times().size(); ++i) {
    const InterfaceForces state = intfor.value().read(i);
    history.states.push_back({state.time, surface_forces(mesh, state)});
  }
  return history;
}

}  // namespace gapcheck::results
