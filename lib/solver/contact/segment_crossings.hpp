#pragma once
#include <optional>

#include "contact/surface/contact_surfaces.hpp"
#include "solver/contact/contact_source.hpp"

namespace gapcheck::solver {

/// DTPCHK of SOFT = 2: at every such interval the segments that pass through each other are looked for and told. Which
/// do, contact/crossings.hpp decides.
class SegmentCrossings {
 public:
  SegmentCrossings() = default;
  /// 0: never; of a negative interval its amount counts.
  explicit SegmentCrossings(double interval);
  /// What is to be told at this time; nothing where no look is due, or where nothing has changed since the last one.
  [[nodiscard]] std::optional<ContactEvent> look(const model::Model& model, std::uint32_t contact,
                                                 const contact::ContactSurfaces& surfaces, const State& state);

 private:
  double interval_ = 0, next_ = 0;
  std::string told_;
};

}  // namespace gapcheck::solver
