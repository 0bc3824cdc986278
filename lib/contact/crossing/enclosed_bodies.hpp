#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "contact/crossing/crossings.hpp"

namespace gapcheck::contact {

/// A body of solids that lies completely inside a body of another part. A body is a set of elements of one part
/// connected by nodes.
struct EnclosedBody {
  PartIndex inner = none<PartIndex>, outer = none<PartIndex>;
  std::uint32_t first_solid = 0;  ///< lowest position in Mesh::solids of the inner body
  std::uint32_t solids = 0;       ///< how many the inner body has
  ContactIndex contact;           ///< what `acts_on` gave
  Vector point = Vector::Zero();  ///< a node of the inner body inside the outer one
};

/// The first contact that acts on two parts, or none<ContactIndex>. Asked only for parts where a body of one is in the
/// box of a body of the other.
using PairContact = std::function<ContactIndex(PartIndex inner, PartIndex outer)>;

/// All enclosed bodies of two different parts, ascending by first solid, then by outer part. Bodies that share a node
/// or whose faces cross are not enclosed, nor are Eulerian or ALE parts (ELFORM 5, 6, 7, 11, 12). Decided exactly,
/// faces with four nodes as two triangles. Parts whose box meets no other cost one pass over their nodes.
[[nodiscard]] std::vector<EnclosedBody> find_enclosed_bodies(const model::Model& model, const PairContact& acts_on,
                                                             const CrossingOptions& options,
                                                             CrossingCounters& counters);

}  // namespace gapcheck::contact
