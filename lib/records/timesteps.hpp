#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gapcheck {

/// Printed for a side that limits nothing.
inline constexpr double no_timestep_limit = 1e16;

/// One "surface timestep": the largest stable step of the springs on one side of a contact.
struct SurfaceTimestep {
  std::uint32_t contact = 0;        ///< position in Report::contacts, as in Penetration
  char side = 'A';                  ///< 'A', 'B'
  std::string type;                 ///< as printed, blanks out: "a3"
  double timestep = 0;              ///< 1e16: no limit
  std::int64_t node = 0, part = 0;  ///< controlling; 0: none known
};

/// Time steps that contact and elements allow, whether printed by the solver or computed from a deck. Zero: not known.
struct Timesteps {
  double contact_timestep = 0;                     ///< "should not exceed": the smallest of the surfaces
  double element_timestep = 0;                     ///< smallest of all elements
  std::vector<SurfaceTimestep> surface_timesteps;  ///< by contact in deck order, side A before side B
};

}  // namespace gapcheck
