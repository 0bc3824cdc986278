#include "contact/definition/friction.hpp"

#include <algorithm>
#include <cmath>

#include "contact/definition/contact_type.hpp"

namespace gapcheck::contact {
namespace {

/// A row with more pairs of parts is not written out pair by pair.
constexpr std::size_t most_pairs = 10'000;

/// Ascending.
std::vector<PartIndex> parts_named(const model::Model& model, std::int64_t id, bool set) {
  if (set) {
    const auto found = model.sets.parts.find(id);
    std::vector<PartIndex> parts = found == model.sets.parts.end() ? std::vector<PartIndex>{} : found->second.members;
    std::sort(parts.begin(), parts.end());
    return parts;
  }
  const auto found = model.part_of_id.find(id);
  return found == model.part_of_id.end() ? std::vector<PartIndex>{} : std::vector<PartIndex>{found->second};
}

bool acts(const model::FrictionLaw& law) { return law.fs > 0 || law.fd > 0; }

/// The table that FD names, or the only one there is.
const model::FrictionTable* table_of(const model::Model& model, const model::Contact& contact) {
  const auto found = model.friction_tables.find(static_cast<std::int64_t>(std::clamp(contact.fd, -1e15, 1e15)));
  if (found != model.friction_tables.end()) return &found->second;
  return model.friction_tables.size() == 1 ? &model.friction_tables.begin()->second : nullptr;
}

}  // namespace

bool has_friction(const model::Contact& contact) {
  const ContactType type = classify(contact);
  return type.family != Family::tied && type.treatment != Treatment::none;
}

bool takes_friction_table(const model::Contact& contact) { return classify(contact).can(Ability::friction_table); }

bool takes_part_friction(const model::Contact& contact) { return classify(contact).can(Ability::part_friction); }

Friction::Friction(const model::Model& model, const model::Contact& contact) : model_(model), contact_(contact) {
  if (contact.fs == friction_of_parts) {
    any_ = model.controls.sfric > 0 || model.controls.dfric > 0;
    for (const model::Part& part : model.parts)
      any_ = any_ || (part.contact && (part.contact->fs > 0 || part.contact->fd > 0));
    return;
  }
  if (contact.fs != friction_by_table) {
    any_ = contact.fs > 0 || contact.fd > 0;
    return;
  }
  table_ = table_of(model, contact);
  if (table_ == nullptr) return;
  any_ = acts(table_->others);
  for (std::size_t number = 0; number < table_->rows.size(); ++number) {
    const auto& row = table_->rows[number];
    std::vector<PartIndex> i = parts_named(model, row.i, row.i_is_set), j = parts_named(model, row.j, row.j_is_set);
    if (i.empty() || j.empty()) continue;
    any_ = any_ || acts(row.law);
    if (i.size() > most_pairs / j.size()) {
      wide_.push_back({{number, row.law}, std::move(i), std::move(j)});
      continue;
    }
    for (const PartIndex a : i)
      for (const PartIndex b : j) rows_[{std::min(a, b), std::max(a, b)}] = {number, row.law};
  }
}

bool Friction::WideRow::names(PartIndex a, PartIndex b) const {
  const auto in = [](const std::vector<PartIndex>& parts, PartIndex part) {
    return std::binary_search(parts.begin(), parts.end(), part);
  };
  return (in(i, a) && in(j, b)) || (in(i, b) && in(j, a));
}

/// The last row that names the pair; nullptr: none.
const Friction::Row* Friction::row_of(PartIndex a, PartIndex b) const {
  const auto found = rows_.find({std::min(a, b), std::max(a, b)});
  const Row* row = found == rows_.end() ? nullptr : &found->second;
  const auto wide = std::find_if(wide_.rbegin(), wide_.rend(), [&](const WideRow& w) { return w.names(a, b); });
  return wide != wide_.rend() && (row == nullptr || wide->number > row->number) ? &*wide : row;
}

model::FrictionLaw Friction::of_parts(PartIndex node_part, PartIndex segment_part) const {
  for (const PartIndex part : {segment_part, node_part}) {
    if (part == none<PartIndex>) continue;
    if (const auto& own = model_.part(part).contact; own && (own->fs > 0 || own->fd > 0))
      return {own->fs, own->fd, own->dc, own->vc};
  }
  return {model_.controls.sfric, model_.controls.dfric, 0, model_.controls.vfc};
}

model::FrictionLaw Friction::between(PartIndex node_part, PartIndex segment_part) const {
  model::FrictionLaw law{contact_.fs, contact_.fd, contact_.dc, contact_.vc};
  if (contact_.fs == friction_of_parts) law = of_parts(node_part, segment_part);
  if (contact_.fs == friction_by_table) {
    law = table_ == nullptr ? model::FrictionLaw{} : table_->others;
    if (const Row* row = row_of(node_part, segment_part)) law = row->law;
  }
  law.fs *= contact_.fsf;
  law.fd *= contact_.fsf;
  law.vc *= contact_.vsf;
  return law;
}

double friction_coefficient(const model::FrictionLaw& law, double velocity) {
  return law.fd + (law.fs - law.fd) * std::exp(-law.dc * velocity);
}

double friction_limit(const model::FrictionLaw& law, double velocity, double normal_force, double area) {
  const double coulomb = friction_coefficient(law, velocity) * normal_force;
  return law.vc > 0 ? std::min(coulomb, law.vc * area) : coulomb;
}

}  // namespace gapcheck::contact
