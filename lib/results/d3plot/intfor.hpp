#pragma once
#include <string>
#include <vector>

#include "base/result.hpp"
#include "results/d3plot/d3plot_states.hpp"
#include "results/d3plot/interface_forces.hpp"

namespace gapcheck::results {

/// An interface force database and its file family, of gapcheck or LS-DYNA: the geometry is read on opening with the
/// care of read_d3plot(), the states one by one. Segments need the first four values (pressure, shear stress, its
/// components) and have forces on their corners if there are 16 or more; what follows is skipped. Where titles do not
/// name a contact, InterfaceSurface::contact is 0 and the title that of the file, or "surface N".
class Intfor {
 public:
  static Result<Intfor> open(const std::string& path);

  [[nodiscard]] const InterfaceMesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<double>& times() const { return states_.times(); }
  [[nodiscard]] bool has_forces() const { return has_forces_; }
  /// State i < times().size().
  [[nodiscard]] InterfaceForces read(std::size_t i) const;

 private:
  explicit Intfor(D3plotStates states) : states_(std::move(states)) {}

  D3plotStates states_;
  InterfaceMesh mesh_;
  bool has_forces_ = false;
};

/// Of one surface at one time.
struct SurfaceForce {
  double largest_pressure = 0;
  std::array<double, 3> force{};  ///< sum over the corners of its segments
};
/// By surface of the mesh.
[[nodiscard]] std::vector<SurfaceForce> surface_forces(const InterfaceMesh& mesh, const InterfaceForces& state);

}  // namespace gapcheck::results
