#include "solver/condition/preload_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

std::optional<PreloadCurve> preload_curve(ConditionBuilder& builder, std::int64_t id, double scale,
                                          const PreloadWords& words, model::Place place) {
  const std::string_view keyword = words.keyword;
  if (builder.curve(id, keyword, place) == nullptr) return std::nullopt;
  const model::Curve& written = builder.model.curves.at(id);
  const Phases phases = builder.phases(id);
  if (!phases.run && !builder.relaxing)
    builder.fail(Failure::Kind::contradiction, keyword, place,
                 fmt::format("curve {} is for dynamic relaxation only (SIDR = 1), and there is none; set SIDR to 0, or "
                             "IDRFLG of *CONTROL_DYNAMIC_RELAXATION to 1",
                             id));
  else if (phases.run && phases.relaxation && builder.relaxing)
    builder.warn(keyword, place,
                 fmt::format("curve {} acts in the dynamic relaxation and again from the start of the run (SIDR = 2); "
                             "the preload stays with SIDR = 1",
                             id));
  std::vector<TimeCurve::Point> points = written.points;
  for (TimeCurve::Point& point : points) point = {point[0] * written.abscissa_time, point[1] * scale};
  const auto falls =
      std::adjacent_find(points.begin(), points.end(), [](const auto& a, const auto& b) { return b[1] < a[1]; });
  const double end = points.empty() ? 0 : falls == points.end() ? points.back()[0] : (*falls)[0];
  if (points.empty() || !(end > points.front()[0])) {
    builder.fail(Failure::Kind::contradiction, keyword, place,
                 fmt::format("the preload ends where curve {}{} first falls or has its last point, here at "
                             "its start; let it rise from 0 to the {}",
                             id, words.factor, words.one));
    return std::nullopt;
  }
  PreloadCurve result{TimeCurve(std::move(points)), end, phases};
  const std::array<double, 2> limits{result.curve.at(result.curve.start()), result.curve.at(end)};
  if (limits[1] < 0 || !std::isfinite(limits[0]) || !std::isfinite(limits[1])) {
    builder.fail(Failure::Kind::contradiction, keyword, place,
                 fmt::format("the {} ends at {:g}; {} are pulled together by {} above zero", words.one, limits[1],
                             words.pulled, words.many));
    return std::nullopt;
  }
  return result;
}

}  // namespace gapcheck::solver
