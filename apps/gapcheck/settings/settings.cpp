#include "settings/settings.hpp"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Error.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "audit/ignore_demand.hpp"
#include "base/file_bytes.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_file = 1 << 20;

/// Replaces the values of an option. The error says what is wrong with them.
Status give(CLI::Option& option, const std::vector<std::string>& values) {
  try {
    option.clear();
    option.add_result(values);
    option.run_callback();
    return {};
  } catch (const CLI::Error& error) {
    // "--top: Value 5000 not in range": the key says which one.
    const std::string_view text = error.what();
    const std::size_t colon = text.find(": ");
    return plain_error(std::string(colon == text.npos ? text : text.substr(colon + 2)));
  }
}

/// All settings must be valid for an audit, whatever the command uses.
void check_options(const Settings& settings, Diagnostics& diagnostics) {
  CLI::App app;
  Action action;
  add_audit(app, action);
  for (const Setting& setting : settings.options) {
    CLI::Option& option = *app.get_subcommand("audit")->get_option(std::string(setting.key->option));
    if (const Status given = give(option, setting.values); !given.ok())
      diagnostics.error(settings.path, setting.line, fmt::format("{}: {}", setting.key->name, given.error().message));
  }
}

Settings read_file(const std::string& path, Diagnostics& diagnostics) {
  const auto file = FileBytes::open(path);
  if (!file) {
    diagnostics.add(file.error());
    return {path, {}, {}, {}};
  }
  if (file.value().bytes().size() > largest_file) {
    diagnostics.error(path, 0, "is not a settings file: it has more than a megabyte");
    return {path, {}, {}, {}};
  }
  Settings settings = read_settings(file.value().bytes(), path, diagnostics);
  check_options(settings, diagnostics);
  return settings;
}

}  // namespace

void add_settings(CLI::App& command, SettingsOptions& options) {
  CLI::Option* file = command
                          .add_option("--config", options.file,
                                      "Settings file, instead of the gapcheck.toml beside "
                                      "the deck or above it")
                          ->type_name("FILE");
  CLI::Option* none = command.add_flag("--no-config", options.none, "Use no settings file")->excludes(file);
  for (CLI::Option* option : {file, none}) option->group("Settings");
}

std::string find_settings(const std::string& deck) {
  std::error_code failed;
  const fs::path here = fs::current_path(failed);
  if (failed) return "";
  // By the names that the user gave, like patterns for files.
  const std::string_view fixed = std::string_view(deck).substr(0, deck.find_first_of("*?"));
  fs::path folder = (here / fixed).lexically_normal().parent_path();
  for (;; folder = folder.parent_path()) {
    const fs::path file = folder / settings_name;
    if (fs::is_regular_file(file, failed))
      return fs::path(deck).is_absolute() ? file.string() : file.lexically_proximate(here).string();
    if (fs::exists(folder / ".git", failed) || folder == folder.parent_path()) return "";
  }
}

Settings use_settings(const SettingsOptions& options, const std::string& deck, bool audit, CLI::App& command,
                      Diagnostics& diagnostics) {
  if (options.none) return {};
  const std::string path = options.file.empty() ? find_settings(deck) : options.file;
  if (path.empty()) return {};
  Settings settings = read_file(path, diagnostics);
  if (diagnostics.has_errors()) return settings;
  for (const Setting& setting : settings.options) {
    if (!audit && !setting.key->reading) continue;
    CLI::Option& option = *command.get_option(std::string(setting.key->option));
    // All of them were checked above.
    if (option.count() == 0) static_cast<void>(give(option, setting.values));
  }
  return settings;
}

Settings use_settings(const SettingsOptions& options, const std::string& deck, bool audit, CLI::App& command,
                      Failures& failures) {
  Diagnostics diagnostics;
  Settings settings = use_settings(options, deck, audit, command, diagnostics);
  print(diagnostics, false);
  failures.count(diagnostics);
  return settings;
}

std::string seen_from_settings(const std::string& deck, const Settings& settings) {
  std::error_code failed;
  const fs::path here = fs::current_path(failed);
  const fs::path folder = (here / settings.path).lexically_normal().parent_path();
  return (here / deck).lexically_normal().lexically_relative(folder).generic_string();
}

std::vector<audit::IgnoreEntry> ignores_for(const std::string& deck, const Settings& settings) {
  std::vector<audit::IgnoreEntry> list;
  for (const SettingsIgnore& ignore : settings.ignores) {
    const auto meant = [&](const std::string& pattern) { return audit::in_folder(pattern, ignore.entry.base, deck); };
    if (ignore.decks.empty() || std::any_of(ignore.decks.begin(), ignore.decks.end(), meant))
      list.push_back(ignore.entry);
  }
  return list;
}

}  // namespace gapcheck::app
