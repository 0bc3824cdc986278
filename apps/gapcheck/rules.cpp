#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "audit/registry.hpp"
#include "commands.hpp"
#include "output.hpp"
#include "report/describe.hpp"

namespace gapcheck::app {
namespace {

int list_rules() {
  std::size_t width = 0;
  for (const auto& rule : audit::rules()) width = std::max(width, rule.name.size());
  Output output("");
  for (const auto& rule : audit::rules())
    output.write(
        fmt::format("{}  {:<{}}  {:<7}  {}\n", rule.id, rule.name, width, report::name(rule.severity), rule.summary));
  return output.close() ? clean : failed;
}

}  // namespace

void add_rules(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("rules", "List the rules: id, name, severity, summary");
  command->callback([&action] { action = list_rules; });
}

}  // namespace gapcheck::app
