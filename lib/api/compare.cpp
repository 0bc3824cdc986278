#include "report/compare/compare.hpp"

#include <algorithm>
#include <filesystem>
#include <gapcheck/compare.hpp>
#include <system_error>
#include <utility>

#include "api/convert.hpp"
#include "api/option_check.hpp"
#include "api/report_store.hpp"
#include "api/watched.hpp"
#include "audit/audit.hpp"
#include "report/compare/compare_curves.hpp"
#include "report/text/check_c_view.hpp"
#include "results/log/input_kind.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::api {

struct ComparisonStore {
  report::Comparison comparison;
  std::optional<report::CurveComparison> curves;
  std::optional<report::MotionComparison> motion;
  std::shared_ptr<const ReportStore> first, second;
};

namespace {

/// One side of a comparison.
struct Side {
  Report report;
  std::vector<report::Curve> curves;
};

/// A deck is audited, everything else read.
gapcheck::Result<gapcheck::Report> records_of(const std::string& path, const CompareOptions& options,
                                              gapcheck::Diagnostics& diagnostics) {
  const auto source = results::recognise(path);
  if (!source) return source.error();
  if (source.value().deck) {
    audit::AuditOptions settings;
    settings.read = read_options(options.includes);
    settings.watch = [](const audit::AuditStep&) { return !work_stopped(); };
    return audit::audit_deck(path, settings, diagnostics);
  }
  results::LogOptions settings;
  settings.message_files = options.message_tables;
  return results::read_solver_logs(source.value().files, settings, diagnostics);
}

std::vector<report::Curve> curves_of(const std::string& directory, const std::vector<std::int64_t>& contacts,
                                     gapcheck::Diagnostics& diagnostics) {
  std::vector<report::Curve> list = report::curves(results::read_run_results(directory, true, diagnostics));
  if (contacts.empty()) return list;
  std::erase_if(list, [&](const report::Curve& curve) {
    return curve.contact != 0 && std::find(contacts.begin(), contacts.end(), curve.contact) == contacts.end();
  });
  return list;
}

/// `earlier`: what is already known of it.
Result<Side> side_of(const std::string& path, const CompareOptions& options, bool with_curves,
                     const gapcheck::Diagnostics& earlier = {}) {
  gapcheck::Diagnostics diagnostics;
  diagnostics.take(earlier);
  auto records = records_of(path, options, diagnostics);
  if (!records) return error_of(records.error(), diagnostics);
  report::CheckCOptions only;
  only.sid = options.contacts;
  gapcheck::Report picked = report::pick(std::move(records).value(), only);
  picked.input = path;
  Side side;
  if (with_curves) side.curves = curves_of(path, options.contacts, diagnostics);
  side.report = report_of(std::move(picked), diagnostics);
  return side;
}

std::optional<double> depth_of(double value) { return value < 0 ? std::nullopt : std::optional<double>(value); }

std::optional<TieReason> reason_of(const std::optional<gapcheck::TieReason>& reason) {
  // The two lists are the same; see columns.cpp.
  return reason ? std::optional<TieReason>(static_cast<TieReason>(*reason)) : std::nullopt;
}

ContactComparison public_contact(const report::ContactComparison& from) {
  ContactComparison contact;
  contact.id = from.id;
  contact.title = from.title;
  contact.type = from.type;
  contact.agree = from.agree;
  contact.depth_differs = from.depth_differs;
  contact.only_first = from.only_first;
  contact.only_second = from.only_second;
  contact.largest_difference = from.largest_difference;
  contact.missing_in_first = from.missing_in_first;
  contact.missing_in_second = from.missing_in_second;
  contact.not_checked = from.not_checked;
  contact.counts_only = from.counts_only;
  contact.ties_compared = from.ties_compared;
  contact.ties_agree = from.ties_agree;
  contact.ties_other_reason = from.ties_other_reason;
  contact.ties_only_first = from.ties_only_first;
  contact.ties_only_second = from.ties_only_second;
  return contact;
}

CurvePair::Verdict verdict_of(report::CurvePair::Verdict from) {
  switch (from) {
    case report::CurvePair::Verdict::agrees:
      return CurvePair::Verdict::agrees;
    case report::CurvePair::Verdict::differs:
      return CurvePair::Verdict::differs;
    case report::CurvePair::Verdict::no_common_times:
      break;
  }
  return CurvePair::Verdict::no_common_times;
}

std::optional<CurveRating> public_rating(const std::optional<report::Rating>& from) {
  if (!from) return std::nullopt;
  return CurveRating{from->overall(), from->corridor, from->phase, from->magnitude, from->slope};
}

MotionComparison public_motion(const report::MotionComparison& from) {
  MotionComparison motion{from.times, from.largest_displacement, {}, from.differ};
  for (const report::PartMotion& part : from.parts)
    motion.parts.push_back(
        {part.part, part.nodes, part.largest_distance, part.time, part.node, part.largest, part.mean, part.differs});
  return motion;
}

CurveComparison public_curves(const report::CurveComparison& from) {
  CurveComparison curves;
  for (const report::CurvePair& pair : from.pairs)
    curves.pairs.push_back({pair.name, verdict_of(pair.verdict), pair.largest_first, pair.largest_second,
                            pair.largest_difference, pair.time, pair.relative_difference, pair.l2_difference,
                            public_rating(pair.rating)});
  curves.only_first = from.only_first;
  curves.only_second = from.only_second;
  curves.agree = from.agree;
  curves.differ = from.differ;
  curves.without_common_times = from.without_common_times;
  return curves;
}

std::string fault_of(const CompareOptions& options) {
  OptionCheck check;
  check.amount("tolerance", options.tolerance);
  check.amount("curve_tolerance", options.curve_tolerance);
  return check.message();
}

/// Of two directories with at least one curve.
std::optional<report::CurveComparison> compared_curves(const Side& first, const Side& second,
                                                       const CompareOptions& options) {
  if (first.curves.empty() && second.curves.empty()) return std::nullopt;
  report::CurveOptions settings;
  settings.tolerance = options.curve_tolerance;
  settings.names = options.curve_names;
  return report::compare_curves(first.curves, second.curves, settings);
}

/// What the options name and neither source has.
std::string missing_in_both(const Side& first, const Side& second, const CompareOptions& options,
                            const std::optional<report::CurveComparison>& curves) {
  OptionCheck check;
  check.contacts(options.contacts, {&first.report.store->report, &second.report.store->report},
                 "neither source has such a contact");
  if (!options.curve_names.empty() && (!curves || curves->pairs.empty()))
    check.fault("curve_names: there are no such curves that both sources have");
  return check.message();
}

report::RunComparison runs_in(const ComparisonStore& store) {
  return {store.curves ? &*store.curves : nullptr, store.motion ? &*store.motion : nullptr};
}

Comparison public_comparison(Side first, Side second, std::shared_ptr<const ComparisonStore> store) {
  const report::Comparison& from = store->comparison;
  Comparison result;
  for (const report::ContactComparison& contact : from.contacts) result.contacts.push_back(public_contact(contact));
  for (const report::Difference& each : from.differences)
    result.differences.push_back({each.contact, each.node, depth_of(each.first), depth_of(each.second)});
  for (const report::TieDifference& each : from.tie_differences)
    result.tie_differences.push_back({each.contact, each.node, reason_of(each.first), reason_of(each.second)});
  if (store->curves) result.curves = public_curves(*store->curves);
  if (store->motion) result.motion = public_motion(*store->motion);
  result.equal = from.equal() && runs_in(*store).equal();
  result.complete = first.report.complete && second.report.complete;
  result.first = std::move(first.report);
  result.second = std::move(second.report);
  result.store = std::move(store);
  return result;
}

/// What an empty comparison compares.
const ComparisonStore& store_of(const Comparison& comparison) {
  static const ComparisonStore none{{},
                                    {},
                                    {},
                                    std::make_shared<const ReportStore>(gapcheck::Report{}),
                                    std::make_shared<const ReportStore>(gapcheck::Report{})};
  return comparison.store ? *comparison.store : none;
}

Result<Comparison> compared(const std::string& first, const std::string& second, const CompareOptions& options) {
  std::error_code failed;
  const bool with_curves =
      options.curves && std::filesystem::is_directory(first, failed) && std::filesystem::is_directory(second, failed);
  auto a = side_of(first, options, with_curves);
  if (!a) return a.error();
  ComparisonStore store;
  gapcheck::Diagnostics diagnostics;
  if (with_curves && options.curve_names.empty())
    store.motion = report::compare_motion(first, second, options.curve_tolerance, diagnostics);
  auto b = side_of(second, options, with_curves, diagnostics);
  if (!b) return b.error();
  Side &one = a.value(), &other = b.value();
  store.first = one.report.store;
  store.second = other.report.store;
  store.curves = compared_curves(one, other, options);
  if (std::string fault = missing_in_both(one, other, options, store.curves); !fault.empty())
    return plain_error(std::move(fault));
  store.comparison = report::compare(store.first->report, store.second->report, options.tolerance);
  return public_comparison(std::move(one), std::move(other), std::make_shared<const ComparisonStore>(std::move(store)));
}

}  // namespace

Result<Comparison> compare(const std::string& first, const std::string& second, const CompareOptions& options) {
  if (std::string fault = fault_of(options); !fault.empty()) return plain_error(std::move(fault));
  const Jobs jobs(options.jobs);
  return watched(options.watch, "the comparison was stopped", [&] { return compared(first, second, options); });
}

std::string text(const Comparison& comparison, std::size_t top) {
  const ComparisonStore& store = store_of(comparison);
  return report::comparison_text(store.comparison, store.first->report, store.second->report, top, runs_in(store));
}

std::string json(const Comparison& comparison) {
  const ComparisonStore& store = store_of(comparison);
  return report::comparison_json(store.comparison, store.first->report, store.second->report, runs_in(store));
}

}  // namespace gapcheck::api
