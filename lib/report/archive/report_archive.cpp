#include "report/archive/report_archive.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "report/archive/archive.hpp"

namespace gapcheck::report {

template <>
inline constexpr Feature last_value<Feature> = Feature::corner;
template <>
inline constexpr Outcome last_value<Outcome> = Outcome::reported;
template <>
inline constexpr PenetrationKind last_value<PenetrationKind> = PenetrationKind::edge;
template <>
inline constexpr ThicknessRule last_value<ThicknessRule> = ThicknessRule::beam_section;
template <>
inline constexpr TieReason last_value<TieReason> = TieReason::conflict;
template <>
inline constexpr BaselineState last_value<BaselineState> = BaselineState::unchanged;
template <>
inline constexpr PortabilityKind last_value<PortabilityKind> = PortabilityKind::field;

// Each record names all of its members, so a new one is not forgotten here: it does not compile.

template <class Archive>
void members(Archive& archive, Archived<Archive, Penetration>& record) {
  auto& [contact, segment_number, node, part, segment, element, element_part, depth, contact_distance, s, t, original,
         point, moved_to, file, line, kind, outcome, feature, node_rule, segment_rule] = record;
  archive(contact, segment_number, node, part, segment, element, element_part, depth, contact_distance, s, t, original,
          point, moved_to, file, line, kind, outcome, feature, node_rule, segment_rule);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, TieFailure>& record) {
  auto& [contact, node, part, segment_number, distance, allowed, segment_size, thickness, reason, by_node_set, position,
         file, line] = record;
  archive(contact, node, part, segment_number, distance, allowed, segment_size, thickness, reason, by_node_set,
          position, file, line);
}

/// Without the consequence, which is the rule's, and the nodes and segments that it represents.
template <class Archive>
void members(Archive& archive, Archived<Archive, Finding>& record) {
  auto& [id, rule, severity, message, contact, node, part, element, element_part, penetration, contact_distance, point,
         count, file, line, consequence, key, cause, members_of] = record;
  archive(id, rule, severity, message, contact, node, part, element, element_part, penetration, contact_distance, point,
          count, file, line, key, cause);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, InitialSummary>& record) {
  auto& [messages, nodes, eliminated, least, greatest] = record;
  archive(messages, nodes, eliminated, least, greatest);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, ContactSummary>& record) {
  auto& [id, order, title, keyword, type, tracked_nodes, segments, penetrations, released, edge_zone, max_penetration,
         segment_penetrations, mortar_penetrations, edge_penetrations, ties, untied, out_of_reach, nodes_out_of_reach,
         reported_penetrations, initial_summary, contact_time_s, not_checked, judged_nearest, ties_judged, by_segments,
         file, line] = record;
  archive(id, order, title, keyword, type, tracked_nodes, segments, penetrations, released, edge_zone, max_penetration,
          segment_penetrations, mortar_penetrations, edge_penetrations, ties, untied, out_of_reach, nodes_out_of_reach,
          reported_penetrations, initial_summary, contact_time_s, not_checked, judged_nearest, ties_judged, by_segments,
          file, line);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, ModelCounts>& record) {
  auto& [nodes, shells, solids, beams, thick_shells, discrete, masses, particles, parts, contacts] = record;
  archive(nodes, shells, solids, beams, thick_shells, discrete, masses, particles, parts, contacts);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, IgnoreSource>& record) {
  auto& [file, line, reason, in_deck, matched] = record;
  archive(file, line, reason, in_deck, matched);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, Ignored>& record) {
  auto& [penetrations, tie_failures, findings, source, sources] = record;
  archive(penetrations, tie_failures, findings, source, sources);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, KnownFinding>& record) {
  auto& [id, rule, severity, contact, position, penetration, contact_distance, segment_size, count, message] = record;
  archive(id, rule, severity, contact, position, penetration, contact_distance, segment_size, count, message);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, BaselineComparison>& record) {
  auto& [states, ignored_states, gone] = record;
  archive(states, ignored_states, gone);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, PortabilityNote>& record) {
  auto& [program, kind, other_meaning, name, count, file, line, source] = record;
  archive(program, kind, other_meaning, name, count, file, line, source);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, Portability>& record) {
  auto& [programs, notes] = record;
  archive(programs, notes);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, SurfaceTimestep>& record) {
  auto& [contact, side, type, timestep, node, part] = record;
  archive(contact, side, type, timestep, node, part);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, Timesteps>& record) {
  auto& [contact_timestep, element_timestep, surface_timesteps] = record;
  archive(contact_timestep, element_timestep, surface_timesteps);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, Timing>& record) {
  auto& [read_s, model_s, surface_s, search_s, total_s] = record;
  archive(read_s, model_s, surface_s, search_s, total_s);
}

/// Without what audits do not have, and what only files of a single deck show.
template <class Archive>
void members(Archive& archive, Archived<Archive, Report>& record) {
  auto& [source, input, as_if, unknown_parts, settings, page, severities, files, model, contacts, penetrations,
         tie_failures, findings, ignored, baseline, run, portability, predicted, statistics, timing, scene, moves,
         said_of_moves, mesh, highest_set] = record;
  archive(source, input, as_if, unknown_parts, settings, page, severities, files, model, contacts, penetrations,
          tie_failures, findings, ignored, baseline, portability, predicted, statistics, timing, highest_set);
}

namespace {

/// Positions that writers look up without a question.
bool positions_hold(const Report& r) {
  const auto record = [&](const auto& each) {
    return each.contact < r.contacts.size() && (each.file < r.files.size() || r.files.empty());
  };
  const auto all = [](const auto& list, const auto& holds) { return std::all_of(list.begin(), list.end(), holds); };
  const Ignored& i = r.ignored;
  if (!all(r.penetrations, record) || !all(r.tie_failures, record)) return false;
  if (!all(i.penetrations, record) || !all(i.tie_failures, record)) return false;
  if (i.source.size() != i.penetrations.size() + i.tie_failures.size() + i.findings.size()) return false;
  if (!all(i.source, [&](std::uint32_t source) { return source < i.sources.size(); })) return false;
  if (r.predicted &&
      !all(r.predicted->surface_timesteps, [&](const auto& each) { return each.contact < r.contacts.size(); }))
    return false;
  return !r.baseline ||
         (r.baseline->states.size() == r.penetrations.size() + r.tie_failures.size() + r.findings.size() &&
          r.baseline->ignored_states.size() == i.size());
}

}  // namespace

std::string archived(const Report& report) {
  ArchiveWriter writer;
  writer(report);
  return writer.take();
}

Result<Report> unarchived(std::string_view bytes, const ConsequenceOf& consequence_of) {
  ArchiveReader reader(bytes);
  Report report;
  reader(report);
  if (!reader.complete() || !positions_hold(report)) return plain_error("is not a stored report");
  for (std::vector<Finding>* findings : {&report.findings, &report.ignored.findings})
    for (Finding& finding : *findings) finding.consequence = consequence_of(finding.id);
  return report;
}

}  // namespace gapcheck::report
