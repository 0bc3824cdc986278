#pragma once
#include <cstdint>
#include <string>

namespace gapcheck::solver {

/// Why a structure could not be built or a run went no further.
struct Failure {
  enum class Kind : std::uint8_t {
    missing_material,  ///< an element without part, section or material
    bad_material,      ///< a material that the solver does not know, or constants out of range
    bad_element,       ///< no area, no volume or turned inside out
    zero_mass,         ///< a force on a node that has no mass
    not_a_number,
    zero_time_step,
    energy_ratio,       ///< energies that do not add up any more
    unknown_reference,  ///< a condition names a node, set, part, curve … that is not there
    not_calculated,     ///< a condition that the solver does not know
    contradiction,      ///< conditions that cannot hold together
    no_end,             ///< neither the deck nor the caller says when the run ends
    output,             ///< a result file that cannot be written
  } kind;
  std::string message;  ///< names the entity and says what to do
};

}  // namespace gapcheck::solver
