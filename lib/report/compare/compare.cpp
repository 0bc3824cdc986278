#include "report/compare/compare.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "report/item/sums.hpp"
#include "report/text/check_c_view.hpp"

namespace gapcheck::report {
namespace {

struct Node {
  std::int64_t id;
  bool edge;  ///< it represents an edge that ends there
  double depth;
  bool released;
  [[nodiscard]] std::pair<std::int64_t, bool> key() const { return {id, edge}; }
};

/// A contact of one source: its position, and its nodes by key, one record each (the deepest).
struct ContactSide {
  const ContactSummary* contact = nullptr;
  std::vector<Node> nodes;
};

/// `listed_only`: leaves out what the solver does not list, if the deck is compared with its list.
std::vector<Node> nodes_of(const Report& report, std::uint32_t position, bool listed_only) {
  std::vector<Node> nodes;
  for (const Penetration& record : records_of(report, position)) {
    if (listed_only ? !listed_by_solver(record.kind) : record.kind == PenetrationKind::edge_zone) continue;
    nodes.push_back(
        {record.node, record.kind == PenetrationKind::edge, record.depth, record.kind == PenetrationKind::released});
  }
  std::stable_sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) {
    return std::tuple(a.key(), -a.depth) < std::tuple(b.key(), -b.depth);
  });
  const auto same = [](const Node& a, const Node& b) { return a.key() == b.key(); };
  nodes.erase(std::unique(nodes.begin(), nodes.end(), same), nodes.end());
  return nodes;
}

/// Positions of the contacts by id; of equal ids the first counts.
std::map<std::int64_t, std::uint32_t> contact_positions(const Report& report) {
  std::map<std::int64_t, std::uint32_t> result;
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) result.emplace(report.contacts[i].id, i);
  return result;
}

std::optional<std::uint32_t> place_of(const std::map<std::int64_t, std::uint32_t>& positions, std::int64_t id) {
  const auto found = positions.find(id);
  return found == positions.end() ? std::nullopt : std::optional(found->second);
}

/// Half a unit in the fifth digit of `value`, a little more than the loss by printing.
double printing_error(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 0;
  return 0.5 * std::pow(10.0, std::floor(std::log10(value)) - 4) * (1 + 1e-6);
}

/// `knows_released`: the other source lists released nodes of this contact.
void only_one(const Node& node, bool in_first, bool knows_released, std::int64_t contact, ContactComparison& sum,
              std::vector<Difference>& differences) {
  if (node.released && !knows_released) return;
  ++(in_first ? sum.only_first : sum.only_second);
  differences.push_back({contact, node.id, in_first ? node.depth : -1, in_first ? -1 : node.depth});
}

void both(const Node& a, const Node& b, double tolerance, std::int64_t contact, ContactComparison& sum,
          std::vector<Difference>& differences) {
  // Lines without a depth only say that the node penetrates.
  const bool known = a.depth > 0 && b.depth > 0;
  if (known) sum.largest_difference = std::max(sum.largest_difference, std::abs(a.depth - b.depth));
  if (!known || same_depth(a.depth, b.depth, tolerance)) {
    ++sum.agree;
  } else {
    ++sum.depth_differs;
    differences.push_back({contact, a.id, a.depth, b.depth});
  }
}

/// Iterates over both lists in parallel.
void compare_nodes(std::span<const Node> a, std::span<const Node> b, double tolerance, ContactComparison& sum,
                   std::vector<Difference>& differences) {
  const auto any_released = [](std::span<const Node> nodes) {
    return std::any_of(nodes.begin(), nodes.end(), [](const Node& node) { return node.released; });
  };
  const bool known_in_a = any_released(a), known_in_b = any_released(b);
  std::size_t i = 0, k = 0;
  while (i < a.size() || k < b.size()) {
    if (k == b.size() || (i < a.size() && a[i].key() < b[k].key())) {
      only_one(a[i++], true, known_in_b, sum.id, sum, differences);
    } else if (i == a.size() || b[k].key() < a[i].key()) {
      only_one(b[k++], false, known_in_a, sum.id, sum, differences);
    } else {
      both(a[i++], b[k++], tolerance, sum.id, sum, differences);
    }
  }
}

/// If nodes are counted but not listed, only the numbers can be compared.
void compare_counts(const ContactSide& first, const ContactSide& second, ContactComparison& sum) {
  const auto count = [](const ContactSide& side) {
    const auto listed = static_cast<std::uint64_t>(
        std::count_if(side.nodes.begin(), side.nodes.end(), [](const Node& node) { return !node.released; }));
    return side.contact == nullptr ? 0 : std::max(listed, side.contact->reported_penetrations);
  };
  const std::uint64_t a = count(first), b = count(second);
  sum.agree = std::min(a, b);
  sum.only_first = a - sum.agree;
  sum.only_second = b - sum.agree;
}

