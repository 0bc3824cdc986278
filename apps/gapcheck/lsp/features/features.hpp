#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/repair/finding_repairs.hpp"
#include "base/diagnostic.hpp"
#include "base/file_bytes.hpp"
#include "lsp/position.hpp"
#include "lsp/scope.hpp"
#include "lsp/symbols.hpp"

namespace gapcheck::app::lsp {

// What the server answers: functions of the files of a deck and a place in one of them, one source file per feature.
// The JSON is that of the protocol; null where there is nothing to say.

/// A deck, and how the client counts characters.
struct Question {
  const DeckFiles& deck;
  Encoding encoding = Encoding::utf16;
  [[nodiscard]] const FileView& file() const { return deck.own; }
  [[nodiscard]] const Text& text() const { return *deck.own.text; }
};

/// What a field is: its name, columns, value and what it names; or what a keyword is.
[[nodiscard]] json hover(const Question& question, Place place);

/// Keywords and their options behind `*`.
[[nodiscard]] json completion(const Question& question, Place place);

/// Where the thing at a place is defined; the file that an include names.
[[nodiscard]] json definition(const Question& question, Place place);
/// All places that name the thing at a place, but lines of nodes and elements.
[[nodiscard]] json references(const Question& question, Place place, bool with_definition);
/// The file that an include's line names, by the deck that was read; empty: none.
[[nodiscard]] std::string included_file(const FileView& file, std::uint32_t line);

/// The range and the text of an id or parameter that can get another name.
[[nodiscard]] json prepare_rename(const Question& question, Place place);
/// The edits, or why there are none. Nodes and elements are searched too.
[[nodiscard]] Result<json> rename(const Question& question, Place place, const std::string& name);

/// The outline: keywords, and what they define.
[[nodiscard]] json document_symbols(const Question& question);
[[nodiscard]] json folding_ranges(const Question& question);

/// Cards in the lines [first, behind) written into their columns, texts and numbers as they are.
[[nodiscard]] json format_lines(const Question& question, std::uint32_t first, std::uint32_t behind);

/// Something that was found in a line.
struct LineFinding {
  std::uint32_t line = 0;  ///< from 0
  Severity severity = Severity::warning;
  std::string code{};  ///< id of a rule; empty: none
  std::string message;
  std::int64_t contact = 0, node = 0, part = 0, element = 0;  ///< ids; 0: none
  bool penetrates = false;                                    ///< what `gapcheck fix` is for
  bool known = false;                                         ///< equally bad in the baseline
  std::optional<audit::RepairTarget> repair{};                ///< what repairs of cards are about
};
/// What can be done about what was found in the lines [first, behind).
[[nodiscard]] json code_actions(const Question& question, const std::vector<LineFinding>& findings, std::uint32_t first,
                                std::uint32_t behind);

/// A file as it was when its deck was read.
struct ReadFile {
  std::string path;  ///< canonical
  FileStamp stamp;
};
/// Where lines of a file can be changed.
struct LinesAt {
  std::string uri;    ///< empty: they cannot, because the file has changed
  bool open = false;  ///< the client has its text
};
using ChangeableFile = std::function<LinesAt(const ReadFile& file, std::span<const FixedLine> lines)>;
struct DeckRepairs;
/// The repairs of cards for what was found in the lines [first, behind): those whose files are as they were.
[[nodiscard]] json repair_actions(const Question& question, const std::vector<LineFinding>& findings,
                                  std::uint32_t first, std::uint32_t behind, const DeckRepairs& repairs,
                                  const ChangeableFile& changeable);

// Shared by features.

/// {uri, range} of an occurrence.
[[nodiscard]] json location_of(const FileView& file, const Occurrence& at, Encoding encoding);
/// The first definition of a symbol in the deck.
struct FoundDefinition {
  FileView file;
  Occurrence at;
  std::string title;
};
[[nodiscard]] std::optional<FoundDefinition> find_definition(const DeckFiles& deck, const Symbol& symbol);

}  // namespace gapcheck::app::lsp
