#pragma once
#include <optional>

#include "contact/surface/contact_surfaces.hpp"
#include "solver/interface/contact_source.hpp"

namespace gapcheck::solver {

/// DTPCHK of SOFT = 2: at this interval, segments that pass through each other are searched and reported.
/// contact/crossings.hpp decides which do.
class SegmentCrossings {
 public:
  SegmentCrossings() = default;
  /// 0: never; for a negative interval its absolute value counts.
  explicit SegmentCrossings(double interval);
  /// The report at this time; nothing if no check is due or nothing has changed since the last one.
  [[nodiscard]] std::optional<ContactEvent> check(const model::Model& model, ContactIndex contact,
                                                  const contact::ContactSurfaces& surfaces, const State& state);

 private:
  double interval_ = 0, next_ = 0;
  std::string told_;
};

}  // namespace gapcheck::solver
