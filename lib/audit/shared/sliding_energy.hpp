#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "audit/run_context.hpp"

namespace gapcheck::audit {

/// Sliding energy at one time.
struct SlidingState {
  double time = 0, energy = 0;
  double print_error = 0;  ///< rounding of the file's digits
};

/// Sliding energy of one contact, or of all together.
struct SlidingHistory {
  std::int64_t contact = 0;  ///< 0: all, from glstat
  std::string_view file = "sleout";
  bool without_friction = true;      ///< false: what friction has dissipated is in it
  std::vector<SlidingState> states;  ///< finite values only
};

/// Of each contact that --contact lets through: the energies of both sides less that of friction, which both contain.
/// Without sleout one history of all contacts, with friction. Empty: the run has neither file.
[[nodiscard]] std::vector<SlidingHistory> sliding_energies(const RunContext& context);

/// "3.4 % of the peak internal energy".
[[nodiscard]] std::string share_text(double energy, const ReferenceEnergy& reference);

}  // namespace gapcheck::audit
