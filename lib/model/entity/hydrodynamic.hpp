#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace gapcheck::model {

/// What material 009 says of solids besides its density; stresses in the model's units.
struct Fluid {
  double pc = 0;                ///< pressure cutoff
  double mu = 0;                ///< dynamic viscosity
  double terod = 0, cerod = 0;  ///< relative volumes at which solids go; 0: they do not
};

/// Material 010, elastic and plastic with the pressure of an equation of state; stresses in the model's units.
struct Hydro {
  double shear = 0, sigy = 0, eh = 0, pc = 0, fs = 0, charl = 0;
  double a1 = 0, a2 = 0, spall = 0;                ///< of _SPALL
  std::vector<std::array<double, 2>> points = {};  ///< EPSi, ESi as far as they are used
  bool stochastic = false;                         ///< _STOCHASTIC
};

/// Materials 015 and 098 after Johnson and Cook, in the model's units. Zero = not given.
struct JohnsonCook {
  bool simplified = false;  ///< 098: no temperature, no failure by D1 … D5
  double shear = 0;         ///< G of 015
  double vp = 0, rateop = 0, dtf = 0;
  double a = 0, b = 0, n = 0, c = 0, m = 0;
  double melting = 0, room = 0;  ///< TM, TR
  double rate = 0;               ///< EPSO
  double heat = 0;               ///< CP, per mass
  double pc = 0, spall = 0, iterate = 0;
  std::array<double, 5> d{};
  double c2p = 0, erod = 0, efmin = 0, numint = 0;
  double failure_strain = 0, most_stress = 0, saturation = 0;  ///< PSFAIL, SIGMAX, SIGSAT of 098
};

}  // namespace gapcheck::model
