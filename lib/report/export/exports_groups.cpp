#include "report/export/exports_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/quad.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t longest_group_title = 70;

/// Position of a warning type among those of one contact.
using TypeOrder = int;

struct WarningType {
  TypeOrder order;
  std::string_view name;
};

WarningType type_of(const Penetration& record) {
  switch (record.kind) {
    case PenetrationKind::initial:
      return {0, "pen"};
    case PenetrationKind::released:
      return {1, "below"};
    case PenetrationKind::edge_zone:
      return {2, "edge"};
    case PenetrationKind::segment:
      return {3, "soft2"};
    case PenetrationKind::mortar:
      return {4, "mortar"};
    case PenetrationKind::edge:
      return {5, "edges"};
  }
  return {0, "pen"};
}

WarningType type_of(const TieFailure& failure) { return {6 + static_cast<int>(failure.reason), name(failure.reason)}; }

ExportGroup make_group(const Report& report, std::uint32_t contact, std::string_view type) {
  ExportGroup group;
  if (contact >= report.contacts.size()) {
    group.name = group.title = fmt::format("id0 {}", type);
    return group;
  }
  const ContactSummary& summary = report.contacts[contact];
  group.name = fmt::format("id{} {}", summary.id, type);
  const std::string& speaking = summary.title.empty() ? summary.keyword : summary.title;
  group.title = group.name;
  if (speaking.empty()) return group;
  group.title = beginning(fmt::format("{}: {}", group.name, printable(speaking)), longest_group_title);
  return group;
}

std::optional<Vector> unit(const Vector& v) {
  const double length = v.stableNorm();
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return v / length;
}

/// True if a record without any coordinate means that its source has none.
bool without_coordinates(const Report& report, const Penetration& record) {
  return report.source != "deck" && record.original.isZero(0) && record.point.isZero(0) && record.moved_to.isZero(0);
}

/// The nodes of the segment, if all are known.
std::optional<std::array<Vector, 4>> segment_of(const Penetration& record, const NodePosition& position) {
  if (!position) return std::nullopt;
  std::array<Vector, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto corner = position(record.segment[i]);
    if (!corner || !corner->allFinite()) return std::nullopt;
    corners[i] = *corner;
  }
  return corners;
}

/// Towards the contact surface, from what is known about the segment.
std::optional<Vector> out_of_segment(const Report& report, const Penetration& record, const Vector& node,
                                     const NodePosition& position) {
  const bool exact = report.source == "deck";
  const auto corners = segment_of(record, position);
  // Solver files do not print the closest point, but where on the segment it is.
  const bool point_known = exact || (!record.point.isZero(0) && record.point != record.original);
  if (!point_known && !(corners && std::isfinite(record.s) && std::isfinite(record.t))) return std::nullopt;
  const Vector point = point_known ? record.point : quad_point(*corners, record.s, record.t);
  // Below the resolution of the digits the difference gives no direction.
  const double digits = point_known ? 1e-12 : 1e-4;
  const Vector away = node - point;
  if (away.stableNorm() > digits * (node.cwiseAbs().maxCoeff() + point.cwiseAbs().maxCoeff())) {
    const bool behind = (exact || record.contact_distance > 0) && record.remaining() < 0;
    return unit(behind ? Vector(-away) : away);
  }
  if (!corners) return std::nullopt;
  return unit(quad_normal(*corners));
}

std::optional<Vector> direction_of(const Report& report, const Penetration& record, const Vector& node,
                                   const NodePosition& position) {
  if (!without_coordinates(report, record))
    if (auto moved = unit(record.moved_to - record.original)) return moved;
  return out_of_segment(report, record, node, position);
}

}  // namespace

std::vector<ExportGroup> export_groups(const Report& report) {
  std::map<std::pair<std::uint32_t, TypeOrder>, ExportGroup> groups;
  const auto group_of = [&](const auto& record) -> ExportGroup& {
    const WarningType type = type_of(record);
    const auto [entry, is_new] = groups.try_emplace({record.contact, type.order});
    if (is_new) entry->second = make_group(report, record.contact, type.name);
    return entry->second;
  };
  for (const Penetration& record : report.penetrations) {
    ExportGroup& group = group_of(record);
    group.penetrations.push_back(&record);
    group.nodes.push_back(record.node);
  }
  for (const TieFailure& failure : report.tie_failures) group_of(failure).nodes.push_back(failure.node);
  std::vector<ExportGroup> result;
  result.reserve(groups.size());
  for (auto& [key, group] : groups) {
    std::sort(group.nodes.begin(), group.nodes.end());
    group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
    result.push_back(std::move(group));
  }
  return result;
}

std::optional<Vector> node_of(const Report& report, const Penetration& record, const NodePosition& position) {
  if (!without_coordinates(report, record)) return record.original;
  return position ? position(record.node) : std::nullopt;
}

std::optional<PenetrationLine> penetration_line(const Report& report, const Penetration& record,
                                                const NodePosition& position) {
  const auto node = node_of(report, record, position);
  if (!node || !node->allFinite() || !(record.depth > 0) || !std::isfinite(record.depth)) return std::nullopt;
  const auto direction = direction_of(report, record, *node, position);
  if (!direction || !direction->allFinite()) return std::nullopt;
  return PenetrationLine{*node, *node + record.depth * *direction};
}

std::int64_t first_free_id(const Report& report) {
  constexpr std::int64_t most = 999'999'999'999'999'999;
  std::int64_t highest = 0;
  const auto count = [&](std::int64_t id) {
    if (id <= most) highest = std::max(highest, id);
  };
  for (const ContactSummary& contact : report.contacts) count(contact.id);
  for (const Penetration& record : report.penetrations) {
    for (const std::int64_t id : {record.node, record.part, record.element, record.element_part}) count(id);
    for (const std::int64_t id : record.segment) count(id);
  }
  for (const TieFailure& failure : report.tie_failures) {
    count(failure.node);
    count(failure.part);
  }
  return highest + 1;
}

}  // namespace gapcheck::report
