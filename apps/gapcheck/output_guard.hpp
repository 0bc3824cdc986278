#pragma once
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "options.hpp"

namespace gapcheck::app {

/// A file that a command is to write.
struct PlannedOutput {
  std::string option;  ///< that names it
  std::string path;
  std::string deck = "";  ///< whose results it holds; empty: those of the whole call
};

/// A file that a command reads.
struct ReadInput {
  std::string path;
  std::string what;  ///< "the deck itself", "the settings file", …
};

/// The outputs that these options name, under their names.
[[nodiscard]] std::vector<PlannedOutput> planned_outputs(const OutputOptions& output);
[[nodiscard]] std::vector<PlannedOutput> planned_outputs(const ExportOptions& exports);

/// Adds the deck, and the files that it includes if one of the outputs exists and so might be one of them. What is
/// wrong with the deck is said when it is read for its own sake.
void add_deck_files(const std::string& deck, const keyword::ReadOptions& options,
                    const std::vector<PlannedOutput>& outputs, std::vector<ReadInput>& read);

/// The same for a deck that has been read.
void add_deck_files(const keyword::Deck& deck, std::vector<ReadInput>& read);

/// Adds the text files that a run leaves in its directory, which are read beside those that are named.
void add_run_files(const std::string& directory, std::vector<ReadInput>& read);

/// Why the outputs must not be written: one is a file that is read, by whatever name, or two are one file. Empty: they
/// may. Terminals, pipes and devices take what comes.
[[nodiscard]] std::string output_obstacle(const std::vector<ReadInput>& read,
                                          const std::vector<PlannedOutput>& outputs);

}  // namespace gapcheck::app
