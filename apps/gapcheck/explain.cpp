#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "audit/registry.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "output.hpp"

namespace gapcheck::app {
namespace {

int explain(const std::string& name, const CommonOptions& options) {
  const audit::RuleInfo* rule = audit::find_rule(name);
  if (rule == nullptr) {
    print_error("there is no rule '" + name + "'; gapcheck rules lists them");
    return failed;
  }
  Output output("");
  const std::string_view page = audit::page(*rule);
  output.write(options.quiet ? fmt::format("{} {}: {}\n", rule->id, rule->name, rule->summary) : std::string(page));
  if (options.stats) fmt::print(stderr, "  lines  {}\n", std::count(page.begin(), page.end(), '\n'));
  return output.close() ? clean : failed;
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("explain", "Print the page of one rule");
  const auto name = std::make_shared<std::string>();
  command->add_option("RULE", *name, "Id or name: GC101, initial-penetration")->required();
  const auto options = std::make_shared<CommonOptions>();
  add_common(*command, *options, "Only the rule's summary, in one line");
  command->callback([&action, name, options] { action = [name, options] { return explain(*name, *options); }; });
}

}  // namespace gapcheck::app
