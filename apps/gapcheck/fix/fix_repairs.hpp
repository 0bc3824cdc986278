#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "audit/fix/fix.hpp"
#include "base/result.hpp"
#include "fix/before_after.hpp"
#include "keyword/deck.hpp"
#include "report/format/fix_report.hpp"
#include "settings/settings.hpp"
#include "solver/trial/run_trial.hpp"

namespace gapcheck::app {

/// What `gapcheck fix` is told.
struct FixArguments {
  std::string deck, directory, format = "text", output;
  std::string settings_path;  ///< empty: none is used
  std::string missing_includes = "error";
  std::vector<std::string> locks, priorities, apply;
  keyword::ReadOptions read;
  audit::FixOptions fix;
  BeforeAfter pictures;
  report::FixTextOptions text;
  SettingsOptions settings;
  solver::TrialSettings trial;
  std::size_t jobs = 0;
  bool dry_run = false, stats = false, verify = false, plan = false, best = false;
};

/// --plan, --apply or --best.
[[nodiscard]] bool asks_for_repairs(const FixArguments& arguments);

/// Lists the repairs of a deck, or writes it with some of them; returns the exit code.
[[nodiscard]] int repair_deck(const FixArguments& arguments);

/// An error if the report would overwrite an input or a file that is written.
[[nodiscard]] Status check_fix_report(const keyword::Deck& deck, const FixArguments& arguments,
                                      std::span<const FixedFile> written);

}  // namespace gapcheck::app
