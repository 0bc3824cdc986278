#pragma once
#include <cstdint>
#include <gapcheck/report.hpp>
#include <vector>

#include "base/diagnostic.hpp"
#include "records/report.hpp"

namespace gapcheck::api {

/// What Penetrations points into.
struct PenetrationColumns {
  explicit PenetrationColumns(const std::vector<Penetration>& records);
  [[nodiscard]] Penetrations view() const;

  std::vector<PenetrationKind> kind;
  std::vector<std::uint32_t> contact, segment_number, file, line;
  std::vector<std::int64_t> node, part, segment, element, element_part;
  std::vector<double> depth, contact_distance, local, position, closest, moved_to;
  std::vector<Outcome> outcome;
  std::vector<Feature> feature;
  std::vector<ThicknessRule> node_rule, segment_rule;
};

/// What Ties points into.
struct TieColumns {
  explicit TieColumns(const std::vector<TieFailure>& records);
  [[nodiscard]] Ties view() const;

  std::vector<TieReason> reason;
  std::vector<std::uint32_t> contact, segment_number, file, line;
  std::vector<std::int64_t> node, part;
  std::vector<double> distance, allowed, position;
  std::vector<std::uint8_t> by_node_set;
};

struct ReportStore {
  explicit ReportStore(gapcheck::Report from)
      : report(std::move(from)), penetrations(report.penetrations), ties(report.tie_failures) {}

  gapcheck::Report report;
  PenetrationColumns penetrations;
  TieColumns ties;
};

/// The public report of an internal one.
[[nodiscard]] Report report_of(gapcheck::Report report, const gapcheck::Diagnostics& diagnostics);

}  // namespace gapcheck::api
