#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "campaign/deck_results.hpp"
#include "campaign/results_file.hpp"

namespace gapcheck::app {

/// The identity of a list of decks.
[[nodiscard]] DeckListId id_of_list(const std::vector<std::string>& decks);

/// What a results file keeps of a deck that was audited, or, with `unread`, could not be.
struct AuditedDeck {
  std::string deck;
  std::uint64_t position = 0;  ///< in the call's list
  ContentHash key;
  AskedIds asked;
  const Report* report = nullptr;            ///< none: it could not be read
  std::string unread;                        ///< why
  const Diagnostic* why = nullptr;           ///< the same, as it was printed
  const Diagnostics* diagnostics = nullptr;  ///< none: there are none
  bool failed = false;                       ///< an error was reported
};

/// The entry of a results file.
[[nodiscard]] DeckResult entry_of(const AuditedDeck& audited, const DeckListId& call);

/// The report of an entry that has one. Error: its bytes are not those of a report.
[[nodiscard]] Result<Report> report_of(const DeckResult& entry, const std::string& file);

/// Prints what was printed when the deck was audited.
void print_again(const DeckResult& entry, bool quiet);

}  // namespace gapcheck::app
