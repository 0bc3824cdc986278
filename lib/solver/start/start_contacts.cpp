#include "solver/start/start_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// The depth is no more than the rounding of coordinates and thicknesses.
bool only_rounding(double depth, double contact_distance, const Vector& x) {
  Penetration record;
  record.depth = depth;
  record.contact_distance = contact_distance;
  record.original = x;
  return within_rounding(record);
}

/// Each node once, at its deepest place: edges and mortar segments meet in several. `stored`: gets the energy of all.
std::vector<ContactNode> deepest_of_each(std::vector<ContactNode> all, double& stored) {
  std::map<NodeIndex, ContactNode> deepest;
  for (ContactNode& node : all) {
    stored += node.stored;
    // Mortar segments whose depth is forgiven touch without a force.
    if (node.kind == ContactNode::Kind::touching && node.force == Vector::Zero()) node.kind = ContactNode::Kind::kept;
    const auto [place, added] = deepest.emplace(node.node, node);
    if (added) continue;
    const double energy = place->second.stored + node.stored;
    if (node.penetration > place->second.penetration) place->second = node;
    place->second.stored = energy;
  }
  std::vector<ContactNode> list;
  for (const auto& [id, node] : deepest) list.push_back(node);
  return list;
}

void keep(StartCounts& counts, const StartNode& node) {
  ++counts.kept;
  counts.deepest_kept = std::max(counts.deepest_kept, node.depth);
  if (!(node.contact_distance > 0)) return;
  const double share = (node.contact_distance - node.depth) / node.contact_distance;
  counts.least_share = std::min(counts.least_share.value_or(share), share);
}

void force(StartCounts& counts, const StartNode& node) {
  ++counts.forced;
  counts.deepest_forced = std::max(counts.deepest_forced, node.depth);
}

void release(StartCounts& counts, const StartNode& node) {
  ++counts.released;
  counts.way_out = std::max(counts.way_out, node.depth);
}

/// What the first cycle does with a node; nothing: it ties it.
std::optional<Outcome> outcome_of(ContactNode::Kind kind) {
  switch (kind) {
    case ContactNode::Kind::touching:
      return Outcome::forced;
    case ContactNode::Kind::kept:
      return Outcome::kept;
    case ContactNode::Kind::released:
      return Outcome::released;
    case ContactNode::Kind::tied:
    case ContactNode::Kind::broken:
      break;
  }
  return std::nullopt;
}

/// Of its penetration.
double counted_depth(const ContactNode& node, Outcome outcome) {
  if (outcome == Outcome::kept) return node.forgiven;
  return outcome == Outcome::forced ? node.penetration - node.forgiven : node.penetration;
}

/// The vector sum of a contact's moves of one node.
struct NodeWay {
  Vector way = Vector::Zero();
  std::tuple<std::uint32_t, std::int64_t, std::int64_t> pair;  ///< of the last of them
};

void add_move(StartCounts& counts, double way) {
  ++counts.moved;
  counts.total_move += way;
  counts.largest_move = std::max(counts.largest_move, way);
}

void add_to_histogram(StartCounts& counts, double way) {
  const double place = way / counts.largest_move * static_cast<double>(start_bins);
  ++counts.histogram[std::min(start_bins - 1, static_cast<std::size_t>(place))];
}

}  // namespace

template <class Change>
void StartContacts::count(const Key& key, const Change& change) {
  change(static_cast<StartCounts&>(contacts_[std::get<0>(key)]));
  change(pairs_[key]);
}

