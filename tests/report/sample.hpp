#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

#include "records/report.hpp"

namespace gapcheck::report {

inline ContactSummary make_contact(std::int64_t id, std::uint32_t order, std::string keyword, std::string type,
                                   std::uint64_t tracked_nodes, std::uint64_t segments) {
  ContactSummary contact;
  contact.id = id;
  contact.order = order;
  contact.keyword = std::move(keyword);
  contact.type = std::move(type);
  contact.tracked_nodes = tracked_nodes;
  contact.segments = segments;
  return contact;
}

/// Of severity error.
inline Finding make_finding(std::string id, std::string rule, std::string message) {
  Finding finding;
  finding.id = std::move(id);
  finding.rule = std::move(rule);
  finding.severity = Severity::error;
  finding.message = std::move(message);
  return finding;
}

/// Two plates: three records of different kinds in the first of two contacts, two findings.
inline Report sample_report() {
  Report report;
  report.source = "deck";
  report.input = "plates.k";
  report.files = {"plates.k", "mesh.k"};
  report.model = {.nodes = 50, .shells = 32, .parts = 2, .contacts = 2};
  report.contacts.push_back(make_contact(7, 1, "CONTACT_AUTOMATIC_SINGLE_SURFACE", "13", 50, 32));
  report.contacts[0].title = "plates";
  report.contacts[0].penetrations = report.contacts[0].released = report.contacts[0].edge_zone = 1;
  report.contacts[0].max_penetration = 0.9;
  report.contacts[0].file = "plates.k";
  report.contacts[0].line = 34;
  report.contacts.push_back(make_contact(2, 2, "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", "a3", 4, 1));
  report.contacts[1].not_checked = "SOFT = 2 is checked segment by segment";
  Penetration deep;
  deep.node = 14;
  deep.part = 1;
  deep.segment = {22124, 22164, 22165, 22125};
  deep.element = 500;
  deep.element_part = 2;
  deep.depth = 0.9;
  deep.contact_distance = 1;
  deep.s = -0.24;
  deep.t = -0.08;
  deep.original = {10, 20, 0.1};
  deep.point = {10, 20, 0};
  deep.moved_to = deep.original;
  deep.file = 1;
  deep.line = 1234;
  deep.kind = PenetrationKind::released;
  deep.outcome = Outcome::released;
  deep.node_rule = deep.segment_rule = ThicknessRule::contact_card;
  Penetration edge = deep;
  edge.node = 15;
  edge.element = 0;
  edge.kind = PenetrationKind::edge_zone;
  edge.outcome = Outcome::reported;
  edge.feature = Feature::edge;
  edge.depth = 0.6;
  edge.s = 1;
  edge.original = edge.moved_to = {11, 20, 0.4};
  Penetration moved = deep;
  moved.node = 16;
  moved.part = 0;
  moved.kind = PenetrationKind::initial;
  moved.outcome = Outcome::moved;
  moved.depth = 0.3;
  moved.segment_rule = ThicknessRule::part_contact;
  moved.original = {12, 20, 0.7};
  moved.moved_to = {12, 20, 1.0006};
  moved.line = 0;
  report.penetrations = {deep, edge, moved};
  report.findings.push_back(make_finding("GC501", "duplicate-id", "node 12 is defined again"));
  report.findings[0].file = "mesh.k";
  report.findings[0].line = 40;
  report.findings.push_back(make_finding("GC503", "empty-surface", "SURFB has no segments"));
  report.findings[1].contact = 2;
  return report;
}

/// `count` records with random content in `contacts` contacts, in the order that reports have.
inline Report random_report(std::size_t count, std::uint32_t contacts, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return std::uniform_real_distribution(-1000.0, 1000.0)(random); };
  const auto below = [&](std::uint32_t limit) { return static_cast<std::uint32_t>(random() % limit); };
  Report report;
  report.source = "deck";
  report.input = "random.k";
  report.files = {"a.k", "b.k"};
  for (std::uint32_t i = 0; i < contacts; ++i)
    report.contacts.push_back(make_contact(static_cast<std::int64_t>(i) + 1, i + 1, "CONTACT_X", "13", 1000, 1000));
  report.penetrations.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    Penetration& record = report.penetrations[i];
    record.contact = static_cast<std::uint32_t>(i * contacts / count);
    record.node = 1 + below(10'000'000);
    record.part = below(5);
    record.segment = {1 + below(99999999), 1 + below(99999999), 1 + below(99999999), 1 + below(99999999)};
    record.element = below(10'000'000);
    record.element_part = below(5);
    record.contact_distance = 1 + std::abs(number());
    record.depth = record.contact_distance * 1e-3 * std::abs(number());
    record.s = number() * 1e-3;
    record.t = number() * 1e-3;
    record.original = {number(), number(), number()};
    record.point = {number(), number(), number()};
    record.moved_to = below(2) == 0 ? record.original : Vector{number(), number(), number()};
    record.file = below(2);
    record.line = below(1000);
    record.kind = static_cast<PenetrationKind>(below(penetration_kinds));
    record.outcome = static_cast<Outcome>(below(5));
    record.feature = static_cast<Feature>(below(3));
    record.node_rule = static_cast<ThicknessRule>(below(8));
    record.segment_rule = static_cast<ThicknessRule>(below(8));
  }
  return report;
}

}  // namespace gapcheck::report
