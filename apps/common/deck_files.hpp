#pragma once
#include <map>
#include <string>
#include <vector>

#include "keyword/deck.hpp"

namespace gapcheck::app {

/// Which files decks include, before they are read for their own sake: each deck is read for that once in a call. With
/// a cache in the options, that reading scans no file again.
class DeckFiles {
 public:
  /// `options` must outlive it.
  explicit DeckFiles(const keyword::ReadOptions& options) : options_(options) {}
  /// Paths of the files that a deck includes, directly or indirectly, once per inclusion. None if it cannot be read;
  /// faults are reported when it is read for its own sake.
  [[nodiscard]] const std::vector<std::string>& includes(const std::string& deck) { return known(deck).includes; }
  /// Names of the included files that are missing, as written.
  [[nodiscard]] const std::vector<std::string>& missing(const std::string& deck) { return known(deck).missing; }
  /// True if comments of the deck say something to gapcheck.
  [[nodiscard]] bool has_directives(const std::string& deck) { return known(deck).directives; }
  /// True if the deck with its includes has *CONTROL_TERMINATION and nodes, without which no run begins; an include
  /// that is missing may have the nodes. False if the deck cannot be read.
  [[nodiscard]] bool can_run(const std::string& deck) { return known(deck).can_run; }

 private:
  struct Known {
    std::vector<std::string> includes, missing;
    bool directives = false;
    bool can_run = false;
  };
  const Known& known(const std::string& deck);

  const keyword::ReadOptions& options_;
  std::map<std::string, Known> known_;  ///< by deck
};

}  // namespace gapcheck::app
