#pragma once
#include <string>

#include "base/result.hpp"
#include "results/d3plot/d3plot_family.hpp"
#include "results/d3plot/interface_forces.hpp"

namespace gapcheck::results {

struct IntforWriteSettings {
  int word_bytes = 4;                                         ///< 4 or 8; ids beyond 32 bits always need words of 8
  std::uint64_t member_words = std::uint64_t{7} * 512 * 512;  ///< as for d3plots
};

/// Writes an interface force database, in the layout of the d3plot family (LS-DYNA database manual): file type 4,
/// segments as shells whose parts are the surfaces, 16 values for each: pressure, shear stress, its components along r
/// and s, forces on the four corners. The titles of the surfaces say which side of which contact they are.
class IntforWriter {
 public:
  static Result<IntforWriter> create(const std::string& path, const InterfaceMesh& mesh,
                                     const IntforWriteSettings& settings = {});
  /// Arrays of other sizes than the mesh's are an error, as are files that cannot be written.
  [[nodiscard]] Status append(const InterfaceForces& state);
  [[nodiscard]] Status check_names() const { return family_.check_names(); }

 private:
  int word_bytes_ = 4;
  std::size_t nodes_ = 0, segments_ = 0, surfaces_ = 0;
  D3plotFamily family_;
};

/// The title of a surface: "contact 3 side A: lid on box".
[[nodiscard]] std::string surface_title(const InterfaceSurface& surface);
/// The contact and the side that such a title names; contact 0: it is another title.
[[nodiscard]] InterfaceSurface surface_of_title(std::string_view title);

}  // namespace gapcheck::results
