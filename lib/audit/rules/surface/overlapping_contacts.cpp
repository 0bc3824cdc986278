#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/exclusions.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::overlapping_contacts {
namespace {

using Parts = std::vector<PartIndex>;
/// Hostile decks may have any number of contacts that all share a part.
constexpr std::size_t most_pairs = 200'000;
/// Most pairs of parts counted for one pair of contacts.
constexpr std::size_t most_part_pairs = 100'000;

/// A contact that keeps surfaces apart, with what it holds.
struct Cover {
  ContactIndex contact;
  Parts a, b;  ///< of single-surface contacts the same
  bool single = false, whole_a = true, whole_b = true;
  std::unique_ptr<contact::Exclusions> exclusions;
};

struct PartPair {
  PartIndex a, b;
  auto operator<=>(const PartPair&) const = default;
};

bool keeps_apart(const model::Contact& contact, const contact::ContactType& type) {
  using contact::Family;
  if (!contact.known || contact.own_layout || type.treatment == contact::Treatment::none) return false;
  if (type.family == Family::tied || type.family == Family::other) return false;
  return !contact.kind->ties();
}

std::vector<Cover> covers(Context& context) {
  const model::Model& model = context.model();
  std::vector<Cover> list;
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = model.contact(i);
    if (!keeps_apart(contact, contact::classify(contact))) continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    Cover cover;
    cover.contact = i;
    cover.single = !surfaces.two_sided();
    cover.a = contact::parts_of(model, surfaces.a);
    cover.b = cover.single ? cover.a : contact::parts_of(model, surfaces.b);
    cover.whole_a = contact::whole_parts(contact.a) || (cover.single && !contact.a.given);
    cover.whole_b = cover.single ? cover.whole_a : contact::whole_parts(contact.b);
    cover.exclusions = std::make_unique<contact::Exclusions>(model, contact.id);
    list.push_back(std::move(cover));
  }
  // The later one by id reports a pair, whatever the order of the deck.
  std::stable_sort(list.begin(), list.end(), [&](const Cover& a, const Cover& b) {
    return model.contact(a.contact).id < model.contact(b.contact).id;
  });
  return list;
}

bool together(const model::Contact& a, const model::Contact& b) {
  const auto end = [](const model::Contact& c) { return c.death > 0 ? c.death : 1e20; };
  return a.birth < end(b) && b.birth < end(a);
}

Parts common(const Parts& a, const Parts& b) {
  Parts both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/// The elements (kind and position) that a side has in one part, and the nodes of a side of nodes; ascending.
std::vector<std::uint64_t> members(const model::Model& model, const contact::ContactSide& side, PartIndex part,
                                   bool as_nodes) {
  std::vector<std::uint64_t> list;
  const contact::Segments& s = side.selection.segments;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (contact::part_of(model.mesh, s, i) != part) continue;
    if (as_nodes)
      for (const NodeIndex n : s.nodes[i]) list.push_back(n.value);
    else
      list.push_back((static_cast<std::uint64_t>(s.element_kind[i]) << 32) | s.element[i]);
  }
  if (as_nodes && side.nodes_only)
    for (const NodeIndex n : side.selection.nodes) list.push_back(n.value);
  std::sort(list.begin(), list.end());
  return list;
}

/// True if two sides that share a part also share elements of it.
bool meet(const model::Model& model, const contact::ContactSide& first, bool whole_first,
          const contact::ContactSide& second, bool whole_second, PartIndex part) {
  if (whole_first || whole_second) return true;
  const bool as_nodes = first.nodes_only || second.nodes_only;
  const auto a = members(model, first, part, as_nodes), b = members(model, second, part, as_nodes);
  std::vector<std::uint64_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return !both.empty();
}

