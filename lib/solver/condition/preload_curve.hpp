#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {

/// A force or stress over time that acts until the curve has its last point or first falls.
struct PreloadCurve {
  TimeCurve curve;
  double end = 0;
  Phases phases{};
};

/// What messages call it.
struct PreloadWords {
  std::string_view keyword, factor;  ///< factor: "" or " (times SCALE)"
  std::string_view one, many;        ///< "force", "forces"
  std::string_view pulled;           ///< what is pulled together
};

/// The curve times `scale`, or a failure: unknown, for a dynamic relaxation that there is not, falling at once, ending
/// below zero. With SIDR = 2 a warning.
[[nodiscard]] std::optional<PreloadCurve> preload_curve(ConditionBuilder& builder, std::int64_t curve, double scale,
                                                        const PreloadWords& words, model::Place place);

}  // namespace gapcheck::solver
