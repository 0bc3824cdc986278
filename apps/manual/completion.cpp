#include "completion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gapcheck::manual {
namespace {

/// "check-c" → "_check_c".
std::string function_name(const ProgramText& program) {
  std::string name = "_" + program.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : std::string(separator)) + word;
  return out;
}

std::string command_names(const ProgramText& program) {
  std::vector<std::string> names;
  for (const CommandText& command : program.commands)
    if (!command.name.empty()) names.push_back(command.name);
  return joined(names, " ");
}

bool is_directory(const OptionText& option) { return option.value.find("DIR") != std::string::npos; }
bool takes_file(const OptionText& option) {
  return option.value.find("FILE") != std::string::npos || option.value.find("<") != std::string::npos;
}

/// What bash offers after an option: words, directories, files, or nothing of its own.
std::string bash_values(const OptionText& option) {
  if (!option.choices.empty())
    return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\"))", joined(option.choices, " "));
  if (!option.offered.empty())
    return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\"))", joined(option.offered, " "));
  if (is_directory(option)) return "COMPREPLY=($(compgen -d -- \"$cur\"))";
  return takes_file(option) ? "COMPREPLY=($(compgen -f -- \"$cur\"))" : "COMPREPLY=()";
}

std::string bash_command(const CommandText& command) {
  std::string out, words;
  std::vector<std::string> names;
  for (const OptionText& option : command.options) {
    if (option.argument) {
      if (!option.offered.empty()) words = fmt::format(" words='{}'", joined(option.offered, " "));
      continue;
    }
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (!option.value.empty())
      out += fmt::format("        {}) {}; return ;;\n", joined(option.names, "|"), bash_values(option));
  }
  return fmt::format("      case \"$prev\" in\n{}        *) ;;\n      esac\n      options='{}'{} ;;\n", out,
                     joined(names, " "), words);
}

/// Help for one line of zsh's _arguments, between square brackets in single quotes.
std::string zsh_help(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, text.find('\n'))) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return out;
}

std::string zsh_action(const OptionText& option) {
  if (!option.choices.empty()) return fmt::format("({})", joined(option.choices, " "));
  if (!option.offered.empty()) return fmt::format("({})", joined(option.offered, " "));
  if (is_directory(option)) return "_files -/";
  return takes_file(option) || option.argument ? "_files" : "";
}

void append_zsh_options(const CommandText& command, std::string& out) {
  std::string argument = "_files";
  for (const OptionText& option : command.options) {
    if (option.argument) argument = zsh_action(option);
    if (option.argument) continue;
    for (const std::string& name : option.names) {
      out += fmt::format("        '{}[{}]", name, zsh_help(option.help));
      if (!option.value.empty()) out += fmt::format(":{}:{}", zsh_help(option.value), zsh_action(option));
      out += "' \\\n";
    }
  }
  out += fmt::format("        '*:{}:{}'\n", argument == "_files" ? "file" : "rule", argument);
}

}  // namespace

std::string bash_completion(const ProgramText& program) {
  const std::string name = function_name(program);
  std::string out = fmt::format("# bash completion of {}\n{}() {{\n", program.name, name);
  out += "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} options='' words=''\n";
  const std::string commands = command_names(program);
  if (commands.empty()) {
    out += "  case '' in\n    *)\n" + bash_command(program.commands.front());
  } else {
    out += fmt::format(
        "  if ((COMP_CWORD == 1)); then\n    COMPREPLY=($(compgen -W '{} --help --version' -- \"$cur\"))\n"
        "    return\n  fi\n  case \"${{COMP_WORDS[1]}}\" in\n",
        commands);
    for (const CommandText& command : program.commands)
      if (!command.name.empty()) out += fmt::format("    {})\n{}", command.name, bash_command(command));
  }
  out +=
      "  esac\n  if [[ $cur == -* ]]; then\n    COMPREPLY=($(compgen -W \"$options\" -- \"$cur\"))\n"
      "  elif [[ $words ]]; then\n    COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n  else\n"
      "    COMPREPLY=($(compgen -f -- \"$cur\"))\n  fi\n}\n";
  return out + fmt::format("complete -o filenames -F {} {}\n", name, program.name);
}

std::string zsh_completion(const ProgramText& program) {
  std::string out = fmt::format("#compdef {}\n", program.name);
  if (command_names(program).empty()) {
    out += "_arguments \\\n";
    append_zsh_options(program.commands.front(), out);
    return out;
  }
  out += "local -a commands\ncommands=(\n";
  for (const CommandText& command : program.commands)
    if (!command.name.empty()) out += fmt::format("  '{}:{}'\n", command.name, zsh_help(command.help));
  out += ")\nif ((CURRENT == 2)); then\n  _describe command commands\n  return\nfi\ncase $words[2] in\n";
  for (const CommandText& command : program.commands) {
    if (command.name.empty()) continue;
    out += fmt::format("  {})\n    shift words; ((CURRENT--))\n    _arguments \\\n", command.name);
    append_zsh_options(command, out);
    out += "    ;;\n";
  }
  return out + "esac\n";
}

}  // namespace gapcheck::manual
