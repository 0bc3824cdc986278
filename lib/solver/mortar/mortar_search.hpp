#pragma once
#include <cstdint>
#include <vector>

#include "contact/definition/exclusions.hpp"
#include "contact/pair/tied_pairs.hpp"
#include "solver/interface/contact_setting.hpp"
#include "solver/mortar/mortar_surface.hpp"

namespace gapcheck::solver {

/// Finds which faces of a mortar contact may meet. All references must outlive it.
class MortarSearch {
 public:
  /// `own_part`: faces of one part may meet. `least_reach`: depth at which no pair is released yet.
  MortarSearch(const ContactSetting& setting, const model::Contact& contact, const MortarSurface& surface,
               bool two_sided, bool own_part, double least_reach);
  /// Pairs that can meet before anything has come nearer by `margin`: tracked face in the upper 32 bits, the other one
  /// in the lower. Ascending.
  [[nodiscard]] std::vector<std::uint64_t> find_pairs(const std::vector<Vector>& x, double margin) const;
  /// Depth beyond which a pair has no force.
  [[nodiscard]] double release_depth(const MortarFace& a, const MortarFace& b) const {
    return std::max(a.reach + b.reach, least_reach_);
  }
  /// How much nearer two faces must come before a force is possible; negative: it is possible now.
  [[nodiscard]] double way_to_go(const MortarFace& a, const MortarFace& b, const std::vector<Vector>& x) const;

 private:
  [[nodiscard]] bool may_meet(const MortarFace& a, const MortarFace& b) const;

  const MortarSurface& surface_;
  contact::Exclusions exclusions_;
  const contact::TiedPairs& ties_;
  bool two_sided_, own_part_;
  double least_reach_;
};

}  // namespace gapcheck::solver
