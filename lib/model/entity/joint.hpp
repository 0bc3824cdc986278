#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *CONSTRAINED_JOINT_…: two rigid bodies, A with the nodes N1, N3, N5 and B with N2, N4, N6. N1 and N2 coincide.
struct Joint {
  enum class Kind : std::uint8_t {
    spherical,      ///< N1 and N2 stay together
    revolute,       ///< and the bodies turn about N1 N3
    cylindrical,    ///< and slide along it
    planar,         ///< slides across N1 N3, turns about it
    universal,      ///< N1 N3 and N2 N4 keep their angle
    translational,  ///< slides along N1 N3
  };
  Kind kind = Kind::spherical;
  std::string keyword;
  std::int64_t id = 0;                  ///< given, or the joint's position among the joints of the deck, from 1
  std::array<std::int64_t, 6> nodes{};  ///< as written; 0: none
  double stiffness = 1;                 ///< RPS, of penalties
  double damping = 1;                   ///< DAMP
  Place place;
};

}  // namespace gapcheck::model
