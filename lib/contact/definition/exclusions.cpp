#include "contact/definition/exclusions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "model/contact/contact.hpp"

namespace gapcheck::contact {
namespace {

std::optional<std::vector<bool>> existing_parts(const model::Model& model, std::int64_t id, std::int64_t type) {
  std::vector<bool> mask(model.parts.size(), false);
  if (type == static_cast<std::int64_t>(model::SurfaceType::part)) {
    const auto part = model.part_of_id.find(id);
    if (part == model.part_of_id.end()) return std::nullopt;
    mask[part->second.value] = true;
    return mask;
  }
  if (type == static_cast<std::int64_t>(model::SurfaceType::part_set)) {
    const auto set = model.sets.parts.find(id);
    if (set == model.sets.parts.end()) return std::nullopt;
    for (const PartIndex part : set->second.members) mask[part.value] = true;
    return mask;
  }
  return std::nullopt;
}

}  // namespace

Exclusions::Exclusions(const model::Model& model, ContactId contact) {
  for (const model::ContactExclusion& exclusion : model.exclusions) {
    if (exclusion.contact != 0 && exclusion.contact != contact.value) continue;
    for (const auto& pair : exclusion.pairs) {
      auto a = existing_parts(model, pair.a, pair.type_a), b = existing_parts(model, pair.b, pair.type_b);
      if (a && b)
        pairs_.emplace_back(std::move(*a), std::move(*b));
      else
        not_honoured_ = fmt::format(
            "*{} between {} (type {}) and {} (type {}) is not honoured: only existing parts (3) and part "
            "sets (2) are",
            model::exclusion_keyword, pair.a, pair.type_a, pair.b, pair.type_b);
    }
  }
}

bool Exclusions::excluded(PartIndex a, PartIndex b) const {
  if (a == none<PartIndex> || b == none<PartIndex>) return false;
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& pair) {
    const auto& [first, second] = pair;
    return (first[a.value] && second[b.value]) || (first[b.value] && second[a.value]);
  });
}

}  // namespace gapcheck::contact
