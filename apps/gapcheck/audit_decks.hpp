#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "baseline_options.hpp"
#include "campaign/shard.hpp"
#include "options.hpp"
#include "settings/settings.hpp"

namespace gapcheck::app {

/// The input of `gapcheck audit`.
struct AuditArguments {
  std::vector<std::string> decks;    ///< paths and patterns
  std::vector<std::string> changed;  ///< only decks that one of these files belongs to
  std::vector<std::string> deleted;  ///< and those that still include one of these; neither: all decks
  std::string missing_includes = "error";
  std::vector<std::string> as_if;
  std::string units;
  audit::AuditOptions audit;
  OutputOptions output;
  ExportOptions exports;
  BaselineOptions baseline;
  OverviewOptions overview;
  std::string results;  ///< path of the file that keeps what is found in each deck; empty: not requested
  Shard shard;          ///< which of the decks
  SettingsOptions settings_file;
  Settings settings;       ///< what that file says besides options
  bool fixes = false;      ///< repairs are tried, for SARIF
  bool selection = false;  ///< the command line leaves something out; what settings leave out does not count
  std::size_t jobs = 0;
};

/// True if the options leave anything out.
[[nodiscard]] bool selects(const audit::AuditOptions& audit);

/// Baseline findings that the audit did not look for are not gone.
[[nodiscard]] bool looked_for(const KnownFinding& known, const audit::AuditOptions& options);

/// How one deck is audited for an editor.
struct EditorAudit {
  audit::AuditOptions audit;
  BaselineOptions baseline;
  std::string settings;  ///< path of the settings file; empty: none is used
};

/// The options of its settings file and of `given`, which has the settings file and how includes are read. `faults` in
/// the settings: then none of them is used.
[[nodiscard]] EditorAudit editor_audit_of(const std::string& deck, const AuditArguments& given, Diagnostics& faults);

/// Compares a report with the baseline of the settings, if they name one. Errors: it cannot be read; where it is not
/// there, the settings file is what is wrong.
[[nodiscard]] Status compare_for_editor(const EditorAudit& editor, Report& report);

/// Audits the decks one after the other, of a shard only its own, and writes the requested output; the exit code. Files
/// that hold one deck's results have {deck} in their name if there are several.
[[nodiscard]] int audit_decks(AuditArguments arguments);

}  // namespace gapcheck::app
