#include "audit/fix/untreated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "contact/initial.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit {
namespace {

void count(const Penetration& record, Untreated& to) {
  if (record.kind == PenetrationKind::edge) {
    ++to.edges;
  } else if (record.kind == PenetrationKind::segment || record.kind == PenetrationKind::mortar) {
    ++to.segments.penetrations;
    to.segments.deepest = std::max(to.segments.deepest, record.depth);
  }
}

std::string left(std::uint64_t count, std::string_view what, const RuleIdentity& rule, std::string_view why) {
  return fmt::format("{} penetration{} of {} {} not corrected ({}): {}", count, count == 1 ? "" : "s", what,
                     count == 1 ? "is" : "are", rule.id, why);
}

}  // namespace

std::vector<Untreated> find_untreated(model::Model& model, std::vector<Vector> x) {
  std::vector<Untreated> all(model.contacts.size());
  bool any = false;
  for (std::size_t c = 0; c < all.size(); ++c) {
    const contact::ContactType type = contact::classify(model.contacts[c]);
    all[c].by_segments = type.by_segments();
    all[c].mortar = type.pairing == contact::Pairing::mortar;
    any = any || all[c].by_segments || type.edges;
  }
  if (!any) return {};
  std::swap(model.mesh.nodes.x, x);
  contact::InitialOptions options;
  options.nodes_stay = true;
  options.repeated = false;
  options.segments = options.mortar = options.edges = true;
  contact::InitialCounters counters;
  contact::SurfaceStore surfaces(model);
  const contact::InitialState state = contact::initialise_contacts(model, surfaces, options, counters);
  std::swap(model.mesh.nodes.x, x);
  for (const Penetration& record : state.penetrations) count(record, all[record.contact]);
  return all;
}

std::string words(const Untreated& untreated) {
  constexpr std::string_view nodes_only = "nodes are moved out of segments only; gapcheck audit lists them";
  if (untreated.edges > 0) return left(untreated.edges, "edges", record_rules::edge_penetration, nodes_only);
  const RuleIdentity& rule = untreated.mortar ? record_rules::mortar_penetration : record_rules::segment_penetration;
  return untreated.segments.penetrations == 0 ? ""
                                              : left(untreated.segments.penetrations, "segments", rule, nodes_only);
}

}  // namespace gapcheck::audit
