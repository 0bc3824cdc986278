#include "audit/selection.hpp"

#include <algorithm>
#include <iterator>

#include "audit/registry.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit {

Selection::Selection(const model::Model& model, const AuditOptions& options) : model_(model), options_(options) {
  const auto& ids = options.contacts;
  for (const ContactIndex i : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(i);
    if (!ids.empty() && std::find(ids.begin(), ids.end(), contact.id.value) == ids.end()) continue;
    contacts_.push_back(i);
    if (contact.known && !contact.own_layout && contact.cards.any) read_contacts_.push_back(i);
  }
  const auto chosen = [&](const RuleIdentity& rule) { return selected(rule, options.select, options.ignore); };
  for (const RuleIdentity& rule : rules())
    if (chosen(rule)) needs_ |= rule.needs;
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind)
    kinds_[kind] = chosen(rule_of(static_cast<PenetrationKind>(kind)));
  for (const TieReason reason : tie_reasons) reasons_[static_cast<std::size_t>(reason)] = chosen(rule_of(reason));
}

bool Selection::part_chosen(PartIndex part) const {
  const auto& ids = options_.parts;
  if (ids.empty()) return true;
  return part != none<PartIndex> && std::find(ids.begin(), ids.end(), model_.part(part).id.value) != ids.end();
}

std::vector<std::int64_t> Selection::unknown_parts() const {
  std::vector<std::int64_t> list;
  std::copy_if(options_.parts.begin(), options_.parts.end(), std::back_inserter(list),
               [&](std::int64_t id) { return !model_.part_of_id.contains(id); });
  return list;
}

bool Selection::records_wanted() const {
  const auto any = [](const auto& list) { return std::find(list.begin(), list.end(), true) != list.end(); };
  return any(kinds_) || any(reasons_);
}

}  // namespace gapcheck::audit
