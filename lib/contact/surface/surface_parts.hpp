#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// The parts of a side of a contact: those of its segments; for a side of only nodes those of its tracked nodes.
/// Ascending, each once.
[[nodiscard]] std::vector<PartIndex> parts_of(const model::Model& model, const ContactSide& side);

/// True if a side consists of whole parts: given by parts, and not cut by a box.
[[nodiscard]] bool whole_parts(const model::SurfaceInput& input);

/// Mean length of the edges of a side: of its segments; for a side of only nodes those of all shells, solids and thick
/// shells between its nodes. 0 without any.
[[nodiscard]] double mean_edge(const model::Model& model, const ContactSide& side);

/// Segments that hang together by edges; edges with more than two segments connect nothing.
struct ConnectedSurface {
  std::vector<SegmentIndex> segments;  ///< beginning with the first one
  /// Those whose normal disagrees with that of their neighbours: two segments run along a common edge in the same
  /// direction. The smaller group counts; of equal ones that without the first segment.
  std::vector<SegmentIndex> turned;
};
/// Calls visit(surface) for every connected surface, by its first segment; a surface is valid only during the call.
/// n log n.
void for_each_connected_surface(const Segments& segments, const std::function<void(const ConnectedSurface&)>& visit);

/// A segment oriented against its neighbours.
struct Misoriented {
  SegmentIndex segment;
  PartIndex part = none<PartIndex>;
};
/// The turned segments of all connected surfaces, ascending.
[[nodiscard]] std::vector<Misoriented> misoriented_segments(const model::Mesh& mesh, const Segments& segments);

}  // namespace gapcheck::contact
