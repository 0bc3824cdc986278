#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/pair/pair.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/neighbour_cache.hpp"

namespace gapcheck::contact {

/// One side's nodes against the other side's segments, with the data that the scene of their pairs refers to. Which
/// oriented shells face the wrong way is not set (PairScene::flipped). All references must outlive it.
class SideScene {
 public:
  /// `exchanged`: side B's nodes against side A's segments; single-surface contacts have side A alone. `x`: coordinates
  /// by node, read whenever a pair is decided. `shared`: neighbours of other contacts of this model; null: none.
  SideScene(const model::Model& model, ContactIndex contact, const ContactSurfaces& surfaces, bool exchanged,
            const std::vector<Vector>& x, NeighbourCache* shared = nullptr);
  SideScene(const SideScene&) = delete;
  SideScene& operator=(const SideScene&) = delete;

  [[nodiscard]] const ContactSide& tracked() const { return tracked_; }
  [[nodiscard]] const ContactSide& reference() const { return reference_; }
  [[nodiscard]] const Neighbours& neighbours() const { return *neighbours_; }
  [[nodiscard]] const PairScene& scene() const { return scene_; }
  [[nodiscard]] PairScene& scene() { return scene_; }

 private:
  const ContactSide &tracked_, &reference_;
  std::shared_ptr<const Neighbours> neighbours_;
  std::shared_ptr<const Neighbours> own_;  ///< of the tracked side, where solids meet solids of another side
  PairScene scene_;
};

}  // namespace gapcheck::contact
