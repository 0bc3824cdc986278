#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/result.hpp"
#include "base/vector.hpp"
#include "records/report.hpp"

namespace gapcheck::results {

/// What the views need from a mesh: where nodes are and which part they belong to. Filled from a d3plot or a deck.
struct MeshSource {
  std::unordered_map<std::int64_t, Vector> coordinates;  ///< node id → initial coordinates
  std::unordered_map<std::int64_t, std::int64_t>
      parts;  ///< node id → part id of its first element (shells before solids)
};

/// The mesh of the d3plot `named`; if that is empty, of a readable file named d3plot next to `beside` (a warning says
/// why not), else no mesh. Error: the named file cannot be read.
[[nodiscard]] Result<MeshSource> find_mesh(const std::string& named, const std::string& beside,
                                           Diagnostics& diagnostics);

/// Fills in the parts of nodes that the report lacks.
void add_parts(const MeshSource& mesh, Report& report);

}  // namespace gapcheck::results
