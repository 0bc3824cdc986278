#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"
#include "base/union_find.hpp"
#include "contact/definition/exclusions.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::local_contacts {
namespace {

using contact::ContactCode;
using Parts = std::vector<PartIndex>;

/// From this number of contacts on, one for all is simpler.
constexpr std::array thresholds{
    Threshold{"contacts", 5, 2, 1e6, "contacts that hang together, from which on they are listed"}};

/// What two contacts must have in common to be one.
using Settings = std::vector<double>;

Settings settings_of(const model::Contact& c, const contact::ContactType& type, const model::Controls& controls) {
  const contact::ContactSettings s = contact::settings(c, type, controls);
  const auto number = [](std::int64_t value) { return static_cast<double>(value); };
  return {c.fs,
          c.fd,
          c.dc,
          c.vc,
          c.fsf,
          c.vsf,
          c.sfs,
          c.sst,
          c.sfst,
          c.birth,
          c.death,
          number(c.penchk),
          number(c.soft),
          c.penmax,
          number(c.thkopt),
          c.sldthk,
          c.sldstf,
          number(c.isym),
          number(s.ignore),
          number(s.snlog),
          number(s.shlthk),
          s.square_edges ? 1.0 : 0.0,
          s.mid_surface_offset ? 1.0 : 0.0,
          c.dprfac,
          number(c.tcso)};
}

/// What may differ, because it serves the search and the numerical stability.
struct Detail {
  std::string_view name;
  double (*of)(const model::Contact&);
};
constexpr std::array details{
    Detail{"VDC", [](const model::Contact& c) { return c.vdc; }},
    Detail{"SOFSCL", [](const model::Contact& c) { return c.sofscl; }},
    Detail{"MAXPAR", [](const model::Contact& c) { return c.maxpar; }},
    Detail{"DEPTH", [](const model::Contact& c) { return static_cast<double>(c.depth); }},
    Detail{"BSORT", [](const model::Contact& c) { return static_cast<double>(c.bsort); }},
    Detail{"SBOPT", [](const model::Contact& c) { return static_cast<double>(c.sbopt); }},
};

bool whole(const model::Contact& c, bool single) {
  if (single) return contact::whole_parts(c.a) || !c.a.given;
  return contact::whole_parts(c.a) && contact::whole_parts(c.b);
}

/// Automatic penalty contact of whole parts whose two sides are treated alike: a single-surface contact can replace it.
bool replaceable(const model::Model& model, const model::Contact& c, const contact::ContactType& type) {
  if (!c.known || c.own_layout || type.family != contact::Family::automatic || c.kind->ties()) return false;
  if (type.code != ContactCode::automatic_surface && type.code != ContactCode::automatic_single) return false;
  if (c.kind->cards != model::TypeCards::none || c.options.smooth || c.options.thermal || c.options.ortho_friction)
    return false;
  const bool single = type.treatment == contact::Treatment::single_surface;
  if (!single && (c.sst != c.mst || c.sfst != c.sfmt || c.sfs != c.sfm)) return false;
  return whole(c, single) && contact::Exclusions(model, c.id).empty();
}

Parts parts_of(Context& context, ContactIndex i) {
  const contact::ContactSurfaces& surfaces = context.surfaces(i);
  Parts parts = contact::parts_of(context.model(), surfaces.a), both;
  if (!surfaces.two_sided()) return parts;
  const Parts other = contact::parts_of(context.model(), surfaces.b);
  std::set_union(parts.begin(), parts.end(), other.begin(), other.end(), std::back_inserter(both));
  return both;
}

/// Contacts with the same settings that hang together by common parts.
struct Chain {
  std::vector<ContactIndex> contacts;
  Parts parts;
};

std::vector<Chain> chains(const std::vector<std::pair<ContactIndex, Parts>>& contacts, double many) {
  UnionFind sets(contacts.size());
  std::map<PartIndex, std::uint32_t> first_with;
  for (std::uint32_t i = 0; i < contacts.size(); ++i)
    for (const PartIndex part : contacts[i].second) sets.unite(first_with.try_emplace(part, i).first->second, i);
  std::map<std::uint32_t, Chain> by_root;
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    Chain& chain = by_root[sets.root(i)];
    chain.contacts.push_back(contacts[i].first);
    chain.parts.insert(chain.parts.end(), contacts[i].second.begin(), contacts[i].second.end());
  }
  std::vector<Chain> list;
  for (auto& [root, chain] : by_root) {
    std::sort(chain.parts.begin(), chain.parts.end());
    chain.parts.erase(std::unique(chain.parts.begin(), chain.parts.end()), chain.parts.end());
    if (static_cast<double>(chain.contacts.size()) >= many) list.push_back(std::move(chain));
  }
  return list;
}

