#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "results/d3plot/intfor.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// What intfor says about the surfaces of contacts over the whole run.
struct SurfaceHistory {
  std::vector<InterfaceSurface> surfaces;
  bool forces = false;                      ///< not only pressures
  std::vector<Timed<SurfaceForce>> states;  ///< rows by surface
};

/// Reads an interface force database. Without a file the history is empty; another file is a warning.
[[nodiscard]] SurfaceHistory read_intfor(const std::string& path, Diagnostics& diagnostics);

}  // namespace gapcheck::results
