#pragma once
#include <cstdint>

#include "model/entity/mesh.hpp"
#include "solver/interface/contact_source.hpp"
#include "solver/interface/contact_spring.hpp"

namespace gapcheck::solver {

/// A node that a penalty contact holds off a segment at the moment.
struct Touch {
  NodeIndex node;
  ContactPoint point;  ///< of the segment
  model::ElementKind element_kind = model::ElementKind::shell;
  std::uint32_t element = no_position;  ///< of the segment; or no_position
  PartIndex segment_part = none<PartIndex>;
  Vector push = Vector::Zero();  ///< of the spring on the node
  double depth = 0;              ///< that gives the push
  ContactSprings::Spring spring;
};

}  // namespace gapcheck::solver
