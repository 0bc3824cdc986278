#include "report/write/xml_text.hpp"

#include <algorithm>
#include <cstddef>

#include "report/write/harmless.hpp"

namespace gapcheck::report {
namespace {

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
      const std::string_view character = text.substr(i, length);
      out += length == 0 || is_wide_control(character) ? "?" : character;
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
std::string xml_attribute(std::string_view text) {
  std::string out;
  for (const char c : xml_text(text)) {
    if (c == '\n' || c == '\t')
      out += c == '\n' ? "&#10;" : "&#9;";
    else
      out += c;
  }
  return out;
}

std::string plain_text(std::string_view text) {
  const auto plain = [](char c) { return c >= ' ' && c < '\x7f'; };
  return std::all_of(text.begin(), text.end(), plain) ? std::string(text) : converted(text, false);
}

}  // namespace gapcheck::report
