#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "lsp/text.hpp"

namespace gapcheck::app::lsp {

using nlohmann::json;

/// How a client counts the characters of a line: units of UTF-16, or bytes where it offers UTF-8.
enum class Encoding : std::uint8_t { utf16, utf8 };

/// The byte of a line where a number of the client's units ends; at most the line's length. A position inside a
/// character means its start. Bytes that are not UTF-8 count as one unit each.
[[nodiscard]] std::size_t byte_at(std::string_view line, std::size_t units, Encoding encoding);
/// The client's units before a byte.
[[nodiscard]] std::size_t units_before(std::string_view line, std::size_t byte, Encoding encoding);

/// From a position of the protocol; places beyond the text are its end. False: it is none.
[[nodiscard]] bool read_place(const json& position, const Text& text, Encoding encoding, Place& place);
/// A range in one line.
[[nodiscard]] json range_in(std::string_view line, std::uint32_t number, std::size_t begin, std::size_t end,
                            Encoding encoding);
/// From the start of a line to the start of another one.
[[nodiscard]] json lines_range(std::uint32_t first, std::uint32_t behind);

/// A line with another text in its place.
struct FixedLine {
  std::uint32_t line = 0;  ///< from 0
  std::string before, after;
};
/// The edits of lines, each as a whole. `open`: the client has the file as text; otherwise it may count the characters
/// of a line in another way.
[[nodiscard]] json line_edits(std::span<const FixedLine> lines, Encoding encoding, bool open);

// Members of what a client sends; it may send anything.

/// The member at a path; null where there is none.
[[nodiscard]] const json& member(const json& value, std::initializer_list<const char*> path);
/// A text; empty for anything else.
[[nodiscard]] const std::string& text_of(const json& value);
[[nodiscard]] bool is_true(const json& value);
/// A whole number from 0 on; `otherwise` for anything else. Larger ones are the largest of 32 bits.
[[nodiscard]] std::uint32_t count_of(const json& value, std::uint32_t otherwise = 0);

}  // namespace gapcheck::app::lsp
