// Any bytes as a settings file.
#include "fuzz.hpp"
#include "settings/settings.hpp"
#include "settings/settings_file.hpp"

namespace gapcheck::fuzz::settings_target {

GAPCHECK_FUZZ_TARGET(settings) {
  Diagnostics diagnostics;
  const app::Settings settings = app::read_settings(input, "folder/gapcheck.toml", diagnostics);
  for (const app::Setting& setting : settings.options) require(setting.key != nullptr);
  static_cast<void>(app::ignores_for("folder/deck.k", settings));
  for (const Diagnostic& diagnostic : diagnostics.sorted()) require(!diagnostic.message.empty());
}

}  // namespace gapcheck::fuzz::settings_target
