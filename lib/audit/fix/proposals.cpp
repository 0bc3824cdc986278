#include "audit/fix/proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "audit/fix/gaps.hpp"
#include "audit/fix/thickness_trial.hpp"
#include "audit/shared/free_thickness.hpp"
#include "audit/shared/records_of.hpp"
#include "base/work_watch.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit {
namespace {

/// Contact and the ids of the parts, the smaller one first.
using PairKey = std::tuple<ContactIndex, std::int64_t, std::int64_t>;

FixAlternative by_optt(const model::Model& model, std::int64_t a, std::int64_t b, double thickness) {
  FixAlternative alternative{fmt::format("OPTT = {:.4g} for both parts", thickness),
                             fmt::format("*PART_CONTACT  (card behind PID, SECID, MID of both parts)\n"
                                         "$       FS        FD        DC        VC      OPTT\n"
                                         "        0.        0.        0.        0.{:>10.4g}\n",
                                         thickness),
                             RepairKind::part_thickness};
  // Solids have no contact thickness of their own.
  for (const std::int64_t part : {a, b})
    if (!solid_part(model, part)) alternative.settings.part_thickness.emplace(part, thickness);
  return alternative;
}

FixAlternative by_sst(std::int64_t contact, ContactIndex position, double thickness, bool single) {
  FixAlternative alternative{fmt::format("SST{} = {:.4g} in contact {}", single ? "" : " = MST", thickness, contact),
                             fmt::format("$ card 3 of contact {}\n"
                                         "$      SFS       SFM       SST       MST\n"
                                         "        1.        1.{:>10.4g}{:>10.4g}\n",
                                         contact, thickness, single ? 0 : thickness),
                             RepairKind::contact_thickness};
  alternative.settings.contact_thickness[position.value] = {thickness, single ? 0 : thickness};
  return alternative;
}

FixAlternative by_sections(const ThinnerSections& thinner) {
  FixAlternative alternative{"", "", RepairKind::sections};
  alternative.settings.section_thickness = thinner.thickness;
  for (const auto& [section, thickness] : thinner.thickness) {
    alternative.text +=
        fmt::format("{}T1 … T4 = {:.4g} in section {}", alternative.text.empty() ? "" : ", ", thickness, section);
    alternative.card += fmt::format(
        "*SECTION_SHELL  (card 2 of section {})\n"
        "$       T1        T2        T3        T4\n"
        "{:>10.4g}{:>10.4g}{:>10.4g}{:>10.4g}\n",
        section, thickness, thickness, thickness, thickness);
  }
  alternative.text += "; this makes the shells softer and lighter";
  if (thinner.other_parts > 0)
    alternative.text += fmt::format(", also {} other part{}", thinner.other_parts, thinner.other_parts == 1 ? "" : "s");
  return alternative;
}

FixAlternative by_exclusion(std::int64_t contact, std::int64_t a, std::int64_t b) {
  FixAlternative alternative{"no contact between the two, if they are meant to be joined",
                             fmt::format("*{}\n"
                                         "$     CEID       CID\n"
                                         "         1{:>10}\n"
                                         "$     SIDA      SIDB     TYPEA     TYPEB\n"
                                         "{:>10}{:>10}         3         3\n",
                                         model::exclusion_keyword, contact, a, b),
                             RepairKind::exclude};
  alternative.settings.excluded = {{contact, a, b}};
  return alternative;
}

FixAlternative by_ignore(std::int64_t contact, ContactIndex position) {
  FixAlternative alternative{fmt::format("IGNORE = 1 in contact {}: the penetration stays, without force", contact),
                             fmt::format("$ card C of contact {}, behind cards A and B\n"
                                         "$     IGAP    IGNORE\n"
                                         "         1         1\n",
                                         contact),
                             RepairKind::ignore};
  alternative.settings.ignore = {position.value};
  return alternative;
}

double forgiven(const std::vector<Penetration>& records) {
  double largest = 0;
  for (const Penetration& p : records) largest = std::max(largest, p.depth / std::max(p.depth, p.contact_distance));
  return largest;
}

class Proposer {
 public:
  Proposer(model::Model& model, const contact::InitialState& state) : model_(model), state_(state), trial_(model) {}

