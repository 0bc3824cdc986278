#pragma once
#include <cstdint>
#include <string>

#include "base/result.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::solver {

/// Why a structure could not be built or a run could not continue.
struct Failure {
  enum class Kind : std::uint8_t {
    missing_material,  ///< an element without part, section or material
    bad_material,      ///< an unsupported material, or constants out of range
    bad_element,       ///< no area, no volume or inverted
    zero_mass,         ///< a force on a node that has no mass
    not_a_number,
    zero_time_step,
    energy_ratio,       ///< energies that no longer balance
    unknown_reference,  ///< a condition names a node, set, part, curve … that does not exist
    not_calculated,     ///< an unsupported condition
    contradiction,      ///< conditions that contradict each other
    no_end,             ///< neither the deck nor the caller says when the run ends
    output,             ///< a result file that cannot be written
    empty,              ///< there is nothing to calculate
  } kind;
  std::string message;      ///< names the entity and says what to do
  model::Place place = {};  ///< of what is wrong, where the deck has one
};

template <class T>
using SolverResult = Result<T, Failure>;
using SolverStatus = SolverResult<void>;

}  // namespace gapcheck::solver
