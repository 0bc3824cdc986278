#include "solver/tie/tie_failures.hpp"

#include <algorithm>

#include "solver/tie/tie_strengths.hpp"

namespace gapcheck::solver {

TieFailures::TieFailures(const model::Model& model, contact::SurfaceStore& surfaces,
                         std::span<const TieRange> interfaces, const std::vector<Tie>& ties,
                         const std::vector<Vector>& x) {
  std::vector<TieStrength> strengths(ties.size());
  for (const TieRange& interface : interfaces) {
    if (interface.first == interface.last) continue;
    const contact::ContactSurfaces& sides = surfaces.at(interface.contact);
    const TieStrengths of_contact(model, interface.contact, sides.a.selection.segments, x);
    for (std::size_t t = interface.first; t < interface.last; ++t) strengths[t] = of_contact.of(ties[t], x);
  }
  if (std::none_of(strengths.begin(), strengths.end(), [](const TieStrength& s) { return s.limited(); })) return;
  strengths_ = std::move(strengths);
  failed_.assign(ties.size(), false);
}

void TieFailures::check(std::size_t tie, const Vector& force, const SegmentAxes& axes) {
  if (strengths_.empty() || !strengths_[tie].limited()) return;
  const Vector normal = axes.sound ? Vector(axes.axes.col(2)) : Vector(Vector::Zero());
  if (!(strengths_[tie].criterion(force, normal) >= 1)) return;
  failed_[tie] = news_ = true;
}

}  // namespace gapcheck::solver
