#include "solver/contact/segment_crossings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "contact/crossing/crossings.hpp"

namespace gapcheck::solver {
namespace {

/// Pairs that are listed individually.
constexpr std::size_t named = 100;

std::string element(const model::Model& model, const contact::CrossingSegment& segment) {
  const auto id = [&](const auto& elements) {
    return segment.element < elements.size() ? elements.id[segment.element] : std::int64_t{0};
  };
  const auto& nodes = model.mesh.nodes.id;
  const auto of = [&](std::size_t i) { return nodes[segment.nodes[i].value]; };
  switch (segment.kind) {
    case model::ElementKind::shell:
      if (id(model.mesh.shells) != 0) return fmt::format("shell {}", id(model.mesh.shells));
      break;
    case model::ElementKind::solid:
      if (id(model.mesh.solids) != 0) return fmt::format("solid {}", id(model.mesh.solids));
      break;
    case model::ElementKind::thick_shell:
      if (id(model.mesh.thick_shells) != 0) return fmt::format("thick shell {}", id(model.mesh.thick_shells));
      break;
    default:
      break;
  }
  return fmt::format("nodes {} {} {} {}", of(0), of(1), of(2), of(3));
}

}  // namespace

SegmentCrossings::SegmentCrossings(double interval) : interval_(std::abs(interval)) {
  if (!std::isfinite(interval_)) interval_ = 0;
}

std::optional<ContactEvent> SegmentCrossings::check(const model::Model& model, ContactIndex contact,
                                                    const contact::ContactSurfaces& surfaces, const State& state) {
  if (next_ > state.time + 1.5 * interval_) next_ = 0;  // time begins again after a relaxation
  if (!(interval_ > 0) || state.time < next_) return std::nullopt;
  next_ = (std::floor(state.time / interval_) + 1) * interval_;
  contact::CrossingOptions options;
  options.x = &state.x;
  contact::CrossingCounters counters;
  const std::vector<contact::Crossing> found = contact::find_crossings(model, contact, surfaces, options, counters);
  std::string text;
  for (std::size_t i = 0; i < std::min(found.size(), named); ++i)
    text +=
        fmt::format("     segment of {} and segment of {}\n", element(model, found[i].a), element(model, found[i].b));
  if (found.size() > named) text += fmt::format("     and {} more pairs\n", found.size() - named);
  if (text == told_) return std::nullopt;
  told_ = text;
  if (found.empty()) return std::nullopt;
  return ContactEvent{contact, state.time, fmt::format("segments that intersect = {}\n{}", found.size(), text)};
}

}  // namespace gapcheck::solver
