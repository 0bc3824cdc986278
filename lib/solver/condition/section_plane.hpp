#pragma once
#include <algorithm>
#include <string>

#include "base/ids.hpp"
#include "model/entity/cross_section.hpp"

namespace gapcheck::solver {

/// The plane of *DATABASE_CROSS_SECTION_PLANE and where it ends.
class SectionPlane {
 public:
  /// Why a section has no plane that can be used; empty: it has.
  [[nodiscard]] static std::string fault(const model::CrossSection& section);
  /// Of a section without fault.
  explicit SectionPlane(const model::CrossSection& section);

  [[nodiscard]] const Vector& normal() const { return normal_; }  ///< of length 1
  /// Distance in front of the plane.
  [[nodiscard]] double ahead(const Vector& x) const { return (x - section_->tail).dot(normal_); }
  /// The point's projection lies within the limits.
  [[nodiscard]] bool within(const Vector& x) const;
  /// Corners on both sides: at or behind the plane, and in front of it.
  template <class Nodes, class Place>
  [[nodiscard]] bool parts(const Nodes& nodes, const Place& place) const {
    const auto count =
        std::count_if(nodes.begin(), nodes.end(), [&](NodeIndex node) { return ahead(place(node)) > 0; });
    return count != 0 && count != static_cast<std::ptrdiff_t>(nodes.size());
  }

 private:
  const model::CrossSection* section_;
  Vector normal_, along_ = Vector::Zero(), across_ = Vector::Zero();
};

}  // namespace gapcheck::solver
