#pragma once
#include <array>
#include <string>

#include "base/vector.hpp"

namespace gapcheck::model {

/// Materials 002 and 034, in the model's units. Zero = not given.
struct Orthotropic {
  double ea = 0, eb = 0, ec = 0;
  double prba = 0, prca = 0, prcb = 0;
  double gab = 0, gbc = 0, gca = 0;
  double aopt = 0;
  Vector a = Vector::Zero(), d = Vector::Zero(), v = Vector::Zero();
  double beta = 0;            ///< degrees
  bool fabric = false;        ///< 034
  bool only_tension = false;  ///< CSE = 1
  std::string unread;         ///< the first field that is not calculated
};

}  // namespace gapcheck::model
