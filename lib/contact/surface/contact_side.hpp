#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include "base/weak_cache.hpp"
#include "contact/surface/surface.hpp"

namespace gapcheck::contact {

/// One side of a contact with its thickness.
struct ContactSide {
  Selection selection;
  TrackedNodes nodes;        ///< of side B only in contacts that look for side B's nodes
  bool nodes_only = false;   ///< it has nodes and no segments
  bool names_nodes = false;  ///< for that reason; false where a box has left elements without segments
  /// `selection.segments` ends with this many beam axes; only single-surface contacts keep any.
  std::size_t lines = 0;
  bool beams_alone = false;  ///< all that it names are beams
  /// By node of the mesh: the connected body of solids that it belongs to; null: no segment is a face of one.
  std::shared_ptr<const std::vector<std::uint32_t>> bodies;
};

/// All that a side depends on besides the model and the coordinates.
struct SideRequest {
  model::SurfaceInput input;
  ThicknessSide thickness;
  double negative = 0;      ///< thickness of everything on the side, negative as written; 0: none
  bool offsets = false;     ///< mid-surface offsets count
  bool single = false;      ///< single-surface contact
  bool tied = false;        ///< of family tied
  bool transducer = false;  ///< measures at spotweld beams too
  bool edges = false;       ///< beam axes are segments
  bool spotwelds = false;   ///< those of spotwelds too
  bool tracks_nodes = false;
  bool needs_segments = false;
  bool symmetry = false;  ///< faces on planes of symmetry are left out (ISYM)
};

[[nodiscard]] ContactSide build_side(const model::Model& model, const SideRequest& request, const ContactType& type,
                                     const std::vector<Vector>& x, MeshIndex& index);

/// The sides in use that were built on one set of coordinates: contacts that ask for the same share it. Does not keep
/// them. Not for use from several threads.
class SideCache {
 public:
  /// As build_side(); `x` and `index`: the same in all calls.
  [[nodiscard]] std::shared_ptr<const ContactSide> side(const model::Model& model, const SideRequest& request,
                                                        const ContactType& type, const std::vector<Vector>& x,
                                                        MeshIndex& index);
  /// To be called when coordinates have changed.
  void clear() { sides_.clear(); }

 private:
  using Key = std::array<std::uint64_t, 12>;
  static Key key_of(const SideRequest& request);

  WeakCache<Key, ContactSide> sides_;
};

}  // namespace gapcheck::contact
