#include "contact/definition/repeated_contacts.hpp"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

namespace gapcheck::contact {
namespace {

/// The same for contacts of one keyword between the same sides, hardly ever for others.
std::uint64_t sides_hash(const model::Contact& c) {
  std::uint64_t hash = std::hash<std::string_view>()(c.keyword);
  for (const std::int64_t value : {c.a.id, c.a.type, c.a.box, c.b.id, c.b.type, c.b.box}) {
    hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

std::vector<ContactIndex> repeated_contacts(const model::Model& model) {
  std::vector<std::int64_t> named;
  for (const model::ContactExclusion& exclusion : model.exclusions) named.push_back(exclusion.contact);
  std::sort(named.begin(), named.end());
  // Sorted numbers, not a map: `fix` asks again and again, with a hundred thousand contacts.
  std::vector<std::pair<std::uint64_t, ContactIndex>> order;
  order.reserve(model.contacts.size());
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size()))
    if (!std::binary_search(named.begin(), named.end(), model.contact(c).id.value))
      order.emplace_back(sides_hash(model.contact(c)), c);
  std::sort(order.begin(), order.end());
  // Different contacts between the same sides are few; of thousands the later ones are not compared with all.
  constexpr std::size_t most_compared = 16;
  std::vector<ContactIndex> first(model.contacts.size(), none<ContactIndex>), known;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& [hash, c] = order[i];
    if (i == 0 || order[i - 1].first != hash) known.clear();
    const auto same = std::find_if(known.begin(), known.end(), [&, at = c](ContactIndex other) {
      return same_cards(model.contact(other), model.contact(at));
    });
    if (same != known.end())
      first[c.value] = *same;
    else if (known.size() < most_compared)
      known.push_back(c);
  }
  return first;
}

}  // namespace gapcheck::contact
