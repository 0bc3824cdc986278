#pragma once
#include <cstdint>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// The parts that a side of a contact consists of: those of its segments; of a side of nodes alone those of its tracked
/// nodes. Ascending, each once.
[[nodiscard]] std::vector<PartIndex> parts_of(const model::Model& model, const ContactSide& side);

/// True if a side is made of whole parts: given by parts, and not cut by a box.
[[nodiscard]] bool whole_parts(const model::SurfaceInput& input);

/// Mean length of the edges of a side: of its segments; of a side of nodes alone those of all shells and solids between
/// its nodes. 0 where it has none.
[[nodiscard]] double mean_edge(const model::Model& model, const ContactSide& side);

/// A segment that runs round against its neighbours.
struct Misoriented {
  std::uint32_t segment = 0;
  PartIndex part = none<PartIndex>;
};
/// Segments whose normal disagrees with that of their neighbours: two segments at a common edge that run along it in the
/// same direction. Of each connected surface the smaller lot is taken; of equal ones that without the first segment.
/// Edges with more than two segments connect nothing. Ascending; n log n.
[[nodiscard]] std::vector<Misoriented> misoriented_segments(const model::Mesh& mesh, const Segments& segments);

}  // namespace gapcheck::contact
