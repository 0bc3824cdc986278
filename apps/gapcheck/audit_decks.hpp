#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "baseline_options.hpp"
#include "options.hpp"
#include "settings.hpp"

namespace gapcheck::app {

/// What `gapcheck audit` is told.
struct AuditArguments {
  std::vector<std::string> decks;  ///< paths and patterns
  std::string missing_includes = "error";
  std::string units;
  audit::AuditOptions audit;
  OutputOptions output;
  ExportOptions exports;
  BaselineOptions baseline;
  SettingsOptions settings_file;
  Settings settings;       ///< what that file says and is no option
  bool selection = false;  ///< the command line leaves something out, which a settings file does for good
  std::size_t jobs = 0;
};

/// True if the options leave anything out.
[[nodiscard]] bool selects(const audit::AuditOptions& audit);

/// Audits the decks one after the other and writes what was asked for; the exit code. Files that hold one deck's results
/// carry {deck} in their name where there are several.
[[nodiscard]] int audit_decks(AuditArguments arguments);

}  // namespace gapcheck::app
