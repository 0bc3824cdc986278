#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// Resultants of one cross-section at one time (secforc), in global axes.
struct SectionState {
  std::int64_t section = 0;
  Vector force = Vector::Zero(), moment = Vector::Zero();  ///< moment about the centroid
  Vector centroid = Vector::Zero();
  double area = 0;
};

// The layout is that of the solver developer's own converter from binout to text (l2a), which prints what the solver
// does; newer releases may print more digits.
[[nodiscard]] std::string secforc_header(const FileHeader& header, std::vector<LegendEntry> sections);
[[nodiscard]] std::string secforc_text(double time, std::span<const SectionState> sections);
[[nodiscard]] History<SectionState> read_secforc(std::string_view text, const std::string& name,
                                                 Diagnostics& diagnostics);

}  // namespace gapcheck::results
