#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "records/rule_identity.hpp"

namespace gapcheck::audit {

/// What the rules of one audit report about themselves, for --stats.
class RuleLog {
 public:
  /// Records what a rule left out and why: "GC103: 3 contacts have no surfaces to compare".
  void skipped(const RuleIdentity& rule, std::string_view what) {
    skips_.push_back(std::string(rule.id).append(": ").append(what));
  }
  [[nodiscard]] const std::vector<std::string>& skips() const { return skips_; }
  /// Counts a rule that has run. `asked`: for surfaces, a search or time steps.
  void count_rule(bool asked) { ++(asked ? asking_ : content_); }
  [[nodiscard]] std::uint64_t rules_run() const { return asking_ + content_; }
  /// Those that used the model as it was read.
  [[nodiscard]] std::uint64_t content_rules() const { return content_; }

 private:
  std::vector<std::string> skips_;
  std::uint64_t asking_ = 0, content_ = 0;
};

}  // namespace gapcheck::audit
