#pragma once
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

#include "audit/audit.hpp"
#include "audit/registry.hpp"
#include "contact/surface/contact_mesh.hpp"
#include "contact/stiffness/contact_timestep.hpp"
#include "contact/crossing/crossings.hpp"
#include "contact/initial.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// What the rules of one audit share. Shared data is computed when the first rule asks for it.
class Context {
 public:
  Context(const keyword::Deck& deck, const model::Model& model, const AuditOptions& options)
      : deck_(deck), model_(model), options_(options), surfaces_(model) {}

  [[nodiscard]] const model::Model& model() const { return model_; }
  [[nodiscard]] const AuditOptions& options() const { return options_; }
  /// Path of an include; empty for none.
  [[nodiscard]] const std::string& path(FileIndex file) const;
  /// Positions in Model::contacts that --contact lets through, ascending.
  [[nodiscard]] std::vector<std::uint32_t> contacts() const;
  /// Those of contacts() that have the cards of a 3D contact, card 1 at least.
  [[nodiscard]] std::vector<std::uint32_t> read_contacts() const;
  /// True if --part lets the part through.
  [[nodiscard]] bool part_chosen(PartIndex part) const;
  /// The surfaces of a contact (position in Model::contacts) on the deck's coordinates; kept once built.
  [[nodiscard]] const contact::ContactSurfaces& surfaces(std::uint32_t contact) { return surfaces_.at(contact); }
  [[nodiscard]] contact::SurfaceStore& surface_store() { return surfaces_; }
  /// The segments of the chosen contacts, each once; made when first asked for.
  [[nodiscard]] contact::ContactMesh& contact_mesh();
  /// How often rules asked for derived data: surfaces, searches, time steps.
  [[nodiscard]] std::uint64_t requests() const { return requests_ + surfaces_.asked(); }
  [[nodiscard]] const keyword::Deck& deck() const { return deck_; }
  /// Records for --stats what a rule left out and why: "GC103: 3 contacts have no surfaces to compare".
  void skipped(const RuleInfo& rule, std::string what);
  [[nodiscard]] const std::vector<std::string>& skips() const { return skips_; }
  /// The initialisation of all contacts.
  [[nodiscard]] contact::InitialState& initial();
  /// The initialisation of some of the contacts (positions) and of all ties on other surfaces; penetrating nodes are
  /// not moved. Costs as much as the contacts' share of initial().
  [[nodiscard]] contact::InitialState initial_if(contact::SurfaceStore& surfaces,
                                                 const std::vector<std::uint32_t>& contacts);
  /// Time steps of the contacts that --contact lets through, and of the elements.
  [[nodiscard]] const contact::PredictedTimesteps& timesteps();
  [[nodiscard]] const contact::InitialCounters& counters() const { return counters_; }
  /// Counts the surfaces of a store that a rule made for initial_if().
  void count_other(const contact::SurfaceStore& surfaces) { other_surfaces_ += surfaces.built(); }
  /// Surfaces with another thickness than the deck's, and what initial_if() did with them.
  [[nodiscard]] std::uint64_t other_surfaces() const { return other_surfaces_ + other_counters_.surfaces_built; }
  [[nodiscard]] const contact::InitialCounters& other_counters() const { return other_counters_; }
  /// Counts a rule that has run, and whether it asked for anything.
  void count_rule(bool asked) { ++(asked ? rules_.asking : rules_.content); }
  struct RuleCounters {
    std::uint64_t asking = 0;   ///< for surfaces, a search, time steps
    std::uint64_t content = 0;  ///< with the model as it was read
  };
  [[nodiscard]] const RuleCounters& rule_counters() const { return rules_; }
  /// How the rules about crossing elements decided; printed by --stats.
  [[nodiscard]] contact::CrossingCounters& crossing_counters() { return crossing_counters_; }
  [[nodiscard]] bool initialised() const { return initial_.has_value(); }
  /// The result of the ignores; for Rule::review.
  [[nodiscard]] const IgnoreOutcome& ignores() const { return ignores_; }
  void set_ignores(IgnoreOutcome outcome) { ignores_ = std::move(outcome); }
  /// Asks for the records of one kind in the report.
  void want(PenetrationKind kind) {
    ++requests_;
    wanted_.set(static_cast<std::size_t>(kind));
  }
  /// Asks for the records of tied contacts with one reason.
  void want(TieReason reason) {
    ++requests_;
    wanted_ties_.set(static_cast<std::size_t>(reason));
  }
  [[nodiscard]] bool wanted(TieReason reason) const { return wanted_ties_.test(static_cast<std::size_t>(reason)); }
  /// True if some selected rule so far needs the search.
  [[nodiscard]] bool search_wanted() const { return wanted_.any() || wanted_ties_.any(); }
  [[nodiscard]] bool wanted(PenetrationKind kind) const { return wanted_.test(static_cast<std::size_t>(kind)); }

 private:
  [[nodiscard]] contact::InitialOptions initial_options() const;
  const keyword::Deck& deck_;
  const model::Model& model_;
  const AuditOptions& options_;
  contact::SurfaceStore surfaces_;
  std::optional<contact::ContactMesh> contact_mesh_;
  std::vector<std::string> skips_;
  std::optional<contact::InitialState> initial_;
  std::optional<contact::PredictedTimesteps> timesteps_;
  contact::InitialCounters counters_, other_counters_;
  std::uint64_t requests_ = 0, other_surfaces_ = 0;
  RuleCounters rules_;
  IgnoreOutcome ignores_;
  contact::CrossingCounters crossing_counters_;
  std::bitset<penetration_kinds> wanted_;
  std::bitset<8> wanted_ties_;
};

class RunContext;

/// One rule: what it is, and what it adds to a report. A rule looks at decks or at runs.
struct Rule {
  RuleInfo info;
  void (*run)(const RuleInfo& info, Context& context, Report& report) = nullptr;
  void (*judge)(const RuleInfo& info, RunContext& context, Report& report) = nullptr;
  /// Instead of `run`: judges what happened to the findings of all other rules.
  void (*review)(const RuleInfo& info, const Context& context, Report& report) = nullptr;
};

/// A finding with the rule's id, name and severity filled in.
[[nodiscard]] Finding finding(const RuleInfo& rule, std::string message, std::string file, std::uint32_t line);

/// A finding at a contact's keyword.
[[nodiscard]] Finding finding_at(const RuleInfo& rule, const Context& context, const model::Contact& contact,
                                 std::string message);

/// Adds the faults of one kind, the first ten of each kind of thing in full and then one finding that counts the rest.
void add_faults(const RuleInfo& rule, Context& context, Report& report, model::Fault::Kind kind);

}  // namespace gapcheck::audit
