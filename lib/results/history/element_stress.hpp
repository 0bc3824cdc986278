#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

enum class StressKind : std::uint8_t { solid, beam, shell };

/// One integration point. Beams have the stresses 11, 12 and 31 in xx, xy and zx.
struct StressRow {
  std::array<double, 6> stress{};  ///< xx yy zz xy yz zx
  double plastic_strain = 0;       ///< effective
  double effective = 0;            ///< von Mises; of solids only
  bool plastic = false;            ///< it has yielded
};

/// One element at one time (elout).
struct ElementStress {
  StressKind kind = StressKind::shell;
  std::int64_t id = 0, part = 0;
  /// Of beams: axial force, shear s and t, moments s and t, torsion.
  std::array<double, 6> resultants{};
  /// Solids: one, their mean. Shells: layers of the first point in the plane, then those of the next.
  std::vector<StressRow> points;
  std::size_t layers = 1;  ///< of shells
};

// The layout is that of the solver developer's own converter from binout to text (l2a); that of shells is known from a
// published reader of such files too. The last column of solids, "yield function", has the plastic strain.
[[nodiscard]] std::string elout_header(const FileHeader& header, std::vector<LegendEntry> elements);
/// `cycle`: from 1. `local`: shells in their own axes, otherwise in global ones.
[[nodiscard]] std::string elout_text(std::uint64_t cycle, double time, bool local,
                                     std::span<const ElementStress> elements);
/// Strains are left out.
[[nodiscard]] History<ElementStress> read_elout(std::string_view text, const std::string& name,
                                                Diagnostics& diagnostics);
/// "solid", "beam", "shell".
[[nodiscard]] std::string_view name(StressKind kind);

}  // namespace gapcheck::results