/// "; they differ in VDC (0, 20) and BSORT (10, 100)", or nothing.
std::string differences(const model::Model& model, const Chain& chain) {
  std::string text;
  for (const Detail& detail : details) {
    std::set<double> values;
    for (const ContactIndex i : chain.contacts) values.insert(detail.of(model.contact(i)));
    if (values.size() > 1)
      text +=
          fmt::format("{} {} ({:g})", text.empty() ? "; they differ in" : " and", detail.name, fmt::join(values, ", "));
  }
  return text;
}

Finding words(const RuleIdentity& rule, const Context& context, const Chain& chain) {
  const model::Model& model = context.model();
  std::vector<std::int64_t> ids;
  for (const ContactIndex i : chain.contacts) ids.push_back(model.contact(i).id.value);
  Finding f = finding_at(
      rule, context, model.contact(chain.contacts.front()),
      fmt::format(
          "{} contacts ({}) with the same settings hold {} parts that hang together{}: one {} of these parts is "
          "simpler, and also finds what meets unexpectedly",
          ids.size(), first_few(ids), chain.parts.size(), differences(model, chain),
          model::recommended_keyword(ContactCode::automatic_single)));
  f.count = ids.size();
  return f;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  std::map<Settings, std::vector<std::pair<ContactIndex, Parts>>> by_settings;
  std::vector<Parts> global;
  std::size_t candidates = 0;
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& c = model.contact(i);
    candidates += replaceable(model, c, contact::classify(c)) ? 1 : 0;
  }
  const double many = context.threshold(rule, thresholds[0]);
  if (static_cast<double>(candidates) < many) return;
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& c = model.contact(i);
    const contact::ContactType type = contact::classify(c);
    const bool one_for_all = type.treatment == contact::Treatment::single_surface;
    if (one_for_all) global.push_back(parts_of(context, i));
    if (replaceable(model, c, type))
      by_settings[settings_of(c, type, model.controls)].emplace_back(
          i, one_for_all ? global.back() : parts_of(context, i));
  }
  std::vector<std::pair<ContactIndex, Finding>> found;
  for (const auto& [settings, contacts] : by_settings)
    for (const Chain& chain : chains(contacts, many)) {
      // What a global contact holds as well was taken apart on purpose, or twice.
      const bool held = std::any_of(global.begin(), global.end(), [&](const Parts& parts) {
        return std::includes(parts.begin(), parts.end(), chain.parts.begin(), chain.parts.end());
      });
      const bool chosen = std::any_of(chain.parts.begin(), chain.parts.end(),
                                      [&](PartIndex part) { return context.part_chosen(part); });
      if (!held && chosen) found.emplace_back(chain.contacts.front(), words(rule, context, chain));
    }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Finding> findings;
  findings.reserve(found.size());
  for (auto& [first, finding] : found) findings.push_back(std::move(finding));
  add_first(report, std::move(findings), "more groups of contacts could be one contact each");
}

}  // namespace

const Rule definition{
    .identity = {"GC425", "local-contacts", Severity::note,
                 "many local contacts with the same settings hold parts that hang together", Need::surfaces,
                 "The run takes longer than with one contact, and pairs are forgotten easily"},
    .run = run,
    .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::local_contacts
