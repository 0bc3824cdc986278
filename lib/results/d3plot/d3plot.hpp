#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "results/d3plot/mesh_source.hpp"

namespace gapcheck::results {

/// Geometry of a d3plot database: the undeformed mesh before its states. Arrays in file order; every position and part
/// is checked, node ids are positive and unique, coordinates finite.
struct D3plot {
  std::string title;
  int word_bytes = 4;  ///< 4 or 8
  /// Where the numbering ends, in words from the start of the family; 0: unread sections follow.
  std::uint64_t geometry_words = 0;
  std::vector<std::int64_t> node_ids;
  std::vector<std::array<double, 3>> coordinates;  ///< beside node_ids
  std::vector<std::int64_t> part_ids;  ///< by the number that the file gives the part; empty: the numbers are the ids
  template <std::size_t N>
  struct Elements {
    std::vector<std::int64_t> ids;
    std::vector<std::array<std::uint32_t, N>> nodes;  ///< positions in node_ids
    std::vector<std::int64_t> parts;                  ///< part ids of the user
  };
  Elements<8> solids, thick_shells;
  Elements<2> beams;
  Elements<4> shells;
  Elements<1> particles;  ///< SPH; the ids are those of their nodes
};

/// What a database of the family is.
enum class DatabaseKind : std::uint8_t {
  plot,             ///< d3plot, d3part, d3eigv
  interface_forces  ///< intfor: the shells are segments
};

/// Reads the geometry of a d3plot (single or double precision, either byte order; a file family is found from its first
/// file). No count of the header is trusted before it is compared with the file's size; memory stays within a small
/// multiple of it. Errors name what is wrong: truncated, damaged, compressed (FEMZIP, gzip), not a d3plot. Limits:
/// two-dimensional models get z = 0, a node number 0 in an element repeats the node before it, extra nodes of
/// higher-order elements and rigid road surfaces are skipped.
Result<D3plot> read_d3plot(const std::string& path, DatabaseKind kind = DatabaseKind::plot);

/// The same for bytes in memory.
Result<D3plot> read_d3plot_bytes(std::string_view bytes, const std::string& name);

[[nodiscard]] MeshSource mesh_source(const D3plot& plot);

}  // namespace gapcheck::results
