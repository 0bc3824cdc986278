#include "audit/rule.hpp"

#include <fmt/format.h>

#include <map>

#include "audit/rule_log.hpp"
#include "audit/shared_results.hpp"

namespace gapcheck::audit {
namespace {

constexpr std::size_t in_full = 10;

/// "node 12 is defined again" → "node": faults about the same kind of thing are grouped.
std::string thing(const std::string& message) { return message.substr(0, message.find(' ')); }

}  // namespace

const std::string& Context::path(FileIndex file) const {
  static const std::string empty;
  return file.value < deck_.files().size() ? deck_.file(file).path : empty;
}

const contact::ContactSurfaces& Context::surfaces(ContactIndex contact) { return results_.surfaces(contact); }

double Context::threshold(const RuleIdentity& rule, const Threshold& threshold) const {
  const auto found = options().thresholds.find(fmt::format("{}.{}", rule.id, threshold.name));
  return found == options().thresholds.end() ? threshold.value : found->second;
}

void Context::skipped(const RuleIdentity& rule, std::string_view what) { log_.skipped(rule, what); }

Finding finding(const RuleIdentity& rule, std::string message, std::string file, std::uint32_t line) {
  Finding f;
  f.id = rule.id;
  f.rule = rule.name;
  f.severity = rule.severity;
  f.message = std::move(message);
  f.file = std::move(file);
  f.line = line;
  f.consequence = rule.consequence;
  return f;
}

Finding finding_at(const RuleIdentity& rule, const Context& context, const model::Contact& contact,
                   std::string message) {
  Finding f = finding(rule, std::move(message), context.path(contact.place.file), contact.place.line);
  f.contact = contact.id.value;
  return f;
}

void add_faults(const RuleIdentity& rule, Context& context, Report& report, model::Fault::Kind kind) {
  std::map<std::string, std::size_t> count;
  for (const model::Fault& fault : context.model().faults) {
    if (fault.kind != kind) continue;
    if (++count[thing(fault.message)] <= in_full)
      report.findings.push_back(finding(rule, fault.message, context.path(fault.place.file), fault.place.line));
  }
  for (const auto& [what, n] : count) {
    if (n <= in_full) continue;
    report.findings.push_back(
        finding(rule, fmt::format("{}: {} more findings of this kind", what, n - in_full), "", 0));
    report.findings.back().count = n - in_full;
  }
}

}  // namespace gapcheck::audit
