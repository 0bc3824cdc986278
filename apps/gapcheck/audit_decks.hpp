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

/// The options with which one deck is audited for an editor: those of its settings file and of `given`, which has the
/// settings file and how includes are read. `faults` in the settings: then none of them is used.
[[nodiscard]] audit::AuditOptions audit_options_of(const std::string& deck, const AuditArguments& given,
                                                   Diagnostics& faults);

/// Audits the decks one after the other, of a shard only its own, and writes the requested output; the exit code. Files
/// that hold one deck's results have {deck} in their name if there are several.
[[nodiscard]] int audit_decks(AuditArguments arguments);

}  // namespace gapcheck::app
