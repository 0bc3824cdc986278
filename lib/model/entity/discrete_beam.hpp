#pragma once
#include <array>
#include <cstdint>

namespace gapcheck::model {

/// *SECTION_BEAM of discrete beams (ELFORM 6), in the model's units.
struct DiscreteBeamSection {
  double volume = 0;            ///< VOL
  double inertia = 0;           ///< INER
  std::int64_t system = 0;      ///< CID; 0: the third node or global axes
  double cable_area = 0;        ///< CA
  double cable_offset = 0;      ///< OFFSET
  double scoor = 0;             ///< which node turns the axes, and whether forces across get a couple
  std::array<bool, 3> fixed{};  ///< RRCON, SRCON, TRCON: the axes do not turn about r, s, t
};

/// Constants of materials 066, 067, 068 and 071, in the model's units. Six degrees of freedom: translations along r, s
/// and t, then rotations about them. Ids of curves: 0 = none. Other constants: 0 = not given.
struct DiscreteBeamMaterial {
  enum class Kind : std::uint8_t { linear, nonlinear, plastic, cable } kind = Kind::linear;
  using Six = std::array<double, 6>;
  Six stiffness{}, damping{}, preload{};
  Six failure_force{}, failure_motion{};  ///< 067, 068: at which the beam fails
  std::array<std::int64_t, 6> curve{};    ///< 067: force over displacement; 068: yield force over plastic displacement
  std::array<std::int64_t, 6> damping_curve{};     ///< 067: force over velocity
  struct Cable {                                   ///< 071
    double young = 0;                              ///< E; below zero: minus the stiffness of the whole cable
    std::int64_t curve = 0;                        ///< LCID: engineering stress over engineering strain
    double force = 0;                              ///< F0
    double end = 0, ramp = 0, start = 0;           ///< TMAXF0, TRAMP, TSTART
    double shortening = 0;                         ///< FRACL0
    double failure_strain = 0, failure_force = 0;  ///< MXEPS, MXFRC
  } cable;
};

}  // namespace gapcheck::model
