#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string_view>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/material/material.hpp"
#include "solver/quadrature/solid_rule.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Which elements a deck's solids are, and what is calculated as something else; each reported once.
class SolidFormulations {
 public:
  SolidFormulations(const model::Model& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  /// The rules of a part's solids. A failure names an ESORT that is none, a PSFAIL without parts, or rubber
  /// with ELFORM -2.
  [[nodiscard]] SolverResult<SolidRules> rules(PartIndex part, const model::Section& section, const Material& material);
  /// True for ELFORMs that need no warning that they are calculated as another one.
  [[nodiscard]] static bool is_calculated(const model::Section& section);
  /// Solids of this part fail when they lose their volume (PSFAIL); rules() has checked that the set exists.
  [[nodiscard]] bool inverted_fail(PartIndex part) const;
  /// What other ELFORMs are calculated as.
  [[nodiscard]] static std::string_view stand_in(const model::Section& section);
  /// Counts what tell() reports. A failure names a solid that is not a wedge in a part with ELFORM 15.
  [[nodiscard]] SolverStatus look_at(std::uint32_t solid);
  /// What the volume of a refused solid means, where it is not its own: eight times that of the least of eight points.
  [[nodiscard]] std::string_view volume_note(std::uint32_t solid) const;
  /// Reports what was counted.
  void tell();

 private:
  struct Counts {
    std::size_t tetrahedra = 0, wedges = 0, others = 0;
    std::size_t without_average = 0;  ///< tetrahedra that are of ELFORM 10 instead of 13 because of their material
  };
  const model::Model& model_;
  Diagnostics& diagnostics_;
  std::map<std::uint32_t, Counts> counts_;   ///< by section
  std::set<std::uint32_t> without_average_;  ///< parts
};

}  // namespace gapcheck::solver
