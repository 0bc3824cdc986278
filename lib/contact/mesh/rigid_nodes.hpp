#pragma once
#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// The rigid body that moves a node.
struct RigidOwner {
  enum class Kind : std::uint8_t {
    none,   ///< the node is free
    part,   ///< an element of a rigid part has it; `index`: position in Model::parts
    group,  ///< a nodal rigid body or extra nodes name it; `index`: position in Model::rigid_groups
  };
  Kind kind = Kind::none;
  std::uint32_t index = 0;
  [[nodiscard]] explicit operator bool() const { return kind != Kind::none; }
};

/// Which nodes rigid bodies move: those of rigid parts before those of *CONSTRAINED_NODAL_RIGID_BODY and
/// *CONSTRAINED_EXTRA_NODES; of several the first in the deck. Built once per model, linear in its size.
class RigidNodes {
 public:
  explicit RigidNodes(const model::Model& model);
  [[nodiscard]] RigidOwner owner(NodeIndex node) const;

 private:
  std::uint32_t parts_ = 0;
  std::vector<std::uint32_t> owner_;  // by node: 0 free, then parts, then groups; empty: all are free
};

}  // namespace gapcheck::contact
