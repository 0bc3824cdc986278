#include "audit/audit.hpp"

#include <fmt/format.h>

#include <gapcheck/audit.hpp>
#include <utility>

#include "api/convert.hpp"
#include "api/option_check.hpp"
#include "api/report_store.hpp"
#include "audit/registry.hpp"

namespace gapcheck::api {
namespace {

/// The settings refer to the options.
Result<audit::AuditOptions> settings_of(const AuditOptions& options) {
  OptionCheck check;
  check.rules("select", options.select, false);
  check.rules("ignore", options.ignore, false);
  check.amount("ptol", options.ptol);
  check.amount("rtol", options.rtol);
  check.amount("ratio", options.ratio);
  check.amount("millimetre", options.millimetre);
  if (options.millimetre == 0) check.fault("millimetre: 0 is not a length");
  audit::AuditOptions settings;
  for (const auto& [name, severity] : options.severities) {
    const auto* rule = audit::find_rule(name);
    if (rule == nullptr)
      check.fault(fmt::format("severities: '{}' is not a rule", name));
    else
      settings.severities.emplace(rule->id, converted(severity));
  }
  if (!check.message().empty()) return plain_error(check.message());
  settings.read = read_options(options.includes);
  settings.select = options.select;
  settings.ignore = options.ignore;
  settings.contacts = options.contacts;
  settings.parts = options.parts;
  settings.today = options.today;
  settings.ptol = options.ptol.value_or(-1);
  settings.rtol = options.rtol.value_or(-1);
  settings.ratio = options.ratio.value_or(-1);
  settings.millimetre = options.millimetre.value_or(0);
  settings.exact = options.exact;
  settings.scene = options.picture;
  settings.mesh = options.mesh;
  if (options.watch)
    settings.watch = [&options](const audit::AuditStep& step) {
      return options.watch({step.name, step.done, step.all});
    };
  return settings;
}

/// `read`: makes the internal report with these settings.
template <class Read>
Result<Report> audited(const AuditOptions& options, const Read& read) {
  const auto settings = settings_of(options);
  if (!settings) return settings.error();
  const Jobs jobs(options.jobs);
  gapcheck::Diagnostics diagnostics;
  gapcheck::Result<gapcheck::Report> report = read(settings.value(), diagnostics);
  if (!report) return error_of(report.error(), diagnostics);
  OptionCheck check;
  check.contacts(options.contacts, {&report.value()}, "the deck has no such contact");
  check.parts(report.value().unknown_parts);
  if (!check.message().empty()) return Error{"", 0, check.message(), listed(diagnostics)};
  return report_of(std::move(report).value(), diagnostics);
}

}  // namespace

Result<Report> audit_deck(const std::string& path, const AuditOptions& options) {
  return audited(options, [&](const audit::AuditOptions& settings, gapcheck::Diagnostics& diagnostics) {
    return audit::audit_deck(path, settings, diagnostics);
  });
}

Result<Report> audit_text(std::string text, const std::string& name, const AuditOptions& options) {
  return audited(options, [&](const audit::AuditOptions& settings, gapcheck::Diagnostics& diagnostics) {
    return audit::audit_text(std::move(text), name, settings, diagnostics);
  });
}

std::vector<Rule> rules() {
  std::vector<Rule> list;
  for (const auto& rule : audit::rules())
    list.push_back({rule.id, rule.name, converted(rule.severity), rule.summary, audit::page(rule), rule.of_runs()});
  return list;
}

}  // namespace gapcheck::api
