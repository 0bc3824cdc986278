#pragma once
#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "settings_file.hpp"

namespace gapcheck::app {

/// Which settings file is used: the one that is named, none, or the one that is found.
struct SettingsOptions {
  std::string file;
  bool none = false;
};
void add_settings(CLI::App& command, SettingsOptions& options);

/// The name of settings files.
inline constexpr const char* settings_name = "gapcheck.toml";

/// The settings file beside the deck, or in the nearest folder above, up to the first that has .git; empty: none. As
/// seen from the working directory if the deck's path is. Of a pattern for decks, the folder before its first * or ?.
[[nodiscard]] std::string find_settings(const std::string& deck);

/// Reads the settings for a deck and gives the command's options what the command line left open. `audit`: all of it,
/// otherwise only what concerns the reading of decks. Nothing after errors, which have been said.
[[nodiscard]] std::optional<Settings> use_settings(const SettingsOptions& options, const std::string& deck, bool audit,
                                                   CLI::App& command);

/// The deck's path as seen from the folder of the settings file, whatever the working folder is.
[[nodiscard]] std::string seen_from_settings(const std::string& deck, const Settings& settings);

/// What the settings leave out of the report on a deck.
[[nodiscard]] std::vector<audit::IgnoreEntry> ignores_for(const std::string& deck, const Settings& settings);

}  // namespace gapcheck::app
