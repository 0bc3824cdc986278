#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "audit/registry.hpp"
#include "base/nearest_name.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "output.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::app {
namespace {

std::string summary(const RuleIdentity& rule) { return fmt::format("{} {}: {}\n", rule.id, rule.name, rule.summary); }

/// The rules that the text names; those that have it as a part only where none is called so.
std::vector<const RuleIdentity*> meant(const std::string& text) {
  const RuleIdentity* rule = audit::find_rule(text);
  return rule != nullptr ? std::vector{rule} : audit::rules_with(text);
}

/// The page of the one rule, or a line for each of several.
std::string explanation(const std::vector<const RuleIdentity*>& rules, bool quiet) {
  if (rules.size() == 1 && !quiet) return std::string(audit::page(*rules.front()));
  std::string text;
  for (const RuleIdentity* rule : rules) text += summary(*rule);
  return text;
}

int explain(const std::string& name, const CommonOptions& options) {
  const std::vector<const RuleIdentity*> rules = meant(name);
  if (rules.empty()) {
    const std::string_view deck = audit::nearest_rule(name, false), run = audit::nearest_rule(name, true);
    print(plain_error(fmt::format("there is no rule '{}'; gapcheck rules lists them{}", name,
                                  did_you_mean(deck.empty() ? run : deck))));
    return failed;
  }
  Output output("");
  const std::string page = explanation(rules, options.quiet);
  output.write(page);
  if (options.stats) fmt::print(stderr, "  lines  {}\n", std::count(page.begin(), page.end(), '\n'));
  Failures failures(print);
  failures.add(output.close());
  return failures.any() ? failed : clean;
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("explain", "Print the page of a rule");
  const auto name = std::make_shared<std::string>();
  const RuleIdentity& example = record_rules::initial_penetration;
  command->add_option("RULE", *name, fmt::format("Id, name or part of a name: {}, {}", example.id, example.name))
      ->required();
  const auto options = std::make_shared<CommonOptions>();
  add_common(*command, *options, "Only the rule's summary, in one line");
  command->callback([&action, name, options] { action = [name, options] { return explain(*name, *options); }; });
}

}  // namespace gapcheck::app
