#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/selection.hpp"
#include "audit/threshold.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/report.hpp"
#include "records/rule_identity.hpp"

namespace gapcheck::contact {
struct ContactSurfaces;
}  // namespace gapcheck::contact

namespace gapcheck::audit {

class RuleLog;
class RunContext;
class SharedResults;

/// What a rule on decks works with: the deck, the selected contacts and parts, and results that all rules share.
class Context {
 public:
  /// All of them must outlive it.
  Context(const keyword::Deck& deck, const Selection& selection, SharedResults& results, RuleLog& log)
      : deck_(deck), selection_(selection), results_(results), log_(log) {}

  [[nodiscard]] const keyword::Deck& deck() const { return deck_; }
  [[nodiscard]] const model::Model& model() const { return selection_.model(); }
  [[nodiscard]] const AuditOptions& options() const { return selection_.options(); }
  /// Path of an include; empty for none.
  [[nodiscard]] const std::string& path(FileIndex file) const;
  /// The contacts that --contact lets through, ascending.
  [[nodiscard]] const std::vector<ContactIndex>& contacts() const { return selection_.contacts(); }
  /// Those of contacts() that have the cards of a 3D contact, at least card 1.
  [[nodiscard]] const std::vector<ContactIndex>& read_contacts() const { return selection_.read_contacts(); }
  /// True if --part lets the part through.
  [[nodiscard]] bool part_chosen(PartIndex part) const { return selection_.part_chosen(part); }
  /// The surfaces of a contact on the deck's coordinates; kept once built.
  [[nodiscard]] const contact::ContactSurfaces& surfaces(ContactIndex contact);
  /// Initialisation, mesh in contact, time steps (audit/shared_results.hpp).
  [[nodiscard]] SharedResults& results() { return results_; }
  /// The value of a threshold of a rule: that of the settings, or its own.
  [[nodiscard]] double threshold(const RuleIdentity& rule, const Threshold& threshold) const;
  /// Records for --stats what a rule left out and why: "3 contacts have no surfaces to compare".
  void skipped(const RuleIdentity& rule, std::string_view what);

 private:
  const keyword::Deck& deck_;
  const Selection& selection_;
  SharedResults& results_;
  RuleLog& log_;
};

/// One rule: its identity, and what it adds to a report. A rule has one of the functions, depending on whether it
/// judges decks, runs or ignores; a rule whose findings are records has none, because the audit reports these itself.
struct Rule {
  RuleIdentity identity;
  void (*run)(const RuleIdentity& rule, Context& context, Report& report) = nullptr;
  void (*judge)(const RuleIdentity& rule, RunContext& context, Report& report) = nullptr;
  /// Judges what happened to the findings of all other rules.
  void (*review)(const RuleIdentity& rule, const IgnoreOutcome& ignores, Report& report) = nullptr;
  std::span<const Threshold> thresholds = {};
  [[nodiscard]] bool of_records() const { return run == nullptr && judge == nullptr && review == nullptr; }
};

/// A finding with the rule's id, name and severity filled in.
[[nodiscard]] Finding finding(const RuleIdentity& rule, std::string message, std::string file, std::uint32_t line);

/// A finding at a contact's keyword.
[[nodiscard]] Finding finding_at(const RuleIdentity& rule, const Context& context, const model::Contact& contact,
                                 std::string message);

/// Adds the faults of one kind, the first ten of each kind of thing in full and then one finding that counts the rest.
void add_faults(const RuleIdentity& rule, Context& context, Report& report, model::Fault::Kind kind);

}  // namespace gapcheck::audit
