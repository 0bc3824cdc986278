#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/file_bytes.hpp"
#include "lsp/audit_job.hpp"
#include "lsp/features/features.hpp"
#include "lsp/syntax.hpp"

namespace gapcheck::app::lsp {

/// An open document.
struct Document {
  std::string uri, path;  ///< `path`: canonical
  std::int64_t version = 0;
  std::shared_ptr<const Text> text = std::make_shared<const Text>();
  std::shared_ptr<const std::vector<Keyword>> outline = std::make_shared<const std::vector<Keyword>>();
  SyntaxCheck check{};
  std::vector<LineFault> faults{};
  bool changed = false;  ///< other than on disk
};

/// The open documents, what is known of their decks, and what was found in files.
class Workspace {
 public:
  /// Replaces a document of the same file. `uri`: of a file.
  Document& open(const std::string& uri, std::int64_t version, std::string_view text);
  void close(const std::string& uri);
  /// Whatever way the URI is spelt; nullptr: not open.
  [[nodiscard]] Document* find(const std::string& uri);
  [[nodiscard]] Document* find_path(const std::string& path);
  [[nodiscard]] const Document* find_path(const std::string& path) const;
  /// Gives a document another text and checks it.
  static void set_text(Document& document, Text text);
  /// Moves what was found in a document along with its lines: [begin, end) was replaced by a text with that many line
  /// ends.
  void move_findings(const Document& document, Place begin, Place end, std::uint32_t added);

  /// A deck that was read; documents among its files take their parameters and neighbours from it. nullptr: it cannot
  /// be read any more. Returns open documents that it had before and that have no deck now.
  std::set<std::string> set_deck(const std::string& main, std::shared_ptr<const keyword::Deck> deck);
  /// Main file of the deck that a document was last seen in; empty: none is known.
  [[nodiscard]] std::string main_of(const Document& document) const;
  /// The document and the other files of its deck. Valid as long as nothing of the workspace changes.
  [[nodiscard]] DeckFiles files(const Document& document);

  /// Takes what an audit found in place of what it found before; the paths where something changed.
  [[nodiscard]] std::set<std::string> set_findings(const std::string& main, Audited audited);
  /// What audits found in a file, each once.
  [[nodiscard]] std::vector<LineFinding> findings(const std::string& path) const;

  /// Where lines of a file can be changed: neither the editor nor another program has changed the file since it was
  /// read.
  [[nodiscard]] LinesAt changeable(const ReadFile& file, std::span<const FixedLine> lines) const;

  /// The text of every document that differs from the disk, without what other files do not need.
  [[nodiscard]] std::map<std::string, std::string> changed_texts() const;
  [[nodiscard]] std::set<std::string> open_paths() const;

 private:
  struct DiskText {
    FileStamp stamp;
    std::shared_ptr<const Text> text;
    std::shared_ptr<const std::vector<Keyword>> outline;
  };
  [[nodiscard]] FileView view(const std::string& path, const Scope& scope);

  std::map<std::string, std::unique_ptr<Document>> documents_;                       ///< by path
  std::map<std::string, std::shared_ptr<const keyword::Deck>> decks_;                ///< by main file
  std::map<std::string, std::string> main_;                                          ///< by file
  std::map<std::string, std::map<std::string, std::vector<LineFinding>>> findings_;  ///< by main file and file
  std::map<std::string, DiskText> disk_;                                             ///< by file
  std::size_t disk_bytes_ = 0;
};

}  // namespace gapcheck::app::lsp
