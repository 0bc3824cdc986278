#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "audit/audit.hpp"
#include "model/model.hpp"
#include "records/penetration.hpp"
#include "records/rule_identity.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck::audit {

/// What the options of an audit select: contacts and parts of the model, rules and the records that they report.
class Selection {
 public:
  /// Both must outlive it.
  Selection(const model::Model& model, const AuditOptions& options);

  [[nodiscard]] const model::Model& model() const { return model_; }
  [[nodiscard]] const AuditOptions& options() const { return options_; }
  /// The contacts that --contact lets through, ascending.
  [[nodiscard]] const std::vector<ContactIndex>& contacts() const { return contacts_; }
  /// Those of contacts() that have the cards of a 3D contact, at least card 1.
  [[nodiscard]] const std::vector<ContactIndex>& read_contacts() const { return read_contacts_; }
  /// True if --part lets the part through.
  [[nodiscard]] bool part_chosen(PartIndex part) const;
  /// True if some selected rule needs it.
  [[nodiscard]] bool needs(Need need) const { return needs_.has(need); }
  /// True if the rule that reports such records is selected.
  [[nodiscard]] bool wanted(PenetrationKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] bool wanted(TieReason reason) const { return reasons_[static_cast<std::size_t>(reason)]; }
  /// Ids of --part that the deck does not have.
  [[nodiscard]] std::vector<std::int64_t> unknown_parts() const;
  /// True if a rule that reports any records is selected.
  [[nodiscard]] bool records_wanted() const;

 private:
  const model::Model& model_;
  const AuditOptions& options_;
  std::vector<ContactIndex> contacts_, read_contacts_;
  RuleNeeds needs_ = Need::model;
  std::array<bool, penetration_kinds> kinds_{};
  std::array<bool, tie_reasons.size()> reasons_{};
};

}  // namespace gapcheck::audit
