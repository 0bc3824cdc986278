#include "records/record_rules.hpp"

#include <algorithm>
#include <array>

namespace gapcheck {
namespace {

/// Nodes that penetrate, from bad to worse: outside every segment's band, in a segment, too deep. Ties: the node is
/// moved, the node keeps its distance, no tie at all.
constexpr std::array all_record_rules{
    RecordRule{record_rules::edge_zone_penetration, record_rules::initial_penetration.id, 0},
    RecordRule{record_rules::initial_penetration, record_rules::initial_penetration.id, 1},
    RecordRule{record_rules::released_node, record_rules::initial_penetration.id, 2},
    RecordRule{record_rules::segment_penetration, record_rules::segment_penetration.id},
    RecordRule{record_rules::mortar_penetration, record_rules::mortar_penetration.id},
    RecordRule{record_rules::edge_penetration, record_rules::edge_penetration.id},
    RecordRule{record_rules::tie_moved, record_rules::untied_node.id, 0},
    RecordRule{record_rules::tie_offset, record_rules::untied_node.id, 1},
    RecordRule{record_rules::untied_node, record_rules::untied_node.id, 2},
};

}  // namespace

const RuleIdentity& rule_of(PenetrationKind kind) {
  switch (kind) {
    case PenetrationKind::initial:
      return record_rules::initial_penetration;
    case PenetrationKind::released:
      return record_rules::released_node;
    case PenetrationKind::edge_zone:
      return record_rules::edge_zone_penetration;
    case PenetrationKind::segment:
      return record_rules::segment_penetration;
    case PenetrationKind::mortar:
      return record_rules::mortar_penetration;
    case PenetrationKind::edge:
      return record_rules::edge_penetration;
  }
  return record_rules::initial_penetration;
}

const RuleIdentity& rule_of(TieReason reason) {
  if (untied(reason)) return record_rules::untied_node;
  return reason == TieReason::sep ? record_rules::tie_moved : record_rules::tie_offset;
}

RuleIdentity rule_of(const TieFailure& failure) {
  RuleIdentity rule = rule_of(failure.reason);
  if (untied(failure.reason) && failure.by_node_set) rule.severity = Severity::error;
  if (failure.moved_far()) rule.severity = Severity::warning;
  return rule;
}

const RecordRule* find_record_rule(std::string_view id) {
  const auto found = std::find_if(all_record_rules.begin(), all_record_rules.end(),
                                  [&](const RecordRule& rule) { return rule.identity.id == id; });
  return found == all_record_rules.end() ? nullptr : &*found;
}

}  // namespace gapcheck
