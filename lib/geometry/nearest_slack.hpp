#pragma once

/// Plain numbers only, like pair_arrays.hpp: compiled for several kinds of processors.
namespace gapcheck::geometry {

/// A point counts as the nearest of a patch if nothing on the patch can be nearer by more than these shares, of its own
/// squared distance and of the squared size. The second is the size of the proof's own rounding margins where the point
/// lies on the query, on facets up to about ten times as long as wide; without it every such pair would need a long
/// search.
inline constexpr double nearest_share_of_distance = 1e-13, nearest_share_of_size = 1e-24;

}  // namespace gapcheck::geometry
