#pragma once
#include <string_view>

#include "records/penetration.hpp"
#include "records/rule_identity.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck {

/// The rules whose findings are records. Their identity is here and not in their own files, because reports on solver
/// files show the same records without an audit.
namespace record_rules {

// Severity warning: the solver copes, but the model is not the intended one.
inline constexpr RuleIdentity initial_penetration{
    "GC101",
    "initial-penetration",
    Severity::warning,
    "a tracked node is nearer to a segment than the contact distance when the solver starts",
    Need::node_penetrations,
    "The solver moves the nodes out, or starts with a force on them"};
inline constexpr RuleIdentity released_node{
    "GC102",
    "released-node",
    Severity::error,
    "a tracked node penetrates so deep that the solver drops it from the contact",
    Need::node_penetrations,
    "The contact lets go of the nodes: they pass through freely"};
inline constexpr RuleIdentity edge_zone_penetration{
    "GC106",
    "edge-zone-penetration",
    Severity::note,
    "a node is within the contact distance of an edge or corner, but outside every segment's band",
    Need::node_penetrations,
    "Nothing at the start, but contact begins with a jump as soon as the node slides over the segment"};
inline constexpr RuleIdentity segment_penetration{
    "GC107",
    "segment-penetration",
    Severity::warning,
    "a corner of a segment is nearer to another segment than the contact distance, in a contact with SOFT = 2",
    Need::segment_penetrations,
    "The contact starts with a force, or forgives the overlap if IGNORE says so"};
inline constexpr RuleIdentity mortar_penetration{
    "GC108",
    "mortar-penetration",
    Severity::warning,
    "a corner of a segment is nearer to another segment than the contact distance, in a mortar contact",
    Need::mortar_penetrations,
    "The contact starts with a force, or forgives the overlap if IGNORE says so"};
inline constexpr RuleIdentity edge_penetration{
    "GC109",
    "edge-penetration",
    Severity::warning,
    "two edges or beams are nearer to each other than the contact distance, in a contact of type 26",
    Need::edge_penetrations,
    "The contact starts with a force on the edges"};

inline constexpr RuleIdentity untied_node{"GC201",           "untied-node",
                                          Severity::warning, "a node of a tied contact stays untied",
                                          Need::ties,        "The nodes are not joined to anything"};
inline constexpr RuleIdentity tie_offset{
    "GC202",           "tie-offset",
    Severity::warning, "a tied node keeps a distance whose moments the tie does not carry",
    Need::ties,        "The tie drops the moments of the distance: it is too soft, or creates energy in rotation"};
inline constexpr RuleIdentity tie_moved{"GC204",        "tie-moved",
                                        Severity::note, "tying moves a node visibly, without stress",
                                        Need::ties,     "The mesh changes where the tie moves its nodes"};

}  // namespace record_rules

/// The rule that a penetration of this kind is a finding of.
[[nodiscard]] const RuleIdentity& rule_of(PenetrationKind kind);
/// The rule that a node of a tied contact is a finding of.
[[nodiscard]] const RuleIdentity& rule_of(TieReason reason);
/// The same with the severity for this node: an untied one is an error if a node set names it, one that is moved by
/// more than both parts are thick a warning.
[[nodiscard]] RuleIdentity rule_of(const TieFailure& failure);

/// A rule whose findings are records. Rules that judge the same problem by degrees are one family: nodes that
/// penetrate, nodes that should tie.
struct RecordRule {
  RuleIdentity identity;
  std::string_view family;  ///< id of the rule that represents all degrees; its own if there is only one
  int degree = 0;           ///< the higher, the worse
};

/// By id; nullptr: findings of this rule are not records.
[[nodiscard]] const RecordRule* find_record_rule(std::string_view id);

}  // namespace gapcheck
