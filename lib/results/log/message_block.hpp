#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "results/text/lines.hpp"

namespace gapcheck::results {

/// One `*** Warning` or `*** Error` block. Views into the text behind the lines.
struct MessageBlock {
  Severity severity = Severity::warning;
  std::int64_t code = 0;                ///< 0: the header has none
  std::string_view group;               ///< "SOL" of (SOL+565)
  std::vector<std::string_view> lines;  ///< trimmed text; first what the header says beyond the number
  std::size_t left_out = 0;             ///< lines beyond those kept
  std::uint32_t line = 0;               ///< of the header
  bool header_text = false;             ///< lines[0] is of the header's line
  bool ends_file = false;               ///< nothing comes after it
  bool open = false;                    ///< ends_file, and its last line has no line end
  /// Line number of lines[i].
  [[nodiscard]] std::uint32_t line_of(std::size_t i) const;
};

/// "label = value" of a text line, without leading and trailing blanks.
struct Field {
  std::string_view label, value;
};

[[nodiscard]] bool is_message_header(std::string_view line);

/// Reads the block whose header is the current line; leaves the lines at the first one after it. The block's memory is
/// reused.
void read_message_block(Lines& lines, MessageBlock& block);

/// Nothing for a line without `=`.
[[nodiscard]] std::optional<Field> field(std::string_view line);

/// The fields of a line; joined texts have several: "tied interface # = 92 tracked node # = 1". The text between a
/// field's numbers and the next `=` is the next label.
[[nodiscard]] std::vector<Field> fields(std::string_view line);

/// The block's lines with one blank between words; cut after `limit` bytes, with a mark.
[[nodiscard]] std::string joined_text(const MessageBlock& block, std::size_t limit);

/// Equal texts have equal values, regardless of blanks and line breaks.
[[nodiscard]] std::uint64_t text_hash(const MessageBlock& block);

}  // namespace gapcheck::results
