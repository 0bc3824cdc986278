#include "audit/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "audit/rules.hpp"

namespace gapcheck::audit {
namespace {

using PlaceKey = std::pair<std::string_view, std::uint32_t>;

/// Where the set of one side of a contact is defined, if the set has no members; no line otherwise.
model::Place place_of_set(const model::Model& model, const model::SurfaceInput& side) {
  const auto in = [&side](const auto& sets) {
    const auto found = sets.find(side.id);
    return found == sets.end() || !found->second.members.empty() ? model::Place{} : found->second.place;
  };
  using enum model::SurfaceType;
  switch (static_cast<model::SurfaceType>(side.type)) {
    case segment_set:
      return in(model.sets.segments);
    case shell_set:
      return in(model.sets.shells);
    case part_set:
      return in(model.sets.parts);
    case branch:
      return in(model.sets.branches);
    case node_set:
      return in(model.sets.nodes);
    default:
      return {};
  }
}

/// The findings that something empty may follow from, by the place of what they are about.
class Keys {
 public:
  Keys(std::string_view rule, Report& report) {
    for (Finding& finding : report.findings) {
      if (finding.id != rule || finding.line == 0) continue;
      finding.key = ++last_;
      of_place_.emplace(PlaceKey(finding.file, finding.line), finding.key);
    }
  }
  /// 0: none.
  [[nodiscard]] std::uint32_t at(const Context& context, model::Place place) const {
    if (place.line == 0) return 0;
    const auto found = of_place_.find(PlaceKey(context.path(place.file), place.line));
    return found == of_place_.end() ? 0 : found->second;
  }

 private:
  std::map<PlaceKey, std::uint32_t> of_place_;
  std::uint32_t last_ = 0;
};

bool is_of(const Finding& finding, const Rule& rule) { return finding.id == rule.identity.id; }
/// What may follow from something that is not there as a whole.
bool misses_something(const Finding& finding) {
  return is_of(finding, rule::unknown_reference::definition) || is_of(finding, rule::empty_surface::definition);
}

/// Whatever is not defined may be in a file that was not found. False: none is missing.
bool follow_from_missing_include(Report& report) {
  constexpr std::uint32_t key = 1;
  const auto missing = std::find_if(report.findings.begin(), report.findings.end(), [&](const Finding& finding) {
    return is_of(finding, rule::missing_include::definition);
  });
  if (missing == report.findings.end()) return false;
  missing->key = key;
  for (Finding& finding : report.findings)
    if (misses_something(finding)) finding.cause = key;
  return true;
}

/// A deck without any nodes or parts is a piece of one: elements only, or a contact only. One finding says so, of the
/// rule that would otherwise list all that is missing. False: it has both, or misses nothing.
bool follow_from_fragment(const Context& context, Report& report) {
  constexpr std::uint32_t key = 1;
  const model::Model& model = context.model();
  const bool no_nodes = model.mesh.nodes.size() == 0, no_parts = model.parts.empty();
  if ((!no_nodes && !no_parts) || context.deck().counters().encrypted_blocks > 0) return false;
  const auto first = std::find_if(report.findings.begin(), report.findings.end(), misses_something);
  if (first == report.findings.end()) return false;
  const Rule& rule = is_of(*first, rule::unknown_reference::definition) ? rule::unknown_reference::definition
                                                                        : rule::empty_surface::definition;
  Finding root = finding(rule.identity,
                         fmt::format("this is a piece of a deck, which defines no {}: audit the file that includes it",
                                     no_nodes && no_parts ? "nodes and no parts"
                                     : no_nodes           ? "nodes"
                                                          : "parts"),
                         first->file, first->line);
  for (Finding& each : report.findings)
    if (misses_something(each)) each.cause = key;
  root.key = key;
  report.findings.insert(first, std::move(root));
  return true;
}

}  // namespace

void link_causes(const Context& context, Report& report) {
  if (follow_from_missing_include(report) || follow_from_fragment(context, report)) return;
  const Keys references(rule::unknown_reference::definition.identity.id, report);
  const model::Model& model = context.model();
  std::map<std::tuple<std::int64_t, std::string_view, std::uint32_t>, std::uint32_t> of_contact;
  for (const model::Contact& contact : model.contacts)
    for (const model::SurfaceInput* side : {&contact.a, &contact.b})
      if (const std::uint32_t key = references.at(context, place_of_set(model, *side)); key != 0)
        of_contact.emplace(
            std::tuple(contact.id.value, std::string_view(context.path(contact.place.file)), contact.place.line), key);
  for (Finding& finding : report.findings) {
    if (finding.id != rule::empty_surface::definition.identity.id) continue;
    const auto cause = of_contact.find({finding.contact, finding.file, finding.line});
    if (cause != of_contact.end()) finding.cause = cause->second;
  }
}

}  // namespace gapcheck::audit
