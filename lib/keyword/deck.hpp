#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/ids.hpp"
#include "base/result.hpp"
#include "keyword/file_cache.hpp"
#include "keyword/parameters.hpp"
#include "keyword/transform.hpp"

namespace gapcheck::keyword {

/// Field widths: as in the manual, 8-wide fields as 10, or 20 columns each.
enum class Format : std::uint8_t { standard, i10, long_fields };

/// One keyword file, once per inclusion.
struct SourceFile {
  std::string path;        ///< as opened
  std::string_view bytes;  ///< owned by the deck
  FileIndex includer = none<FileIndex>;
  std::uint32_t include_line = 0;  ///< in the includer
  TransformIndex of_mesh{0};       ///< that of its nodes and elements
  std::shared_ptr<FileScan> kept;  ///< of a file that is kept for other decks; nullptr: it is not
};

/// One keyword with its data lines. Views stay valid as long as the deck.
struct Block {
  std::string name;       ///< upper case, without `*` and format suffix: "ELEMENT_SHELL_THICKNESS"
  std::string_view body;  ///< from the line after the keyword to the next keyword, comments included, but for template
                          ///< fields as in the file
  FileIndex file;
  std::uint32_t line = 0;  ///< of the keyword; the body starts at line + 1
  Format format = Format::standard;
  TransformIndex transform{0};  ///< of the include that brought it; 0 = none
  std::uint32_t scope = 0;      ///< parameter scope (chain of files)
  std::uint32_t order = 0;      ///< position in the input; parameters are visible from their definition on
};

/// A comment for gapcheck: `$ gapcheck: …`.
struct Directive {
  std::string text;  ///< after the colon, to the end of the line
  FileIndex file;
  std::uint32_t line = 0;
  TransformIndex transform{0};
};

struct ReadOptions {
  std::vector<std::string> include_directories;  ///< -I
  std::vector<std::string> parameters;           ///< --param: "NAME=VALUE"
  bool skip_missing_includes = false;            ///< then each is a warning
  std::uint32_t max_include_depth = 64;
  std::uint32_t max_files = 10000;
  /// How many bytes of files that were included before are read again, or ten times those of the different files.
  std::uint64_t max_repeated_bytes = 50'000'000;
  FileCache* cache = nullptr;  ///< files shared with other decks; must outlive the reading
  /// Texts to read in place of files, by path as opened; must outlive the deck.
  const std::map<std::string, std::string>* replaced = nullptr;
};

/// An include that no directory has.
struct MissingInclude {
  std::string name;  ///< as written
  FileIndex file;    ///< that names it
  std::uint32_t line = 0;
  std::int64_t written_by = 0;  ///< the *CASE before it in the deck whose run writes the file; 0: none
};

/// What was skipped on purpose, for --stats.
struct DeckCounters {
  std::uint64_t bytes = 0, files = 0, missing_includes = 0, encrypted_blocks = 0;
  std::uint64_t shared_files = 0;  ///< that the cache had before
};

/// A deck with all its includes as a list of blocks in input order. Only what the structure needs is parsed: includes,
/// parameters, transformations.
class Deck {
 public:
  [[nodiscard]] std::span<const SourceFile> files() const { return files_; }
  [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
  [[nodiscard]] const SourceFile& file(FileIndex index) const { return files_[index.value]; }
  /// By file and line; only from what is read, so not after *END.
  [[nodiscard]] std::span<const Directive> directives() const { return directives_; }
  /// Whether the main file has *END.
  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] const Transform& transform(TransformIndex index) const { return transforms_[index.value]; }
  /// The id that a file has for a node or element of the model, if *INCLUDE_AUTO_OFFSET shifted it; else 0.
  [[nodiscard]] std::int64_t id_in_file(FileIndex file, IdKind kind, std::int64_t id) const;
  [[nodiscard]] const DeckCounters& counters() const { return counters_; }
  /// In the order of reading; as many as DeckCounters::missing_includes.
  [[nodiscard]] std::span<const MissingInclude> missing_includes() const { return missing_includes_; }
  /// Frees the text of long blocks whose names `done` accepts, once nobody needs it any more: their bodies become
  /// empty, as do the bytes of their files.
  void drop_text(const std::function<bool(std::string_view name)>& done);
  /// An error if a file of the deck has been written to since it was read.
  [[nodiscard]] Status unchanged() const;

 private:
  friend class DeckReader;
  std::vector<std::shared_ptr<KeywordFile>> read_;
  std::vector<std::unique_ptr<const std::string>> texts_;  ///< decks given as text, bodies with template fields
  std::vector<SourceFile> files_;
  std::vector<Block> blocks_;
  std::vector<Directive> directives_;
  Parameters parameters_;
  std::vector<Transform> transforms_{Transform{}};
  DeckCounters counters_;
  std::vector<MissingInclude> missing_includes_;
  bool ended_ = false;
};

/// Reads a deck with its includes. Errors that stop it (main file missing, binary, empty, without a keyword) come as
/// the result's error; all others go to `diagnostics` with file and line, and reading continues, so that all are
/// reported at once.
Result<Deck> read_deck(const std::string& path, const ReadOptions& options, Diagnostics& diagnostics);

/// The same for a deck in memory; `name` replaces the file name; includes are looked up in the working directory.
Result<Deck> read_deck_text(std::string text, const std::string& name, const ReadOptions& options,
                            Diagnostics& diagnostics);

/// A fault of a --param in words; empty: none.
[[nodiscard]] std::string parameter_fault(std::string_view text);

/// A warning for every --param that the deck neither defines nor uses, once everything has been read from it.
void warn_of_unused_parameters(const Deck& deck, Diagnostics& diagnostics);

/// A note if the main file ends without *END: the solver reads it all the same, but it may have been cut.
void note_missing_end(const Deck& deck, Diagnostics& diagnostics);

}  // namespace gapcheck::keyword
