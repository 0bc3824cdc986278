#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// Values of FS with a meaning of their own.
inline constexpr double friction_of_parts = -1;  ///< *PART_CONTACT
inline constexpr double friction_by_table = -2;  ///< *DEFINE_FRICTION, the one that FD names if there are several

/// True for contacts that slide: not for tied ones (TIEBREAK is one until it fails) and transducers.
[[nodiscard]] bool has_friction(const model::Contact& contact);

/// Types that support FS = -1 (contact rules, section 1.5), including their MORTAR and SMOOTH forms.
[[nodiscard]] bool takes_part_friction(const model::Contact& contact);

/// Types that support FS = -2: the same without airbags (contact rules, section 1.5).
[[nodiscard]] bool takes_friction_table(const model::Contact& contact);

/// The friction of one contact between any two parts, including the scales FSF and VSF. FS = -1: *PART_CONTACT of the
/// segment's part, or of the node's if that has none, else SFRIC, DFRIC and VFC of *CONTROL_CONTACT. FS = -2:
/// *DEFINE_FRICTION; the last row that names the pair counts. The model must outlive it. Source: contact rules, section
/// 8.2.
class Friction {
 public:
  Friction(const model::Model& model, const model::Contact& contact);
  /// False: there is none between any parts.
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] model::FrictionLaw between(PartIndex node_part, PartIndex segment_part) const;

 private:
  [[nodiscard]] model::FrictionLaw of_parts(PartIndex node_part, PartIndex segment_part) const;

  const model::Model& model_;
  const model::Contact& contact_;
  const model::FrictionTable* table_ = nullptr;
  struct Row {
    std::size_t number = 0;  ///< in the table
    model::FrictionLaw law;
  };
  /// A row of sets of many parts, whose pairs would be millions.
  struct WideRow : Row {
    std::vector<PartIndex> i, j;  ///< ascending
    [[nodiscard]] bool names(PartIndex a, PartIndex b) const;
  };
  [[nodiscard]] const Row* row_of(PartIndex a, PartIndex b) const;

  std::map<std::pair<PartIndex, PartIndex>, Row> rows_;  ///< lower part first
  std::vector<WideRow> wide_;                            ///< in the table's order
  bool any_ = false;
};

/// Coefficient at a sliding velocity: μ = FD + (FS - FD) exp(-DC |v|).
[[nodiscard]] double friction_coefficient(const model::FrictionLaw& law, double velocity);

/// Largest tangential force: μ · normal force, and at most VC · area where VC > 0.
[[nodiscard]] double friction_limit(const model::FrictionLaw& law, double velocity, double normal_force, double area);

}  // namespace gapcheck::contact
