#include "report/write/harmless.hpp"

#include <algorithm>
#include <array>

namespace gapcheck::report {
namespace {

unsigned char byte_of(char c) { return static_cast<unsigned char>(c); }

bool follows(char c) { return (byte_of(c) & 0xc0) == 0x80; }

/// Line separators and marks of direction: they let one line look like others.
bool rearranges(std::string_view character) {
  // NOLINTBEGIN(misc-misleading-bidirectional): these are the characters meant
  constexpr std::array<std::string_view, 11> all{"\u2028", "\u2029", "\u202a", "\u202b", "\u202c", "\u202d",
                                                 "\u202e", "\u2066", "\u2067", "\u2068", "\u2069"};
  // NOLINTEND(misc-misleading-bidirectional)
  return std::find(all.begin(), all.end(), character) != all.end();
}

/// Where a line begins, behind blanks, which the services skip.
std::string_view behind_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

constexpr std::string_view command_of_a_line = "::";

void disarm_commands(std::string& text) {
  if (const std::string_view line = behind_blanks(text); line.starts_with(command_of_a_line))
    text[text.size() - line.size()] = '?';
  constexpr std::array<std::string_view, 2> anywhere{"##[", "##vso["};
  for (const std::string_view command : anywhere)
    for (std::size_t at = text.find(command); at != std::string::npos; at = text.find(command, at + 1)) text[at] = '?';
}

}  // namespace

std::size_t wide_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return byte_of(text[i]); };
  const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return 0;
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), follows)) return 0;
  const bool overlong = (byte(0) == 0xe0 && byte(1) < 0xa0) || (byte(0) == 0xf0 && byte(1) < 0x90);
  const bool surrogate = byte(0) == 0xed && byte(1) >= 0xa0, beyond = byte(0) == 0xf4 && byte(1) >= 0x90;
  const bool no_character = byte(0) == 0xef && byte(1) == 0xbf && byte(2) >= 0xbe;
  return overlong || surrogate || beyond || no_character ? 0 : length;
}

bool is_wide_control(std::string_view character) {
  return character.size() == 2 && byte_of(character[0]) == 0xc2 && byte_of(character[1]) < 0xa0;
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const unsigned char first = byte_of(text.front());
    const std::size_t length = first < 0x80 ? 1 : std::max<std::size_t>(1, wide_character(text));
    const std::string_view character = text.substr(0, length);
    // Outside of UTF-8 the bytes 0x80 to 0x9f are the same controls; other bytes may be letters of another encoding.
    const bool control = length == 1 && (first < 0x20 || (first >= 0x7f && first < 0xa0));
    if (control || is_wide_control(character) || rearranges(character))
      result += '?';
    else
      result += character;
    text.remove_prefix(length);
  }
  disarm_commands(result);
  return result;
}

std::string harmless_path(std::string_view path) {
  const bool formula = !path.empty() && std::string_view("=+-@\t\r").find(path.front()) != std::string_view::npos;
  const bool command = behind_blanks(path).starts_with(command_of_a_line);
  return (formula || command ? "./" : "") + std::string(path);
}

std::string printable_path(std::string_view path) { return printable(harmless_path(path)); }

}  // namespace gapcheck::report
