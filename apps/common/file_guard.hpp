#pragma once
#include <string>
#include <vector>

#include "base/result.hpp"
#include "common/deck_files.hpp"
#include "keyword/deck.hpp"

namespace gapcheck::app {

/// A file that a command will write.
struct PlannedOutput {
  std::string option;  ///< that names it
  std::string path;
  std::string deck{};                             ///< whose results it holds; empty: those of the whole call
  std::string instead = "another file to write";  ///< what to give where this is an input
};

/// A file that a command reads.
struct ReadInput {
  std::string path;
  std::string what;  ///< "the deck itself", "the settings file", …
};

/// Adds the deck, and its includes if one of the outputs exists and so might be one of them. Faults of the deck are
/// reported when it is actually read.
void add_deck_files(const std::string& deck, DeckFiles& files, const std::vector<PlannedOutput>& outputs,
                    std::vector<ReadInput>& read);

/// The same for a deck that has been read.
void add_deck_files(const keyword::Deck& deck, std::vector<ReadInput>& read);

/// Adds the files of a run in a directory, which are read besides the named ones.
void add_run_files(const std::string& directory, std::vector<ReadInput>& read);

/// An error if the outputs must not be written: one is also an input, under any name, or two are the same file.
/// Terminals, pipes and devices are always allowed.
[[nodiscard]] Status check_outputs(const std::vector<ReadInput>& read, const std::vector<PlannedOutput>& outputs);

}  // namespace gapcheck::app
