#include "man_page.hpp"

#include <fmt/format.h>

namespace gapcheck::manual {
namespace {

/// Text that roff prints literally: dashes that can be copied, no escapes, no macros at line starts.
std::string roff(std::string_view text) {
  std::string out;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) out += "\\&";
    line_start = c == '\n';
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

/// Bold, whatever follows.
std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }

std::string head(const OptionText& option) {
  std::string line;
  for (const std::string& name : option.names) {
    if (!line.empty()) line += ", ";
    line += option.argument ? "\\fI" + roff(name) + "\\fR" : bold(name);
  }
  if (!option.value.empty()) line += " \\fI" + roff(option.value) + "\\fR";
  return line;
}

void append_options(const CommandText& command, std::string& out) {
  for (const OptionText& option : command.options) {
    out += ".TP\n" + head(option) + "\n";
    std::string help = option.help.empty() ? "" : roff(option.help);
    if (!option.choices.empty()) {
      std::string list;
      for (const std::string& choice : option.choices) list += (list.empty() ? "" : ", ") + bold(choice);
      help += (help.empty() ? "" : "\n.br\n") + list;
    }
    // Lines of the help keep their breaks and indents.
    const bool several = option.help.find('\n') != std::string::npos;
    out += several ? ".nf\n" + help + "\n.fi\n" : help + "\n";
  }
}

}  // namespace

std::string man_page(const ProgramText& program, std::string_view version) {
  std::string upper = program.name;
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  std::string out = fmt::format(".TH {} 1 \"\" \"gapcheck {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", roff(upper),
                                version, roff(program.name), roff(program.help));
  out += ".SH SYNOPSIS\n";
  for (const CommandText& command : program.commands) {
    if (command.name.empty() && program.commands.size() > 1) continue;
    out += bold(program.name);
    if (!command.name.empty()) out += ' ' + bold(command.name);
    out += " [\\fIoptions\\fR]";
    for (const OptionText& option : command.options)
      if (option.argument) out += " \\fI" + roff(option.names.front()) + "\\fR";
    out += "\n.br\n";
  }
  for (const CommandText& command : program.commands) {
    out += command.name.empty() ? ".SH OPTIONS\n" : ".SH " + roff(program.name + " " + command.name) + "\n";
    if (!command.help.empty()) out += roff(command.help) + "\n";
    append_options(command, out);
  }
  if (!program.footer.empty()) out += ".SH EXIT STATUS\n" + roff(program.footer) + "\n";
  return out;
}

}  // namespace gapcheck::manual
