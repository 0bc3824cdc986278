#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "results/d3plot/d3plot.hpp"
#include "results/d3plot/d3plot_family.hpp"
#include "results/d3plot/d3plot_state.hpp"
#include "results/text/file_header.hpp"

namespace gapcheck::results {

struct D3plotWriteSettings {
  int word_bytes = 4;  ///< 4 or 8; ids beyond 32 bits always need words of 8
  /// Words of a file of the family; a state that does not fit begins the next one, even if it alone is too large.
  std::uint64_t member_words = std::uint64_t{7} * 512 * 512;
  bool deletion = false;  ///< states say which elements are deleted; otherwise none may be
};

/// Writes a d3plot database: the first file holds the mesh and the parts' titles, files with the suffixes 01, 02, … the
/// states. Layout: LS-DYNA database manual, NDIM = 4, coordinates and velocities of nodes, seven values per solid,
/// three layers, resultants, thickness and energy per shell, six per beam; thick shells have zeros.
class D3plotWriter {
 public:
  /// Creates the files' first and removes further ones of an older family. `mesh`: element parts are ids of `parts`;
  /// particles are not written. The order of `parts` is that of D3plotState::parts.
  static Result<D3plotWriter> create(const std::string& path, const D3plot& mesh, const std::vector<LegendEntry>& parts,
                                     const D3plotWriteSettings& settings = {});
  /// Arrays of other sizes than the mesh's are an error, as are files that cannot be written.
  [[nodiscard]] Status append(const D3plotState& state);
  /// An error if one of the files is no longer where it was written.
  [[nodiscard]] Status check_names() const { return family_.check_names(); }

 private:
  D3plotWriteSettings settings_;
  /// For each solid, thick shell, shell and beam its part's number, 0 if it is deleted.
  std::vector<std::int64_t> part_numbers_;
  std::size_t nodes_ = 0, solids_ = 0, thick_shells_ = 0, beams_ = 0, shells_ = 0, parts_ = 0;
  D3plotFamily family_;
};

}  // namespace gapcheck::results
