#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "audit/ignores.hpp"
#include "audit/threshold.hpp"
#include "base/diagnostic.hpp"
#include "records/report.hpp"
#include "settings/setting_keys.hpp"

namespace gapcheck::app {

/// A top-level key with its values as on the command line; paths are relative to the working folder.
struct Setting {
  const SettingKey* key;
  std::vector<std::string> values;
  std::uint32_t line;
};

/// What to leave out, and for which decks.
struct SettingsIgnore {
  audit::IgnoreEntry entry;
  std::vector<std::string> decks;  ///< patterns, as seen from the entry's base; empty: all
};

/// What a settings file says.
struct Settings {
  std::string path;  ///< empty: there is no such file
  std::vector<Setting> options;
  std::vector<SettingsIgnore> ignores;
  Severities severities = {};
  audit::Thresholds thresholds = {};
};

/// Reads the text (TOML 1.0, UTF-8) of the settings file `path`. All mistakes go to `diagnostics` as errors with line;
/// after a syntax error nothing is read. The valid rest is in the result. Limits: lists and inline tables nested 32
/// deep, keys of 100 names.
[[nodiscard]] Settings read_settings(std::string_view text, const std::string& path, Diagnostics& diagnostics);

}  // namespace gapcheck::app
