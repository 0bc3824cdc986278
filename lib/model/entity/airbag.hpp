#pragma once
#include <cstdint>
#include <string>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *AIRBAG_SIMPLE_PRESSURE_VOLUME and *AIRBAG_SIMPLE_AIRBAG_MODEL: a control volume inside a closed surface. In the
/// model's units but for curves, whose values are as written.
struct Airbag {
  enum class Kind : std::uint8_t {
    pressure_volume,  ///< a pressure by the volume
    simple,           ///< an ideal gas with inflow and exit
  } kind = Kind::pressure_volume;
  std::string keyword, title;
  std::int64_t id = 0;                          ///< as written; without one its place among the deck's airbags
  std::int64_t set = 0;                         ///< SID
  bool parts = false;                           ///< SIDTYP: of parts, not of segments
  std::int64_t sensor = 0;                      ///< RBID
  double volume_scale = 1, pressure_scale = 1;  ///< VSCA, PSCA
  double excluded = 0;                          ///< VINI: taken off the scaled volume
  double damping = 0, stagnation = 0;           ///< MWD, SPSF
  std::int64_t curve = 0;                       ///< LCID: pressure over relative volume; mass flow in over time
  // Of a pressure by the volume.
  double coefficient = 0;              ///< CN
  std::int64_t coefficient_curve = 0;  ///< -CN: CN over time
  double factor = 0;                   ///< BETA
  // Of a gas.
  double heat_volume = 0, heat_pressure = 0;     ///< CV, CP: per mass and temperature
  double temperature = 0;                        ///< T, of what flows in
  double shape = 0, area = 0;                    ///< MU, AREA of the exit
  std::int64_t shape_curve = 0, area_curve = 0;  ///< -MU, -AREA: over the absolute pressure
  double pressure = 0, density = 0;              ///< PE, RO: ambient
  std::int64_t exit_curve = 0;                   ///< LOU: mass flow out over the pressure above PE
  // Factors from the units of the airbag's file.
  double pressure_unit = 1, flow_unit = 1, area_unit = 1;
  Place place;
};

}  // namespace gapcheck::model
