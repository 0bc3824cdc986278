#include "audit/registry.hpp"

#include <algorithm>
#include <cctype>

#include "audit/rule_log.hpp"
#include "audit/run_context.hpp"
#include "audit/run_rules.hpp"
#include "audit/shared_results.hpp"
#include "base/embedded.hpp"
#include "base/nearest_name.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> rule_pages;
}

namespace gapcheck::audit {
namespace {

/// Ascending by id.
std::span<const Rule* const> all_rules() {
  static const std::vector<const Rule*> sorted = [] {
    const auto listed = listed_rules();
    std::vector<const Rule*> list(listed.begin(), listed.end());
    std::sort(list.begin(), list.end(), [](const Rule* a, const Rule* b) { return a->identity.id < b->identity.id; });
    return list;
  }();
  return sorted;
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char l, unsigned char r) { return std::tolower(l) == std::tolower(r); });
}

bool matches(const RuleIdentity& rule, std::string_view pattern) {
  const auto begins = [&](std::string_view text) {
    return text.size() >= pattern.size() && equal_ignoring_case(text.substr(0, pattern.size()), pattern);
  };
  return !pattern.empty() && (begins(rule.id) || begins(rule.name));
}

bool runs_on_decks(const Rule& rule, const AuditOptions& options) {
  return rule.judge == nullptr && rule.review == nullptr && selected(rule.identity, options.select, options.ignore);
}

}  // namespace

std::span<const RuleIdentity> rules() {
  static const std::vector<RuleIdentity> infos = [] {
    std::vector<RuleIdentity> list;
    for (const Rule* rule : all_rules()) list.push_back(rule->identity);
    return list;
  }();
  return infos;
}

const RuleIdentity* find_rule(std::string_view id_or_name) {
  for (const RuleIdentity& rule : rules())
    if (equal_ignoring_case(rule.id, id_or_name) || equal_ignoring_case(rule.name, id_or_name)) return &rule;
  return nullptr;
}

std::span<const Threshold> thresholds(const RuleIdentity& rule) {
  for (const Rule* one : all_rules())
    if (one->identity.id == rule.id) return one->thresholds;
  return {};
}

std::vector<const RuleIdentity*> rules_with(std::string_view text) {
  const auto same = [](unsigned char l, unsigned char r) { return std::tolower(l) == std::tolower(r); };
  std::vector<const RuleIdentity*> list;
  for (const RuleIdentity& rule : rules())
    if (matches(rule, text) || (!text.empty() && std::search(rule.name.begin(), rule.name.end(), text.begin(),
                                                             text.end(), same) != rule.name.end()))
      list.push_back(&rule);
  return list;
}

std::string_view nearest_rule(std::string_view written, bool of_runs) {
  constexpr std::string_view beginning_of_ids = "GC";
  if (equal_ignoring_case(written.substr(0, beginning_of_ids.size()), beginning_of_ids)) return {};
  std::vector<std::string_view> names;
  for (const RuleIdentity& rule : rules())
    if (rule.of_runs() == of_runs && !rule.of_ignores()) names.push_back(rule.name);
  return nearest_name(written, names);
}

bool selected(const RuleIdentity& rule, const std::vector<std::string>& select,
              const std::vector<std::string>& ignore) {
  const auto any = [&](const std::vector<std::string>& patterns) {
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& p) { return matches(rule, p); });
  };
  return (select.empty() || any(select)) && !any(ignore);
}

std::string_view page(const RuleIdentity& rule) {
  for (const auto& text : embedded::rule_pages)
    if (text.name == rule.name) return text.content;
  return {};
}

std::size_t selected_rules(const AuditOptions& options) {
  const auto all = all_rules();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const Rule* rule) { return runs_on_decks(*rule, options); }));
}

bool run_rules(Context& context, AuditSteps& steps, RuleLog& log, Report& report) {
  for (const Rule* rule : all_rules()) {
    if (!runs_on_decks(*rule, context.options())) continue;
    if (!steps.begin(rule->identity.id)) return false;
    const std::uint64_t before = context.results().requests();
    if (rule->run != nullptr) rule->run(rule->identity, context, report);
    log.count_rule(rule->of_records() || context.results().requests() > before);
  }
  return true;
}

void review_ignores(const AuditOptions& options, const IgnoreOutcome& ignores, Report& report) {
  for (const Rule* rule : all_rules())
    if (rule->review != nullptr && selected(rule->identity, options.select, options.ignore))
      rule->review(rule->identity, ignores, report);
}

void run_rules(RunContext& context, Report& report) {
  const JudgeOptions& options = context.options();
  for (const Rule* rule : all_rules())
    if (rule->judge != nullptr && selected(rule->identity, options.select, options.ignore))
      rule->judge(rule->identity, context, report);
}

}  // namespace gapcheck::audit
