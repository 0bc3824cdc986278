#pragma once
#include <cstdint>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// The parts of a side of a contact: those of its segments; for a side of only nodes those of its tracked nodes.
/// Ascending, each once.
[[nodiscard]] std::vector<PartIndex> parts_of(const model::Model& model, const ContactSide& side);

/// True if a side consists of whole parts: given by parts, and not cut by a box.
[[nodiscard]] bool whole_parts(const model::SurfaceInput& input);

/// Mean length of the edges of a side: of its segments; for a side of only nodes those of all shells and solids between
/// its nodes. 0 without any.
[[nodiscard]] double mean_edge(const model::Model& model, const ContactSide& side);

/// A segment oriented against its neighbours.
struct Misoriented {
  SegmentIndex segment;
  PartIndex part = none<PartIndex>;
};
/// Segments whose normal disagrees with that of their neighbours: two segments run along a common edge in the same
/// direction. In each connected surface the smaller group counts; of equal ones that without the first segment. Edges
/// with more than two segments connect nothing. Ascending; n log n.
[[nodiscard]] std::vector<Misoriented> misoriented_segments(const model::Mesh& mesh, const Segments& segments);

}  // namespace gapcheck::contact
