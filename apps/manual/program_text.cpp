#include "program_text.hpp"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <string_view>

#include "../check-c/arguments.hpp"
#include "audit/registry.hpp"
#include "command_line.hpp"

namespace gapcheck::manual {
namespace {

/// "TEXT:{text,json}" → text, json.
std::vector<std::string> choices_in(std::string_view type) {
  std::vector<std::string> choices;
  const auto open = type.find('{'), close = type.rfind('}');
  if (open == type.npos || close == type.npos || close < open) return choices;
  std::string_view list = type.substr(open + 1, close - open - 1);
  while (!list.empty()) {
    const std::string_view entry = list.substr(0, list.find(','));
    const std::string_view key = entry.substr(0, entry.find("->"));  // for a map the user writes the keys
    choices.emplace_back(key);
    list.remove_prefix(std::min(list.size(), entry.size() + 1));
  }
  return choices;
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  text.argument = option.get_positional() && option.get_lnames().empty() && option.get_snames().empty();
  if (text.argument) text.names.push_back(option.get_name(true) + (option.get_items_expected_max() > 1 ? "…" : ""));
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  text.help = option.get_description();
  const std::string type = option.get_type_name();
  text.choices = choices_in(type);
  if (option.get_items_expected_max() > 0 && !text.argument)
    text.value = !text.choices.empty() ? "WORD" : type.empty() || type == "TEXT" ? "TEXT" : type;
  return text;
}

/// Names of the rules that a command knows: messag judges runs, explain has the pages of all, the others judge decks.
std::vector<std::string> rule_names(const std::string& command) {
  std::vector<std::string> names;
  for (const RuleIdentity& rule : audit::rules())
    if (command == "explain" || rule.of_runs() == (command == "messag")) names.emplace_back(rule.name);
  return names;
}

CommandText text_of(const CLI::App& command) {
  CommandText text{command.get_name(), command.get_description(), {}};
  for (const CLI::Option* option : command.get_options()) {
    text.options.push_back(text_of(*option));
    if (option->get_type_name() == "RULES" || option->get_name(true) == "RULE")
      text.options.back().offered = rule_names(text.name);
  }
  return text;
}

}  // namespace

ProgramText gapcheck_text() {
  CLI::App app;
  app::Action action;
  app::add_commands(app, action);
  ProgramText program{app.get_name(), app.get_description(), app.get_footer(), {}};
  CommandText own = text_of(app);
  own.name.clear();
  own.help.clear();
  program.commands.push_back(own);
  for (const CLI::App* command : app.get_subcommands({})) program.commands.push_back(text_of(*command));
  return program;
}

ProgramText check_c_text() {
  ProgramText program{"check-c",
                      "Lists the contact warnings of LS-DYNA message files after initialisation.",
                      "Exit codes: 0 no warnings, 1 warnings, 2 bad arguments or input that cannot be read.",
                      {}};
  CommandText own;
  own.options.push_back({{"messag-file"}, "", "messag, mesNNNN or d3hsp files, or a run's directory", {}, true});
  for (const check_c::OptionText& option : check_c::option_texts())
    own.options.push_back({{std::string(option.name)}, std::string(option.value), std::string(option.help), {}, false});
  program.commands.push_back(own);
  return program;
}

}  // namespace gapcheck::manual
