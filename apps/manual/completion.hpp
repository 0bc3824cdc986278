#pragma once
#include <string>

#include "program_text.hpp"

namespace gapcheck::manual {

/// Completion of commands, options, words that an option takes, and files, as scripts for the two shells.
[[nodiscard]] std::string bash_completion(const ProgramText& program);
[[nodiscard]] std::string zsh_completion(const ProgramText& program);

}  // namespace gapcheck::manual
