#pragma once
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

#include "audit/audit.hpp"
#include "audit/ignore_facts.hpp"
#include "audit/registry.hpp"
#include "base/path_pattern.hpp"

namespace gapcheck::audit {

/// True if the last day of the entry has passed.
inline bool expired(const IgnoreEntry& entry, const AuditOptions& options) {
  return entry.until && options.today != std::chrono::sys_days{} && std::chrono::sys_days(*entry.until) < options.today;
}

/// The rules picked by lists of ids, names and prefixes; a deck may repeat the same list in every comment.
class RuleLists {
 public:
  /// By position in rules(). Lives as long as the lists.
  const std::vector<bool>& of(const std::vector<std::string>& patterns) {
    const auto [known, is_new] = known_.try_emplace(patterns);
    if (is_new)
      for (const RuleIdentity& rule : rules())
        known->second.push_back(!patterns.empty() && selected(rule, patterns, {}));
    return known->second;
  }

 private:
  std::map<std::vector<std::string>, std::vector<bool>> known_;
};

/// True if the pattern, relative to the folder `base`, matches the file: by the names given, or by those behind links.
inline bool in_folder(const std::string& pattern, const std::filesystem::path& base,
                      const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  const auto meant = [&](const fs::path& from, const fs::path& to) {
    return gapcheck::matches(pattern, to.lexically_relative(from).generic_string());
  };
  const auto full = [](const fs::path& path) {
    std::error_code failed;
    const fs::path whole = fs::absolute(path, failed);
    return (failed ? path : whole).lexically_normal();
  };
  if (meant(full(base), full(file))) return true;
  std::error_code failed[2];
  const fs::path from = fs::weakly_canonical(fs::absolute(base, failed[0]), failed[0]);
  const fs::path to = fs::weakly_canonical(fs::absolute(file, failed[1]), failed[1]);
  return !failed[0] && !failed[1] && meant(from, to);
}

/// One demand with everything resolved that needs resolving only once.
class Demand {
 public:
  Demand(IgnoreEntry entry, RuleLists& lists) : entry_(std::move(entry)), of_rule_(&lists.of(entry_.rules)) {
    for (std::vector<IdRange>* ids : {&entry_.contacts, &entry_.nodes, &entry_.parts, &entry_.elements}) join(*ids);
    if (!entry_.files.empty()) base_ = entry_.base;
  }
  [[nodiscard]] const IgnoreEntry& entry() const { return entry_; }
  /// By position in rules().
  [[nodiscard]] const std::vector<bool>& rules_wanted() const { return *of_rule_; }

  [[nodiscard]] bool matches(const Fact& fact) {
    const auto lets = [](const std::vector<IdRange>& ids, std::int64_t id) { return ids.empty() || holds(ids, id); };
    return fact.rule != no_position && (*of_rule_)[fact.rule] && lets(entry_.contacts, fact.contact) &&
           lets(entry_.nodes, fact.node) && lets(entry_.elements, fact.element) &&
           (lets(entry_.parts, fact.part) || lets(entry_.parts, fact.element_part)) && shallow(fact) && in_files(fact);
  }

  /// True if everything that the demand could match was looked for.
  [[nodiscard]] bool tried(const AuditOptions& options) const {
    if (!options.parts.empty() || options.ptol >= 0 || options.rtol >= 0 || options.ratio >= 0) return false;
    const auto looked_at = [&](const IdRange& range) {
      return range.first == range.last &&
             std::find(options.contacts.begin(), options.contacts.end(), range.first) != options.contacts.end();
    };
    if (!options.contacts.empty() &&
        (entry_.contacts.empty() || !std::all_of(entry_.contacts.begin(), entry_.contacts.end(), looked_at)))
      return false;
    for (std::size_t i = 0; i < rules().size(); ++i)
      if ((*of_rule_)[i] && !rules()[i].of_runs() && !selected(rules()[i], options.select, options.ignore))
        return false;
    return true;
  }

 private:
  /// Decides on the remaining distance, as --ptol does: a depth is the difference of two lengths.
  static bool within(const Fact& fact, double limit) {
    const double h = fact.contact_distance;
    return fact.penetration >= 0 && (fact.penetration <= limit || (h > 0 && h - fact.penetration >= h - limit));
  }

  [[nodiscard]] bool shallow(const Fact& fact) const {
    if (entry_.ptol >= 0 && !within(fact, entry_.ptol)) return false;
    return entry_.ratio < 0 || (fact.contact_distance > 0 && within(fact, entry_.ratio * fact.contact_distance));
  }

  bool in_files(const Fact& fact) {
    if (entry_.files.empty()) return true;
    if (fact.file == nullptr) return false;
    const auto [known, is_new] = of_file_.try_emplace(*fact.file, false);
    if (is_new) known->second = in_folder(entry_.files, base_, *fact.file);
    return known->second;
  }

  IgnoreEntry entry_;
  const std::vector<bool>* of_rule_;
  std::filesystem::path base_;
  std::unordered_map<std::string, bool> of_file_;
};

}  // namespace gapcheck::audit