void StartContacts::add_first_cycle(const ContactView& view) {
  const std::uint32_t c = view.state().contact.value;
  StartContact& contact = contacts_[c];
  viewed_[c] = true;
  const std::vector<Vector>& x = initial_.x;
  double known = 0;
  for (const ContactNode& node : deepest_of_each(view.nodes(), known)) {
    const std::optional<Outcome> outcome = outcome_of(node.kind);
    if (!outcome || only_rounding(node.penetration, node.contact_distance, x[node.node.value])) continue;
    StartNode start{c, model_.mesh.nodes.id[node.node.value], id_of(node.part), id_of(node.segment_part), *outcome};
    start.depth = counted_depth(node, *outcome);
    start.contact_distance = node.contact_distance;
    if (outcome == Outcome::forced) start.energy = node.stored;
    if (outcome != Outcome::released) start.to_release = node.release_depth - node.penetration;
    add(start);
    pairs_[{c, start.part, start.other_part}].energy += start.energy;
  }
  if (const std::optional<double> stored = view.stored())
    contact.energy += *stored;
  else if (known > 0)
    contact.no_energy = "its springs unload on another curve than they load";
}

void StartContacts::add_others() {
  for (const Penetration& p : initial_.penetrations) {
    if (viewed_[p.contact] || within_rounding(p)) continue;
    if (p.outcome == Outcome::moved || p.outcome == Outcome::reported) continue;
    add({p.contact, p.node, p.part, p.element_part, p.outcome, p.depth, p.contact_distance});
    if (p.outcome == Outcome::forced)
      contacts_[p.contact].no_energy = "the stiffness is that of a run, and the run refuses the deck or the contact";
  }
}

void StartContacts::add(const StartNode& node) {
  nodes_.push_back(node);
  count({node.contact, node.part, node.other_part}, [&](StartCounts& counts) {
    (node.outcome == Outcome::kept ? keep : node.outcome == Outcome::forced ? force : release)(counts, node);
    if (std::isfinite(node.to_release))
      counts.to_release = std::min(counts.to_release.value_or(node.to_release), node.to_release);
  });
}

void StartContacts::add_moves(std::span<const NodeStep> steps) {
  std::map<std::pair<std::uint32_t, NodeIndex>, NodeWay> ways;
  for (const NodeStep& step : steps) {
    NodeWay& way = ways[{step.contact.value, step.node}];
    way.way += step.way();
    way.pair = {step.contact.value, id_of(step.part), id_of(step.other_part)};
  }
  std::erase_if(ways, [&](const auto& entry) {
    return entry.second.way.norm() <= rounding_at(initial_.x[entry.first.second.value]);
  });
  std::map<Key, std::vector<NodeIndex>> of_pair;
  moved_by_contact_.resize(contacts_.size());
  for (const auto& [key, way] : ways) {
    count(way.pair, [&, length = way.way.norm()](StartCounts& counts) { add_move(counts, length); });
    moved_by_contact_[key.first].push_back(key.second);
    of_pair[way.pair].push_back(key.second);
  }
  for (const auto& [key, way] : ways)
    count(way.pair, [length = way.way.norm()](StartCounts& counts) { add_to_histogram(counts, length); });
  for (const auto& [key, counts] : pairs_)
    if (!counts.clean()) moved_by_pair_.push_back(of_pair[key]);
}

std::vector<StartContact> StartContacts::contacts() const {
  std::vector<StartContact> list = contacts_;
  for (std::size_t c = 0; c < list.size(); ++c) {
    const model::Contact& contact = model_.contacts[c];
    list[c].id = contact.id.value;
    list[c].title = contact.title;
    list[c].keyword = contact.keyword;
    if (!viewed_[c] && list[c].clean()) list[c].not_known = initial_.contacts[c].not_checked;
  }
  return list;
}

std::vector<StartNode> StartContacts::nodes() const {
  std::vector<StartNode> list = nodes_;
  std::ranges::stable_sort(list, {}, [](const StartNode& n) { return std::tuple(n.contact, -n.depth, n.node); });
  return list;
}

std::vector<StartPair> StartContacts::pairs() const {
  std::vector<StartPair> list;
  for (const auto& [key, counts] : pairs_) {
    if (counts.clean()) continue;
    StartPair& pair = list.emplace_back(StartPair{counts, 0, 0, 0});
    std::tie(pair.contact, pair.part, pair.other_part) = key;
  }
  return list;
}

}  // namespace gapcheck::solver
