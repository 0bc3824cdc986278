#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "base/result.hpp"
#include "lsp/features/features.hpp"

namespace gapcheck::app::lsp {

/// Reads the structure of a deck for scopes. `changed`: texts of the editor that replace files, by canonical path.
/// nullptr: it cannot be read.
[[nodiscard]] std::shared_ptr<const keyword::Deck> deck_for_editor(const std::string& deck, keyword::ReadOptions read,
                                                                   const std::map<std::string, std::string>& changed);

/// The keywords of a text, line by line, with the cards of those that other files depend on: parameters, includes.
[[nodiscard]] std::string skeleton(const Text& text, std::span<const Keyword> outline);
/// Whether a keyword is one of these.
[[nodiscard]] bool is_structure(const Keyword& keyword);

/// How a deck is read and audited, and what is wrong with its settings file: then none of that is used.
struct DeckOptions {
  audit::AuditOptions audit;
  std::vector<Diagnostic> faults;
  /// Compares a report with the baseline that the settings name, and says what is wrong with that; empty: there is
  /// none.
  std::function<Status(Report& report)> compare{};
};
using OptionsOf = std::function<DeckOptions(const std::string& deck)>;

/// What an audit found.
struct Audited {
  std::map<std::string, std::vector<LineFinding>> findings;  ///< by canonical path
  std::string summary;                                       ///< one line
  bool repairable = false;                                   ///< one of them has a target of repairs
};

/// Most findings of one rule in one contact that are listed one by one.
inline constexpr std::size_t most_of_a_rule = 100;
/// Most findings of one file.
inline constexpr std::size_t most_of_a_file = 1000;

/// Audits the deck on disk. An audit that cannot be made is a finding in the first line of `deck`; faults of the
/// settings are findings in their lines. Nothing: `go_on` said no.
[[nodiscard]] std::optional<Audited> audit_for_editor(const std::string& deck, const OptionsOf& options_of,
                                                      const std::function<bool()>& go_on);

/// The lines of a deck on disk that `gapcheck fix` changes.
struct FixedLines {
  std::map<std::string, std::vector<FixedLine>> edits;  ///< by canonical path
  std::string summary;
};
/// Errors: those of `gapcheck fix`.
[[nodiscard]] Result<FixedLines> fix_for_editor(const std::string& deck, const OptionsOf& options_of);

}  // namespace gapcheck::app::lsp
