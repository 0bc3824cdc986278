#include <memory>
#include <string>

#include "audit/registry.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace gapcheck::app {
namespace {

int explain(const std::string& name) {
  const audit::RuleInfo* rule = audit::find_rule(name);
  if (rule == nullptr) {
    print_error("there is no rule '" + name + "'; gapcheck rules lists them");
    return failed;
  }
  Output output("");
  output.write(audit::page(*rule));
  return output.close() ? clean : failed;
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("explain", "Print the page of one rule");
  const auto name = std::make_shared<std::string>();
  command->add_option("RULE", *name, "Id or name: GC101, initial-penetration")->required();
  command->callback([&action, name] { action = [name] { return explain(*name); }; });
}

}  // namespace gapcheck::app
