#include "audit/rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace gapcheck::audit {
namespace {

constexpr std::size_t in_full = 10;

/// "node 12 is defined again" → "node": faults about the same kind of thing are grouped.
std::string thing(const std::string& message) { return message.substr(0, message.find(' ')); }

}  // namespace

const std::string& Context::path(FileIndex file) const {
  static const std::string empty;
  return file.value < deck_.files().size() ? deck_.file(file).path : empty;
}

std::vector<std::uint32_t> Context::contacts() const {
  std::vector<std::uint32_t> chosen;
  const auto& ids = options_.contacts;
  for (std::uint32_t i = 0; i < model_.contacts.size(); ++i)
    if (ids.empty() || std::find(ids.begin(), ids.end(), model_.contacts[i].id.value) != ids.end()) chosen.push_back(i);
  return chosen;
}

std::vector<std::uint32_t> Context::read_contacts() const {
  std::vector<std::uint32_t> chosen = contacts();
  std::erase_if(chosen, [&](std::uint32_t i) {
    const model::Contact& contact = model_.contacts[i];
    return !contact.known || contact.own_layout || !contact.cards.any;
  });
  return chosen;
}

bool Context::part_chosen(PartIndex part) const {
  const auto& ids = options_.parts;
  if (ids.empty()) return true;
  return part != none<PartIndex> && std::find(ids.begin(), ids.end(), model_.part(part).id.value) != ids.end();
}

void Context::skipped(const RuleInfo& rule, std::string what) {
  skips_.push_back(fmt::format("{}: {}", rule.id, what));
}

contact::InitialOptions Context::initial_options() const {
  contact::InitialOptions options;
  options.contacts = options_.contacts;
  options.tolerance = options_.ptol;
  options.mode = options_.exact ? geometry::Mode::exact : geometry::Mode::filtered;
  options.brute_force = options_.brute_force;
  return options;
}

contact::ContactMesh& Context::contact_mesh() {
  ++requests_;
  if (!contact_mesh_) contact_mesh_.emplace(model_, surfaces_, contacts());
  return *contact_mesh_;
}

contact::InitialState& Context::initial() {
  ++requests_;
  if (!initial_) {
    contact::InitialOptions options = initial_options();
    // Asked here and not by want(): another rule may need the initialisation before these have had their turn.
    const auto asked = [&](std::string_view id) {
      const RuleInfo* rule = find_rule(id);
      return rule != nullptr && selected(*rule, options_.select, options_.ignore);
    };
    options.segments = asked("GC107");
    options.mortar = asked("GC108");
    options.edges = asked("GC109");
    initial_ = contact::initialise_contacts(model_, surfaces_, options, counters_);
  }
  return *initial_;
}

contact::InitialState Context::initial_if(contact::SurfaceStore& surfaces,
                                          const std::vector<std::uint32_t>& chosen) {
  contact::InitialOptions options = initial_options();
  options.nodes_stay = true;
  options.contacts.clear();
  for (const std::uint32_t i : chosen) options.contacts.push_back(model_.contacts[i].id.value);
  // Tied nodes are not reported against what they are tied to, so the ties must be made.
  for (const std::uint32_t i : contacts())
    if (contact::classify(model_.contacts[i]).family == contact::Family::tied)
      options.contacts.push_back(model_.contacts[i].id.value);
  return contact::initialise_contacts(model_, surfaces, options, other_counters_);
}

const contact::PredictedTimesteps& Context::timesteps() {
  ++requests_;
  if (!timesteps_) timesteps_ = contact::predict_timesteps(model_, surfaces_, contacts());
  return *timesteps_;
}

Finding finding(const RuleInfo& rule, std::string message, std::string file, std::uint32_t line) {
  Finding f;
  f.id = rule.id;
  f.rule = rule.name;
  f.severity = rule.severity;
  f.message = std::move(message);
  f.file = std::move(file);
  f.line = line;
  return f;
}

Finding finding_at(const RuleInfo& rule, const Context& context, const model::Contact& contact, std::string message) {
  Finding f = finding(rule, std::move(message), context.path(contact.place.file), contact.place.line);
  f.contact = contact.id.value;
  return f;
}

void add_faults(const RuleInfo& rule, Context& context, Report& report, model::Fault::Kind kind) {
  std::map<std::string, std::size_t> count;
  for (const model::Fault& fault : context.model().faults) {
    if (fault.kind != kind) continue;
    if (++count[thing(fault.message)] <= in_full)
      report.findings.push_back(finding(rule, fault.message, context.path(fault.place.file), fault.place.line));
  }
  for (const auto& [what, n] : count) {
    if (n > in_full)
      report.findings.push_back(finding(rule, fmt::format("{}: {} more findings of this kind", what, n - in_full), "", 0));
  }
}

}  // namespace gapcheck::audit
