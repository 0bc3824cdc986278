#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "audit/registry.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "output.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::app {
namespace {

int list_rules(const CommonOptions& options) {
  std::size_t width = 0;
  for (const auto& rule : audit::rules()) width = std::max(width, rule.name.size());
  Output output("");
  for (const auto& rule : audit::rules())
    output.write(options.quiet ? fmt::format("{}\n", rule.id)
                               : fmt::format("{}  {:<{}}  {:<7}  {}\n", rule.id, rule.name, width,
                                             report::name(rule.severity), rule.summary));
  if (options.stats) fmt::print(stderr, "  rules  {}\n", audit::rules().size());
  Failures failures(print);
  failures.add(output.close());
  return failures.any() ? failed : clean;
}

}  // namespace

void add_rules(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("rules", "List the rules: id, name, severity, summary");
  const auto options = std::make_shared<CommonOptions>();
  add_common(*command, *options, "Only the ids");
  command->callback([&action, options] { action = [options] { return list_rules(*options); }; });
}

}  // namespace gapcheck::app
