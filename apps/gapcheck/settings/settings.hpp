#pragma once
#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "common/failures.hpp"
#include "settings/settings_file.hpp"

namespace gapcheck::app {

/// Which settings file is used: a named one, none, or the one found.
struct SettingsOptions {
  std::string file;
  bool none = false;
};
void add_settings(CLI::App& command, SettingsOptions& options);

/// The name of settings files.
inline constexpr const char* settings_name = "gapcheck.toml";

/// The settings file beside the deck, or in the nearest folder above, up to the first that has .git; empty: none.
/// Relative to the working directory if the deck's path is. For a pattern of decks, the search starts at the folder
/// before its first * or ?.
[[nodiscard]] std::string find_settings(const std::string& deck);

/// Reads the settings for a deck and fills in the command's options that the command line left open. `audit`: all of
/// it, otherwise only what concerns reading decks. After errors, which go to `diagnostics`, no option is filled in.
[[nodiscard]] Settings use_settings(const SettingsOptions& options, const std::string& deck, bool audit,
                                    CLI::App& command, Diagnostics& diagnostics);
/// The same with what is wrong printed.
[[nodiscard]] Settings use_settings(const SettingsOptions& options, const std::string& deck, bool audit,
                                    CLI::App& command, Failures& failures);

/// The deck's path relative to the folder of the settings file, whatever the working folder is.
[[nodiscard]] std::string seen_from_settings(const std::string& deck, const Settings& settings);

/// What the settings leave out of the report on a deck.
[[nodiscard]] std::vector<audit::IgnoreEntry> ignores_for(const std::string& deck, const Settings& settings);

}  // namespace gapcheck::app
