#pragma once
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_bytes.hpp"
#include "base/result.hpp"
#include "campaign/content_hash.hpp"

namespace gapcheck::app {

/// Which decks a call is about, so that results of different calls do not mix.
struct DeckListId {
  ContentHash hash;         ///< of the paths, in order
  std::uint64_t count = 0;  ///< decks
  friend bool operator==(const DeckListId&, const DeckListId&) = default;
};

/// What a call found in one deck.
struct DeckResult {
  std::string version;  ///< of the program
  DeckListId call;
  std::uint64_t position = 0;                 ///< in the call's list
  std::string deck;                           ///< path
  ContentHash key;                            ///< of its files and of what was asked (deck_key.hpp)
  std::vector<std::int64_t> contacts, parts;  ///< of --contact and --part
  bool failed = false;                        ///< an error was reported: never taken for a later call
  std::string unread;                         ///< why there is no report; empty: there is one
  std::vector<Diagnostic> diagnostics;        ///< as they were printed
  std::uint64_t diagnostics_left_out = 0;
  std::string report;  ///< archived (report/archive/report_archive.hpp)
};

/// The file of --results: one entry for each deck, added as soon as the deck is done. A later entry on the same deck
/// replaces the earlier one. What a killed program has left unfinished at the end is cut off.
class ResultsFile {
 public:
  /// Opens a file for further entries, or makes one. Errors: it cannot be written, another call has it open, it is
  /// something else.
  static Result<ResultsFile> open(const std::string& path);
  /// The entries of a file that is only read, in its order, without those that later ones replace. Errors: it cannot be
  /// read, or it is something else.
  static Result<std::vector<DeckResult>> read(const std::string& path);

  /// The entry on a deck; nothing: there is none.
  [[nodiscard]] std::optional<DeckResult> find(const std::string& deck) const;
  /// Adds an entry; it is on the disk when this returns.
  [[nodiscard]] Status add(const DeckResult& result);
  /// Bytes of an unfinished entry that were cut off when the file was opened.
  [[nodiscard]] std::uint64_t cut_off() const { return cut_off_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  explicit ResultsFile(std::string path) : path_(std::move(path)) {}

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  FileBytes old_;                                    ///< when it was opened
  std::map<std::string, std::string_view> entries_;  ///< bytes in old_, by deck
  std::uint64_t cut_off_ = 0;
};

}  // namespace gapcheck::app
