#include "audit/repair/repair_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "audit/fix/proposals.hpp"
#include "audit/fix/thickness_trial.hpp"
#include "audit/repair/repair_trial.hpp"
#include "audit/shared/free_thickness.hpp"
#include "audit/shared/tied_contacts.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit {
namespace {

Repair repair(const RepairPair& pair, RepairKind kind, std::string text, double cost) {
  Repair repair;
  repair.id = fmt::format("{}-{}", pair.number, name(kind));
  repair.kind = kind;
  repair.text = std::move(text);
  repair.cost = cost;
  return repair;
}

Repair moving(const RepairPair& pair) {
  Repair move = repair(pair, RepairKind::move, "nodes move by the least movement", 0);
  move.settings.move = true;
  return move;
}

/// `tracked`: the part whose nodes penetrate most often.
Repair tying(const RepairPair& pair, std::int64_t tracked) {
  const std::int64_t other = tracked == pair.parts.a ? pair.parts.b : pair.parts.a;
  Repair tie = repair(pair, RepairKind::tie,
                      fmt::format("part {} is tied to part {}, and their contact ends", tracked, other), 1);
  tie.settings.tied = {{pair.parts.contact, tracked, other}};
  return tie;
}

/// True if the sides of a contact can change places: one-way, with segments on both sides.
bool one_way(const model::Contact& contact) {
  const auto names_nodes = [](const model::SurfaceInput& side) {
    return side.type == static_cast<std::int64_t>(model::SurfaceType::node_set);
  };
  const contact::ContactType type = contact::classify(contact);
  return type.treatment == contact::Treatment::one_way && type.family != contact::Family::tied &&
         contact.ignroff == 0 && contact.a.given && contact.b.given && !names_nodes(contact.a) &&
         !names_nodes(contact.b);
}

Repair swapping(const RepairPair& pair, ContactIndex position) {
  Repair swap = repair(
      pair, RepairKind::swap,
      fmt::format("the sides of contact {} change places, so that the other nodes are tracked", pair.parts.contact), 1);
  swap.settings.swapped = {position.value};
  return swap;
}

/// What the records of a pair say.
struct PairRecords {
  std::vector<Penetration> all;
  std::uint64_t released = 0, of_first = 0, of_second = 0;
  double deepest = 0, distance = 0;
};

/// By contact, in the order of the model, and parts.
using RecordsKey = std::pair<std::uint32_t, RepairParts>;

std::map<RecordsKey, PairRecords> records_by_pair(const model::Model& model, const contact::InitialState& state) {
  std::map<RecordsKey, PairRecords> pairs;
  for (const Penetration& record : state.penetrations) {
    if (!to_be_repaired(record.kind)) continue;
    const RepairParts parts = parts_of(model, record);
    PairRecords& pair = pairs[{record.contact, parts}];
    pair.all.push_back(record);
    pair.released += record.kind == PenetrationKind::released ? 1 : 0;
    ++(record.part == parts.a ? pair.of_first : pair.of_second);
    if (record.depth <= pair.deepest) continue;
    pair.deepest = record.depth;
    pair.distance = record.contact_distance;
  }
  return pairs;
}

std::string optt_of_one(std::int64_t part, double thickness) {
  return fmt::format("OPTT = {:.4g} for part {}", thickness, part);
}

/// Thicknesses for penetrations of segments and edges alone, which propose() does not look at. `alone`: no other parts
/// penetrate in the contact.
void add_thicknesses(const model::Model& model, ContactIndex position, const PairRecords& records, bool alone,
                     RepairPair& pair) {
  std::vector<Penetration> as_nodes = records.all;
  for (Penetration& record : as_nodes) record.kind = PenetrationKind::initial;
  const FreeThickness free = free_thickness(as_nodes, [&](const Penetration& p) {
    return DistanceRule{share_of_thickness(model, p), 0};
  });
  if (free.stuck_count > 0 || !std::isfinite(free.value) || pair.parts.a <= 0) return;
  const double thickness = rounded_down(free.value);
  const double cost = given_away(model, records.all, thickness);
  Repair parts = repair(pair, RepairKind::part_thickness, fmt::format("OPTT = {:.4g} for both parts", thickness), cost);
  for (const std::int64_t part : {pair.parts.a, pair.parts.b})
    if (!solid_part(model, part)) parts.settings.part_thickness.emplace(part, thickness);
  if (parts.settings.part_thickness.size() == 1)
    parts.text = optt_of_one(parts.settings.part_thickness.begin()->first, thickness);
  if (!parts.settings.part_thickness.empty()) pair.repairs.push_back(std::move(parts));
  if (!alone) return;
  const bool single = contact::classify(model.contact(position)).treatment == contact::Treatment::single_surface;
  Repair card =
      repair(pair, RepairKind::contact_thickness,
             fmt::format("SST{} = {:.4g} in contact {}", single ? "" : " = MST", thickness, pair.parts.contact), cost);
  card.settings.contact_thickness[position.value] = {thickness, single ? 0 : thickness};
  pair.repairs.push_back(std::move(card));
}

/// What propose() found for the nodes of a pair.
void add_alternatives(std::vector<FixAlternative> alternatives, RepairPair& pair) {
  pair.repairs.push_back(moving(pair));
  for (FixAlternative& alternative : alternatives) {
    Repair other = repair(pair, alternative.kind, std::move(alternative.text), alternative.cost);
    other.settings = std::move(alternative.settings);
    if (const auto& parts = other.settings.part_thickness; parts.size() == 1)
      other.text = optt_of_one(parts.begin()->first, parts.begin()->second);
    pair.repairs.push_back(std::move(other));
  }
}

Repair excluding(const RepairPair& pair) {
  Repair exclude = repair(pair, RepairKind::exclude, "no contact between the two, if they are meant to be joined", 1);
  exclude.settings.excluded = {pair.parts};
  return exclude;
}

/// The tied contacts with nodes that are too far away to tie.
void add_ties(const model::Model& model, const contact::InitialState& state, std::vector<RepairPair>& pairs) {
  const std::span<const contact::JudgedNode> judged = state.judged;
  for (std::size_t begin = 0, end = 0; begin < judged.size(); begin = end) {
    const ContactIndex position = judged[begin].contact;
    while (end < judged.size() && judged[end].contact == position) ++end;
    const auto far = far_nodes(model, judged.subspan(begin, end - begin));
    if (!far) continue;
    const model::Contact& contact = model.contact(position);
    RepairPair pair;
    pair.number = pairs.size() + 1;
    pair.of_ties = true;
    pair.parts.contact = contact.id.value;
    pair.penetrations = far->count;
    pair.deepest = far->farthest->distance;
    pair.contact_distance = far->farthest->allowed;
    Repair reach = repair(
        pair, RepairKind::reach,
        fmt::format("SST = {:.4g} in contact {}, which then reaches farther", -far->reach, pair.parts.contact), 1);
    reach.settings.contact_thickness[position.value] = {-far->reach, contact.mst};
    pair.repairs.push_back(std::move(reach));
    pairs.push_back(std::move(pair));
  }
}

}  // namespace

