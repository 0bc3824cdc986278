#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// What one airbag holds at one time (abstat).
struct AirbagRow {
  std::int64_t airbag = 0;
  double volume = 0, pressure = 0, energy = 0;    ///< energy: internal energy of the gas
  double rate_in = 0, density = 0, rate_out = 0;  ///< rates: mass per time
  double mass = 0, temperature = 0, area = 0;
};

// The layout is that of the solver developer's own converter from binout to text (l2a), without the reaction force in
// its last column, which files need not have.
[[nodiscard]] std::string abstat_header(const FileHeader& header, std::vector<LegendEntry> airbags);
[[nodiscard]] std::string abstat_text(double time, std::span<const AirbagRow> airbags);
[[nodiscard]] History<AirbagRow> read_abstat(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace gapcheck::results