/// Pairs of parts that both contacts hold; the first ones by part, and how many there are.
struct Overlap {
  std::vector<PartPair> pairs;  ///< ascending, each once
  void add(Context& context, const Cover& one, const Cover& two, bool crossed) {
    const model::Model& model = context.model();
    const auto& surfaces_one = context.surfaces(one.contact);
    const auto& surfaces_two = context.surfaces(two.contact);
    const auto& two_a = crossed && !two.single ? surfaces_two.b : surfaces_two.a;
    const auto& two_b = crossed || two.single ? surfaces_two.a : surfaces_two.b;
    const auto& one_b = one.single ? surfaces_one.a : surfaces_one.b;
    const bool whole_a = crossed ? two.whole_b : two.whole_a, whole_b = crossed ? two.whole_a : two.whole_b;
    Parts a = common(one.a, crossed ? two.b : two.a), b = common(one.b, crossed ? two.a : two.b);
    std::erase_if(a, [&](PartIndex p) { return !meet(model, surfaces_one.a, one.whole_a, two_a, whole_a, p); });
    std::erase_if(b, [&](PartIndex p) { return !meet(model, one_b, one.whole_b, two_b, whole_b, p); });
    for (const PartIndex p : a)
      for (const PartIndex q : b) {
        if (pairs.size() >= most_part_pairs) break;
        if (one.single && two.single && q < p) continue;
        if (one.exclusions->excluded(p, q) || two.exclusions->excluded(p, q)) continue;
        if (context.part_chosen(p) || context.part_chosen(q)) pairs.push_back({std::min(p, q), std::max(p, q)});
      }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }
};

Finding words(const RuleIdentity& rule, Context& context, const Cover& one, const Cover& two, const Overlap& overlap) {
  const model::Model& model = context.model();
  const model::Contact &first = model.contact(one.contact), &second = model.contact(two.contact);
  // Two different parts tell more than a part with itself.
  const auto rank = [&](const PartPair& p) {
    const auto [low, high] = std::minmax(model.part(p.a).id, model.part(p.b).id);
    return std::tuple(p.a == p.b, low, high);
  };
  const auto shown = std::min_element(overlap.pairs.begin(), overlap.pairs.end(),
                                      [&](const PartPair& l, const PartPair& r) { return rank(l) < rank(r); });
  const std::int64_t a = std::get<1>(rank(*shown)).value, b = std::get<2>(rank(*shown)).value;
  const std::string named = a == b ? fmt::format("part {} with itself", a) : fmt::format("parts {} and {}", a, b);
  const std::string others =
      overlap.pairs.size() > 1
          ? fmt::format(" and {}{} more pairs", overlap.pairs.size() >= most_part_pairs ? "at least " : "",
                        overlap.pairs.size() - 1)
          : "";
  Finding f =
      finding_at(rule, context, second,
                 fmt::format("{}{} are in contact {} already: their contact forces act twice; take them out of one "
                             "of the two",
                             named, others, first.id.value));
  f.part = a;
  f.element_part = b;
  f.count = overlap.pairs.size();
  return f;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const std::vector<Cover> list = covers(context);
  const model::Model& model = context.model();
  // Only contacts that share a part need to be compared.
  std::vector<std::vector<std::uint32_t>> of_part(model.parts.size());
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < list.size() && pairs.size() < most_pairs; ++i) {
    Parts all;
    std::set_union(list[i].a.begin(), list[i].a.end(), list[i].b.begin(), list[i].b.end(), std::back_inserter(all));
    for (const PartIndex part : all) {
      for (const std::uint32_t other : of_part[part.value])
        if (pairs.size() < most_pairs) pairs.emplace(other, i);
      of_part[part.value].push_back(i);
    }
  }
  if (pairs.size() >= most_pairs) context.skipped(rule, "there are more pairs of contacts than are compared");
  std::vector<Finding> findings;
  std::vector<Found> found;
  for (const auto& [i, j] : pairs) {
    if (!together(model.contact(list[i].contact), model.contact(list[j].contact))) continue;
    Overlap overlap;
    overlap.add(context, list[i], list[j], false);
    if (!list[i].single && !list[j].single) overlap.add(context, list[i], list[j], true);
    if (overlap.pairs.empty()) continue;
    found.push_back({0,
                     static_cast<double>(overlap.pairs.size()),
                     findings.size(),
                     {model.contact(list[j].contact).id.value, model.contact(list[i].contact).id.value}});
    findings.push_back(words(rule, context, list[i], list[j], overlap));
  }
  const auto rest = [&](const Found&, std::uint64_t count) {
    return finding(rule, fmt::format("{} more pairs of contacts hold the same parts", count), "", 0);
  };
  add_grouped(
      report, std::move(found), [&](const Found& f) { return findings[f.item]; }, rest);
}

}  // namespace

const Rule definition{{"GC422", "overlapping-contacts", Severity::warning,
                       "two contacts hold the same pair of parts: the forces act twice", Need::surfaces,
                       "Contact forces act twice between these parts"},
                      run};

}  // namespace gapcheck::audit::rule::overlapping_contacts