std::vector<RepairPair> list_repairs(model::Model& model, const contact::InitialState& state) {
  std::map<RepairParts, std::vector<FixAlternative>> proposed;
  for (FixProposal& proposal : propose(model, state))
    proposed[{proposal.contact, proposal.part, proposal.other_part}] = std::move(proposal.alternatives);
  const std::map<RecordsKey, PairRecords> records = records_by_pair(model, state);
  std::map<std::uint32_t, std::size_t> pairs_of_contact;
  for (const auto& [key, found] : records) ++pairs_of_contact[key.first];
  std::vector<RepairPair> pairs;
  for (const auto& [key, found] : records) {
    const ContactIndex position{key.first};
    RepairPair pair;
    pair.number = pairs.size() + 1;
    pair.parts = key.second;
    pair.penetrations = found.all.size();
    pair.released = found.released;
    pair.deepest = found.deepest;
    pair.contact_distance = found.distance;
    const bool two_parts = pair.parts.a > 0 && pair.parts.a != pair.parts.b;
    if (const auto known = proposed.find(pair.parts); known != proposed.end()) {
      add_alternatives(std::move(known->second), pair);
    } else {
      pair.repairs.push_back(moving(pair));
      add_thicknesses(model, position, found, pairs_of_contact[key.first] == 1, pair);
      if (two_parts) pair.repairs.push_back(excluding(pair));
    }
    if (two_parts) pair.repairs.push_back(tying(pair, found.of_first >= found.of_second ? pair.parts.a : pair.parts.b));
    if (one_way(model.contact(position))) pair.repairs.push_back(swapping(pair, position));
    std::ranges::stable_sort(pair.repairs, {}, &Repair::kind);
    pairs.push_back(std::move(pair));
  }
  add_ties(model, state, pairs);
  return pairs;
}

}  // namespace gapcheck::audit
