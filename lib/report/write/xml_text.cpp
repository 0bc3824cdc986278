#include "report/write/xml_text.hpp"

#include <algorithm>
#include <cstddef>

namespace gapcheck::report {
namespace {

bool follows(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Bytes of the character that the text starts with, not ASCII; 0 if it is not UTF-8 or not allowed in XML.
std::size_t wide_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return 0;
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), follows)) return 0;
  const bool overlong = (byte(0) == 0xe0 && byte(1) < 0xa0) || (byte(0) == 0xf0 && byte(1) < 0x90);
  const bool surrogate = byte(0) == 0xed && byte(1) >= 0xa0, beyond = byte(0) == 0xf4 && byte(1) >= 0x90;
  const bool no_character = byte(0) == 0xef && byte(1) == 0xbf && byte(2) >= 0xbe;
  return overlong || surrogate || beyond || no_character ? 0 : length;
}

std::string_view escape(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

std::string converted(std::string_view text, bool escaped) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) {
      const std::size_t length = wide_character(text.substr(i));
      out += length == 0 ? "?" : text.substr(i, length);
      i += std::max<std::size_t>(length, 1);
      continue;
    }
    const std::string_view escape_of_c = escaped ? escape(c) : std::string_view();
    const bool control = (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
    if (!escape_of_c.empty())
      out += escape_of_c;
    else
      out += control ? '?' : c;
    ++i;
  }
  return out;
}

}  // namespace

std::string xml_text(std::string_view text) { return converted(text, true); }
std::string plain_text(std::string_view text) { return converted(text, false); }

}  // namespace gapcheck::report
