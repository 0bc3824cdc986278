#include <cstddef>
#include <gapcheck/records.hpp>
#include <limits>

#include "api/convert.hpp"
#include "api/report_store.hpp"
#include "base/parallel.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::api {
namespace {

/// The enumerator at the same position; the assertions below hold the two lists together.
template <class To, class From>
To same(From value) {
  return static_cast<To>(value);
}

template <class A, class B>
constexpr bool equal(A a, B b) {
  return static_cast<int>(a) == static_cast<int>(b);
}

static_assert(equal(PenetrationKind::initial, gapcheck::PenetrationKind::initial) &&
              equal(PenetrationKind::released, gapcheck::PenetrationKind::released) &&
              equal(PenetrationKind::edge_zone, gapcheck::PenetrationKind::edge_zone) &&
              equal(PenetrationKind::segment, gapcheck::PenetrationKind::segment) &&
              equal(PenetrationKind::mortar, gapcheck::PenetrationKind::mortar) &&
              equal(PenetrationKind::edge, gapcheck::PenetrationKind::edge) && penetration_kinds == 6);
static_assert(equal(Outcome::moved, gapcheck::Outcome::moved) && equal(Outcome::kept, gapcheck::Outcome::kept) &&
              equal(Outcome::forced, gapcheck::Outcome::forced) &&
              equal(Outcome::released, gapcheck::Outcome::released) &&
              equal(Outcome::reported, gapcheck::Outcome::reported));
static_assert(equal(Feature::face, gapcheck::Feature::face) && equal(Feature::edge, gapcheck::Feature::edge) &&
              equal(Feature::corner, gapcheck::Feature::corner));
static_assert(equal(ThicknessRule::none, gapcheck::ThicknessRule::none) &&
              equal(ThicknessRule::element, gapcheck::ThicknessRule::element) &&
              equal(ThicknessRule::edge_limit, gapcheck::ThicknessRule::edge_limit) &&
              equal(ThicknessRule::contact_card, gapcheck::ThicknessRule::contact_card) &&
              equal(ThicknessRule::global, gapcheck::ThicknessRule::global) &&
              equal(ThicknessRule::part_contact, gapcheck::ThicknessRule::part_contact) &&
              equal(ThicknessRule::solid_coating, gapcheck::ThicknessRule::solid_coating) &&
              equal(ThicknessRule::beam_section, gapcheck::ThicknessRule::beam_section));
static_assert(equal(TieReason::sep, gapcheck::TieReason::sep) &&
              equal(TieReason::offset, gapcheck::TieReason::offset) &&
              equal(TieReason::too_far, gapcheck::TieReason::too_far) &&
              equal(TieReason::too_short, gapcheck::TieReason::too_short) &&
              equal(TieReason::not_found, gapcheck::TieReason::not_found) &&
              equal(TieReason::rigslav, gapcheck::TieReason::rigslav) &&
              equal(TieReason::rigmast, gapcheck::TieReason::rigmast) &&
              equal(TieReason::conflict, gapcheck::TieReason::conflict));

}  // namespace

std::string_view name(Outcome outcome) { return gapcheck::name(same<gapcheck::Outcome>(outcome)); }
std::string_view name(Feature feature) { return gapcheck::name(same<gapcheck::Feature>(feature)); }
std::string_view name(ThicknessRule rule) { return gapcheck::name(same<gapcheck::ThicknessRule>(rule)); }
std::string_view name(TieReason reason) { return gapcheck::name(same<gapcheck::TieReason>(reason)); }
std::string_view rule_id(PenetrationKind kind) { return gapcheck::rule_of(same<gapcheck::PenetrationKind>(kind)).id; }
std::string_view rule_id(TieReason reason) { return gapcheck::rule_of(same<gapcheck::TieReason>(reason)).id; }
bool untied(TieReason reason) { return gapcheck::untied(same<gapcheck::TieReason>(reason)); }

PenetrationColumns::PenetrationColumns(const std::vector<Penetration>& records) {
  const std::size_t n = records.size();
  const auto size = [](std::size_t length, auto&... columns) { (columns.resize(length), ...); };
  size(n, kind, contact, segment_number, file, line, node, part, element, element_part, depth, contact_distance,
       outcome, feature, node_rule, segment_rule);
  size(4 * n, segment);
  size(2 * n, local);
  size(3 * n, position, closest, moved_to);
  const auto fill = [&](std::size_t i) {
    const Penetration& p = records[i];
    kind[i] = same<PenetrationKind>(p.kind);
    contact[i] = p.contact;
    segment_number[i] = p.segment_number;
    file[i] = p.file;
    line[i] = p.line;
    node[i] = p.node;
    part[i] = p.part;
    for (std::size_t k = 0; k < 4; ++k) segment[4 * i + k] = p.segment[k];
    element[i] = p.element;
    element_part[i] = p.element_part;
    depth[i] = p.depth;
    contact_distance[i] = p.contact_distance;
    local[2 * i] = p.s;
    local[2 * i + 1] = p.t;
    copy(p.original, &position[3 * i]);
    copy(p.point, &closest[3 * i]);
    copy(p.moved_to, &moved_to[3 * i]);
    outcome[i] = same<Outcome>(p.outcome);
    feature[i] = same<Feature>(p.feature);
    node_rule[i] = same<ThicknessRule>(p.node_rule);
    segment_rule[i] = same<ThicknessRule>(p.segment_rule);
  };
  constexpr std::size_t piece = 10000;
  parallel_for(n, piece, [&fill](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fill(i);
  });
}

Penetrations PenetrationColumns::view() const {
  return {kind,  contact,  node,    part,     segment, segment_number, element,   element_part, depth, contact_distance,
          local, position, closest, moved_to, outcome, feature,        node_rule, segment_rule, file,  line};
}

TieColumns::TieColumns(const std::vector<TieFailure>& records) {
  for (const TieFailure& t : records) {
    reason.push_back(same<TieReason>(t.reason));
    contact.push_back(t.contact);
    segment_number.push_back(t.segment_number);
    file.push_back(t.file);
    line.push_back(t.line);
    node.push_back(t.node);
    part.push_back(t.part);
    distance.push_back(t.distance);
    allowed.push_back(t.allowed);
    for (int axis = 0; axis < 3; ++axis)
      position.push_back(t.position ? (*t.position)[axis] : std::numeric_limits<double>::quiet_NaN());
    by_node_set.push_back(t.by_node_set ? 1 : 0);
  }
}

Ties TieColumns::view() const {
  return {reason, contact, node, part, segment_number, distance, allowed, position, by_node_set, file, line};
}

}  // namespace gapcheck::api
