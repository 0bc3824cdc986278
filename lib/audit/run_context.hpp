#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "audit/judge.hpp"
#include "audit/rule.hpp"

namespace gapcheck::audit {

/// The reference for an energy.
struct ReferenceEnergy {
  double value = 0;         ///< 0: there is none
  bool of_elements = true;  ///< the internal energy; false: the total one, since the elements hardly deform
  [[nodiscard]] std::string_view words() const {
    return of_elements ? "the peak internal energy" : "the peak total energy";
  }
};

/// What the rules on one run share.
class RunContext {
 public:
  /// Everything must outlive the context.
  RunContext(const results::RunResults& files, const SolverRun& log, const std::vector<ContactSummary>& contacts,
             const JudgeOptions& options);

  [[nodiscard]] const results::RunResults& files() const { return files_; }
  [[nodiscard]] const SolverRun& log() const { return log_; }
  [[nodiscard]] const JudgeOptions& options() const { return options_; }
  /// What the log says about a contact; nullptr: nothing.
  [[nodiscard]] const ContactSummary* contact(std::int64_t id) const;
  /// The contacts of the log; SurfaceTimestep::contact is a position among them.
  [[nodiscard]] const std::vector<ContactSummary>& contacts() const { return contacts_; }
  /// True if --contact lets the contact through.
  [[nodiscard]] bool chosen(std::int64_t contact) const;

  /// Largest finite value of a column of glstat, as an absolute value; 0 without one.
  [[nodiscard]] double peak(double results::GlobalState::*value) const;
  /// The peak internal energy; where that is below 1 % of the peak total energy, as for rigid bodies, the latter.
  [[nodiscard]] const ReferenceEnergy& reference() const { return reference_; }

  /// Says what a rule could not judge and why: "there is no glstat".
  void skipped(const RuleIdentity& rule, std::string_view why);
  [[nodiscard]] const std::vector<std::string>& skips() const { return skips_; }

  /// A finding in one of the files, "sleout".
  [[nodiscard]] Finding finding(const RuleIdentity& rule, std::string_view file, Severity severity,
                                std::string message) const;

 private:
  const results::RunResults& files_;
  const SolverRun& log_;
  const std::vector<ContactSummary>& contacts_;
  const JudgeOptions& options_;
  ReferenceEnergy reference_;
  std::vector<std::string> skips_;
};

}  // namespace gapcheck::audit