  std::vector<FixProposal> run() {
    for (const Penetration& p : state_.penetrations)
      if (listed_by_solver(p.kind))
        pairs_[{ContactIndex{p.contact}, std::min(p.part, p.element_part), std::max(p.part, p.element_part)}].push_back(
            p);
    for (const auto& [key, records] : pairs_) ++pairs_of_contact_[std::get<0>(key)];
    find_cards();
    std::vector<FixProposal> list;
    for (const auto& [key, records] : pairs_) {
      if (work_stopped()) break;
      list.push_back(proposal(key, records));
    }
    return list;
  }

 private:
  /// SST of the contacts in which one pair of parts penetrates, as in GC308.
  void find_cards() {
    std::vector<ContactIndex> alone;
    for (const auto& [contact, count] : pairs_of_contact_)
      if (count == 1) alone.push_back(contact);
    for (const FreeCard& card : trial_.cards(alone, state_))
      if (card.bound.stuck_count + card.bound.coated_count == 0 && !card.optt)
        card_[card.contact] = rounded_down(card.value);
  }

  FixProposal proposal(const PairKey& key, const std::vector<Penetration>& records) {
    const auto& [position, a, b] = key;
    const model::Contact& contact = model_.contact(position);
    FixProposal proposal;
    proposal.contact = contact.id.value;
    proposal.part = a;
    proposal.other_part = b;
    proposal.penetrations = records.size();
    for (const Penetration& p : records) proposal.deepest = std::max(proposal.deepest, p.depth);
    const contact::ContactType type = contact::classify(contact);
    if (clear(records)) {
      const bool single = type.treatment == contact::Treatment::single_surface;
      if (const auto card = card_.find(position); card != card_.end()) {
        proposal.thickness = card->second;
        proposal.alternatives.push_back(by_sst(proposal.contact, position, card->second, single));
        proposal.alternatives.back().cost = given_away(model_, records, card->second);
      }
      if (a > 0 && b > 0) thickness_of_parts(key, records, proposal);
    }
    if (a > 0 && b > 0 && a != b) proposal.alternatives.push_back(by_exclusion(proposal.contact, a, b));
    if (contact::knows_ignore(type) && contact::settings(contact, type, model_.controls).ignore == 0) {
      proposal.alternatives.push_back(by_ignore(proposal.contact, position));
      proposal.alternatives.back().cost = forgiven(records);
    }
    return proposal;
  }

  /// True if every node keeps enough of its distance for a useful thickness.
  static bool clear(const std::vector<Penetration>& records) {
    return std::all_of(records.begin(), records.end(), [](const Penetration& p) { return far_enough(p); });
  }

  void thickness_of_parts(const PairKey& key, const std::vector<Penetration>& records, FixProposal& proposal) {
    if (trials_ == most_thickness_trials) {
      proposal.not_searched = true;
      return;
    }
    ++trials_;
    const auto& [position, a, b] = key;
    const double thickness = trial_.free_optt(position, a, b, records, records_of(state_, position));
    if (!(thickness > 0)) return;
    proposal.thickness = std::max(proposal.thickness, thickness);
    proposal.alternatives.push_back(by_optt(model_, a, b, thickness));
    proposal.alternatives.back().cost = given_away(model_, records, thickness);
    if (const auto thinner = trial_.sections(position, a, b, records, thickness)) {
      proposal.alternatives.push_back(by_sections(*thinner));
      proposal.alternatives.back().cost = given_away(model_, records, thickness);
    }
  }

  model::Model& model_;
  const contact::InitialState& state_;
  ThicknessTrial trial_;
  std::map<PairKey, std::vector<Penetration>> pairs_;
  std::map<ContactIndex, std::size_t> pairs_of_contact_;
  std::map<ContactIndex, double> card_;
  std::size_t trials_ = 0;
};

}  // namespace

std::vector<FixProposal> propose(model::Model& model, const contact::InitialState& state) {
  return Proposer(model, state).run();
}

}  // namespace gapcheck::audit
