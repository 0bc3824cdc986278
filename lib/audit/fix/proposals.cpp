#include "audit/fix/proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "audit/fix/gaps.hpp"
#include "contact/contact_type.hpp"

namespace gapcheck::audit {
namespace {

/// What is left of the distance must be more than this share of it: a thickness of next to nothing is none.
constexpr double least_share = 0.05;

bool solid_part(const model::Model& model, std::int64_t id) {
  const auto part = model.part_of_id.find(id);
  if (part == model.part_of_id.end()) return false;
  const auto& section = model.part(part->second).section;
  if (!section) return false;
  const model::SectionKind kind = model.sections[*section].kind;
  return kind == model::SectionKind::solid || kind == model::SectionKind::thick_shell;
}

/// Four digits, rounded down: what is printed must still be free.
double rounded_down(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / unit * (1 + 1e-12)) * unit;
}

struct Pair {
  std::uint64_t count = 0;
  double deepest = 0;
  double thickness = std::numeric_limits<double>::infinity();
  bool behind = false;  ///< a node lies on or behind the segment: no thickness helps
  bool optt = false;    ///< a thickness of the parts themselves goes before SST
};

void take(Pair& pair, const model::Model& model, const Penetration& p) {
  ++pair.count;
  pair.deepest = std::max(pair.deepest, p.depth);
  pair.optt = pair.optt || p.node_rule == ThicknessRule::part_contact || p.segment_rule == ThicknessRule::part_contact;
  const double share = (solid_part(model, p.part) ? 0 : 0.5) + (solid_part(model, p.element_part) ? 0 : 0.5);
  if (share == 0 || !(p.remaining() > least_share * p.contact_distance))
    pair.behind = true;
  else
    pair.thickness = std::min(pair.thickness, p.remaining() / share);
}

FixAlternative by_optt(double thickness) {
  return {fmt::format("OPTT = {:.4g} for both parts", thickness),
          fmt::format("*PART_CONTACT  (card behind PID, SECID, MID of both parts)\n"
                      "$       FS        FD        DC        VC      OPTT\n"
                      "        0.        0.        0.        0.{:>10.4g}\n",
                      thickness)};
}

FixAlternative by_sst(std::int64_t contact, double thickness, bool single) {
  return {fmt::format("SST{} = {:.4g} in contact {}", single ? "" : " = MST", thickness, contact),
          fmt::format("$ card 3 of contact {}\n"
                      "$      SFS       SFM       SST       MST\n"
                      "        1.        1.{:>10.4g}{:>10.4g}\n",
                      contact, thickness, single ? 0 : thickness)};
}

FixAlternative by_exclusion(std::int64_t contact, std::int64_t a, std::int64_t b) {
  return {"no contact between the two, if they are meant to be joined",
          fmt::format("*CONTACT_EXCLUDE_INTERACTION\n"
                      "$     CEID       CID\n"
                      "         1{:>10}\n"
                      "$     SIDA      SIDB     TYPEA     TYPEB\n"
                      "{:>10}{:>10}         3         3\n",
                      contact, a, b)};
}

FixAlternative by_ignore(std::int64_t contact) {
  return {fmt::format("IGNORE = 1 in contact {}: the penetration stays, without force", contact),
          fmt::format("$ card C of contact {}, behind cards A and B\n"
                      "$   IGNORE\n"
                      "         1\n",
                      contact)};
}

}  // namespace

std::vector<FixProposal> propose(const model::Model& model, std::span<const Penetration> records) {
  std::map<std::tuple<std::uint32_t, std::int64_t, std::int64_t>, Pair> pairs;
  for (const Penetration& p : records)
    if (to_be_fixed(p.kind))
      take(pairs[{p.contact, std::min(p.part, p.element_part), std::max(p.part, p.element_part)}], model, p);
  std::map<std::uint32_t, std::size_t> pairs_of_contact;
  for (const auto& [key, pair] : pairs) ++pairs_of_contact[std::get<0>(key)];
  std::vector<FixProposal> list;
  for (const auto& [key, pair] : pairs) {
    const auto& [position, a, b] = key;
    const model::Contact& contact = model.contacts[position];
    FixProposal proposal;
    proposal.contact = contact.id.value;
    proposal.part = a;
    proposal.other_part = b;
    proposal.penetrations = pair.count;
    proposal.deepest = pair.deepest;
    const contact::ContactType type = contact::classify(contact);
    if (!pair.behind && std::isfinite(pair.thickness)) {
      proposal.thickness = rounded_down(pair.thickness);
      const bool single = type.treatment == contact::Treatment::single_surface;
      if (pairs_of_contact[position] == 1 && !pair.optt)
        proposal.alternatives.push_back(by_sst(proposal.contact, proposal.thickness, single));
      if (a > 0 && b > 0) proposal.alternatives.push_back(by_optt(proposal.thickness));
    }
    if (a > 0 && b > 0 && a != b) proposal.alternatives.push_back(by_exclusion(proposal.contact, a, b));
    if (contact::settings(contact, type, model.controls).ignore == 0)
      proposal.alternatives.push_back(by_ignore(proposal.contact));
    list.push_back(std::move(proposal));
  }
  return list;
}

}  // namespace gapcheck::audit
