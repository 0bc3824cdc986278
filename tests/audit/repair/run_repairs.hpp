#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "audit/repair/repair_plan.hpp"
#include "audit/run.hpp"
#include "keyword/deck.hpp"

namespace gapcheck::audit_test {

/// Repairs of a deck of one text.
class RepairRun {
 public:
  explicit RepairRun(std::string text) : text_(std::move(text)) {}

  [[nodiscard]] RepairPlan plan(const audit::FixOptions& options = {}, audit::Tried tried = audit::Tried::all) {
    Diagnostics diagnostics;
    const auto deck = read({}, diagnostics);
    EXPECT_TRUE(deck.ok());
    auto plan = audit::plan_repairs(deck.value(), options, reread(), diagnostics, tried);
    EXPECT_TRUE(plan.ok()) << (plan ? "" : plan.error().message);
    return plan ? std::move(plan).value() : RepairPlan{};
  }

  /// Listed without being tried.
  [[nodiscard]] RepairPlan listed() {
    Diagnostics diagnostics;
    const auto deck = read({}, diagnostics);
    auto plan = audit::list_written_repairs(deck.value(), diagnostics);
    EXPECT_TRUE(plan.ok()) << (plan ? "" : plan.error().message);
    return plan ? std::move(plan).value() : RepairPlan{};
  }

  [[nodiscard]] Result<audit::Repaired> apply(const std::vector<std::string>& ids) {
    Diagnostics diagnostics;
    const auto deck = read({}, diagnostics);
    return audit::apply_repairs(deck.value(), ids, {}, reread(), diagnostics);
  }

  /// The deck's text with repairs.
  [[nodiscard]] std::string text(const std::vector<std::string>& ids) {
    auto repaired = apply(ids);
    EXPECT_TRUE(repaired.ok()) << (repaired ? "" : repaired.error().message);
    if (!repaired) return "";
    const auto changed = repaired.value().texts.find("deck.k");
    return changed == repaired.value().texts.end() ? text_ : changed->second;
  }

 private:
  [[nodiscard]] Result<keyword::Deck> read(const std::map<std::string, std::string>& texts, Diagnostics& diagnostics) {
    const auto changed = texts.find("deck.k");
    return keyword::read_deck_text(changed == texts.end() ? text_ : changed->second, "deck.k", {}, diagnostics);
  }
  [[nodiscard]] audit::Reread reread() {
    return [this](const auto& texts, Diagnostics& diagnostics) { return read(texts, diagnostics); };
  }

  std::string text_;
};

/// The repair of a kind; one without id if the pair has none.
[[nodiscard]] inline Repair repair_of(const RepairPair& pair, RepairKind kind) {
  for (const Repair& repair : pair.repairs)
    if (repair.kind == kind) return repair;
  return {};
}

/// Penetrations (GC101, GC102) that the audit finds in a text; those that stay without force only if `all`.
[[nodiscard]] inline std::size_t penetrations_of(const std::string& text, bool all = true) {
  audit::AuditOptions options;
  options.select = {"GC101", "GC102"};
  std::size_t count = 0;
  for (const Penetration& p : run_text(text, options).report.penetrations)
    count += all || p.outcome != Outcome::kept ? 1 : 0;
  return count;
}

/// Those of two parts that are moved, pushed or released.
[[nodiscard]] inline std::size_t penetrations_of(const std::string& text, const RepairParts& parts) {
  audit::AuditOptions options;
  options.select = {"GC101", "GC102"};
  const AuditRun run = run_text(text, options);
  std::size_t count = 0;
  for (const Penetration& p : run.report.penetrations)
    count += p.outcome != Outcome::kept && run.report.contacts[p.contact].id == parts.contact &&
                     std::minmax(p.part, p.element_part) == std::minmax(parts.a, parts.b)
                 ? 1
                 : 0;
  return count;
}

}  // namespace gapcheck::audit_test
