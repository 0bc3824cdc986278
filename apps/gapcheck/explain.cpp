#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "audit/registry.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "output.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::app {
namespace {

int explain(const std::string& name, const CommonOptions& options) {
  const RuleIdentity* rule = audit::find_rule(name);
  if (rule == nullptr) {
    print(plain_error("there is no rule '" + name + "'; gapcheck rules lists them"));
    return failed;
  }
  Output output("");
  const std::string_view page = audit::page(*rule);
  output.write(options.quiet ? fmt::format("{} {}: {}\n", rule->id, rule->name, rule->summary) : std::string(page));
  if (options.stats) fmt::print(stderr, "  lines  {}\n", std::count(page.begin(), page.end(), '\n'));
  Failures failures(print);
  failures.add(output.close());
  return failures.any() ? failed : clean;
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("explain", "Print the page of one rule");
  const auto name = std::make_shared<std::string>();
  const RuleIdentity& example = record_rules::initial_penetration;
  command->add_option("RULE", *name, fmt::format("Id or name: {}, {}", example.id, example.name))->required();
  const auto options = std::make_shared<CommonOptions>();
  add_common(*command, *options, "Only the rule's summary, in one line");
  command->callback([&action, name, options] { action = [name, options] { return explain(*name, *options); }; });
}

}  // namespace gapcheck::app
