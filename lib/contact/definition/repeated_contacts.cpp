#include "contact/definition/repeated_contacts.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace gapcheck::contact {

std::vector<ContactIndex> repeated_contacts(const model::Model& model) {
  std::vector<std::int64_t> named;
  for (const model::ContactExclusion& exclusion : model.exclusions) named.push_back(exclusion.contact);
  std::sort(named.begin(), named.end());
  const auto key = [](const model::Contact& c) {
    return std::tuple(c.kind, c.a.id, c.a.type, c.a.box, c.b.id, c.b.type, c.b.box);
  };
  // Different contacts between the same sides are few; of thousands the later ones are not compared with all.
  constexpr std::size_t most_compared = 16;
  std::map<decltype(key(model.contacts.front())), std::vector<ContactIndex>> firsts;
  std::vector<ContactIndex> first(model.contacts.size(), none<ContactIndex>);
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(c);
    if (std::binary_search(named.begin(), named.end(), contact.id.value)) continue;
    std::vector<ContactIndex>& known = firsts[key(contact)];
    const auto same = std::find_if(known.begin(), known.end(),
                                   [&](ContactIndex other) { return same_cards(model.contact(other), contact); });
    if (same != known.end())
      first[c.value] = *same;
    else if (known.size() < most_compared)
      known.push_back(c);
  }
  return first;
}

}  // namespace gapcheck::contact