/// `unlisted`: nodes that a source counts without listing them. Those that only the other one lists (`only`, of the
/// first source if `in_first`) may be among them, and are no difference then.
void match_unlisted(std::uint64_t unlisted, bool in_first, ContactComparison& sum, std::size_t before,
                    std::vector<Difference>& differences) {
  if (unlisted == 0) return;
  std::uint64_t& only = in_first ? sum.only_first : sum.only_second;
  const std::uint64_t matched = std::min(unlisted, only);
  only -= matched;
  sum.agree += matched;
  sum.by_number += matched;
  (in_first ? sum.only_second : sum.only_first) += unlisted - matched;
  const auto listed = [&](const Difference& d) { return (in_first ? d.second : d.first) < 0; };
  const auto begin = differences.begin() + static_cast<std::ptrdiff_t>(before);
  differences.erase(std::remove_if(begin, differences.end(), listed), differences.end());
}

/// One contact of at least one source.
ContactComparison compare_contact(const ContactSide& first, const ContactSide& second, double tolerance,
                                  bool listed_only, std::vector<Difference>& differences) {
  const ContactSummary& named = first.contact != nullptr ? *first.contact : *second.contact;
  ContactComparison sum;
  sum.id = named.id;
  sum.title = named.title.empty() && second.contact != nullptr ? second.contact->title : named.title;
  sum.type = named.type.empty() && second.contact != nullptr ? second.contact->type : named.type;
  sum.missing_in_first = first.contact == nullptr;
  sum.missing_in_second = second.contact == nullptr;
  for (const ContactSide* side : {&first, &second}) {
    if (side->contact == nullptr) continue;
    sum.not_checked =
        sum.not_checked || !side->contact->not_checked.empty() || (listed_only && side->contact->by_segments);
    sum.tied = sum.tied || side->contact->ties_judged;
    sum.counts_only = sum.counts_only || (side->nodes.empty() && unlisted_penetrations(*side->contact) > 0);
  }
  if (sum.not_checked || sum.tied) return sum;
  const std::size_t before = differences.size();
  if (sum.counts_only) {
    compare_counts(first, second, sum);
  } else {
    compare_nodes(first.nodes, second.nodes, tolerance, sum, differences);
    const auto unlisted = [](const ContactSide& side) {
      return side.contact == nullptr ? 0 : unlisted_penetrations(*side.contact);
    };
    match_unlisted(unlisted(second), true, sum, before, differences);
    match_unlisted(unlisted(first), false, sum, before, differences);
  }
  const auto size = [](const Difference& d) { return std::abs(std::max(d.first, 0.0) - std::max(d.second, 0.0)); };
  std::stable_sort(differences.begin() + static_cast<std::ptrdiff_t>(before), differences.end(),
                   [&](const Difference& a, const Difference& b) {
                     return std::tuple(-size(a), a.node) < std::tuple(-size(b), b.node);
                   });
  return sum;
}

}  // namespace

bool Comparison::equal() const {
  return timesteps.differ == 0 && std::all_of(contacts.begin(), contacts.end(), [](const ContactComparison& contact) {
           return contact.depth_differs + contact.only_first + contact.only_second == 0 && contact.ties_equal();
         });
}

bool same_depth(double first, double second, double tolerance) {
  return std::abs(first - second) <= tolerance + printing_error(std::max(first, second));
}

Comparison compare(const Report& first, const Report& second, double tolerance) {
  Comparison result;
  const bool listed_only = first.source != "deck" || second.source != "deck";
  const auto in_first = contact_positions(first), in_second = contact_positions(second);
  const auto side = [&](const Report& report, std::optional<std::uint32_t> place) {
    return place ? ContactSide{&report.contacts[*place], nodes_of(report, *place, listed_only)} : ContactSide{};
  };
  const auto add = [&](std::int64_t id) {
    const auto a = place_of(in_first, id), b = place_of(in_second, id);
    result.contacts.push_back(
        compare_contact(side(first, a), side(second, b), tolerance, listed_only, result.differences));
    compare_ties(first, a, second, b, result.contacts.back(), result.tie_differences);
  };
  for (std::uint32_t i = 0; i < first.contacts.size(); ++i)
    if (in_first.at(first.contacts[i].id) == i) add(first.contacts[i].id);
  for (std::uint32_t i = 0; i < second.contacts.size(); ++i)
    if (!in_first.contains(second.contacts[i].id) && in_second.at(second.contacts[i].id) == i)
      add(second.contacts[i].id);
  result.timesteps = compare_timesteps(first, second);
  return result;
}

}  // namespace gapcheck::report
