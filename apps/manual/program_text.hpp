#pragma once
#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace gapcheck::manual {

/// One option or argument as manual pages and completions need it.
struct OptionText {
  std::vector<std::string> names;  ///< with their dashes; of an argument: its one name
  std::string value;               ///< what it takes: "FILE"; empty: nothing
  std::string help;
  std::vector<std::string> choices;       ///< the only values it takes; empty: any
  bool argument = false;                  ///< has no name
  std::vector<std::string> offered = {};  ///< values that completions offer besides `choices`: names of rules
};

struct CommandText {
  std::string name;  ///< empty: the program without a command
  std::string help;
  std::vector<OptionText> options;  ///< in the order of --help
};

struct ProgramText {
  std::string name, help, footer;
  std::vector<CommandText> commands;
};

/// All of gapcheck, from the definitions that parse the command line.
[[nodiscard]] ProgramText gapcheck_text();
/// The same for check-c.
[[nodiscard]] ProgramText check_c_text();

}  // namespace gapcheck::manual
