#include "lsp/message.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <optional>

namespace gapcheck::app::lsp {
namespace {

constexpr std::size_t long_text = std::size_t{1} << 20;
/// Replaces a long text in the parsed message. A client that sends these words itself gets them back as its own text.
constexpr std::string_view placeholder = "\x01long text ";

/// The quote that ends the string whose first character is at `at`; npos: none.
std::size_t end_of_string(std::string_view bytes, std::size_t at) {
  for (std::size_t quote = bytes.find('"', at); quote != std::string_view::npos; quote = bytes.find('"', quote + 1)) {
    std::size_t slashes = 0;
    while (quote > at + slashes && bytes[quote - slashes - 1] == '\\') ++slashes;
    if (slashes % 2 == 0) return quote;
  }
  return std::string_view::npos;
}

void append_utf8(std::uint32_t code, std::string& text) {
  const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0 | code >> 6);
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
  } else {
    add(0xF0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3F));
    add(0x80 | (code >> 6 & 0x3F));
  }
  add(0x80 | (code & 0x3F));
}

/// Four hexadecimal digits; nothing for anything else.
std::optional<std::uint32_t> hex_code(std::string_view text, std::size_t at) {
  if (at + 4 > text.size()) return std::nullopt;
  std::uint32_t code = 0;
  const char* const end = text.data() + at + 4;
  const auto [stop, error] = std::from_chars(text.data() + at, end, code, 16);
  return error == std::errc{} && stop == end ? std::optional(code) : std::nullopt;
}

/// What "\u" and four digits stand for; nothing where there are none.
std::optional<std::uint32_t> escape_at(std::string_view text, std::size_t at) {
  const bool begins = at + 1 < text.size() && text[at] == '\\' && text[at + 1] == 'u';
  return begins ? hex_code(text, at + 2) : std::nullopt;
}

void replace_half_characters(std::string& bytes) {
  for (std::size_t at = bytes.find('\\'); at < bytes.size(); at = bytes.find('\\', at)) {
    const auto code = escape_at(bytes, at), next = escape_at(bytes, at + 6);
    if (!code || *code < 0xD800 || *code > 0xDFFF) {
      at += 2;
    } else if (*code < 0xDC00 && next && *next >= 0xDC00 && *next <= 0xDFFF) {
      at += 12;
    } else {
      bytes.replace(at + 2, 4, "fffd");
      at += 6;
    }
  }
}

/// The character that an escape stands for, appended; `at` is behind the backslash and moves behind the escape.
bool append_escape(std::string_view raw, std::size_t& at, std::string& text) {
  constexpr std::string_view letters = "\"\\/bfnrt", meant = "\"\\/\b\f\n\r\t";
  if (const std::size_t known = letters.find(raw[at]); known != std::string_view::npos) {
    text += meant[known];
    ++at;
    return true;
  }
  auto code = raw[at] == 'u' ? hex_code(raw, at + 1) : std::nullopt;
  if (!code) return false;
  at += 5;
  // Both halves are there: others have been replaced.
  if (const auto low = escape_at(raw, at); low && *code >= 0xD800 && *code < 0xDC00) {
    code = 0x10000 + ((*code - 0xD800) << 10) + (*low - 0xDC00);
    at += 6;
  }
  append_utf8(*code, text);
  return true;
}

/// What a string literal without its quotes means. Nothing: an escape that there is not.
std::optional<std::string> unescaped(std::string_view raw) {
  std::string text;
  text.reserve(raw.size());
  for (std::size_t at = 0; at < raw.size();) {
    const void* slash = std::memchr(raw.data() + at, '\\', raw.size() - at);
    const std::size_t next =
        slash == nullptr ? raw.size() : static_cast<std::size_t>(static_cast<const char*>(slash) - raw.data());
    text += raw.substr(at, next - at);
    at = next + 1;
    if (next < raw.size() && !append_escape(raw, at, text)) return std::nullopt;
  }
  return text;
}

Message wrong(std::string why) { return {json(json::value_t::discarded), std::move(why), {}}; }

}  // namespace

const std::string& Message::text(const json& member) const {
  const std::string& text = text_of(member);
  if (!text.starts_with(placeholder)) return text;
  std::size_t number = 0;
  std::from_chars(text.data() + placeholder.size(), text.data() + text.size(), number);
  return number < long_texts.size() ? long_texts[number] : text;
}

Message read_message(std::string text) {
  replace_half_characters(text);
  const std::string_view bytes = text;
  Message message;
  std::string rest;
  std::size_t depth = 0;
  for (std::size_t at = 0, kept = 0;; ++at) {
    at = bytes.find_first_of("\"{}[]", at);
    if (at == std::string_view::npos) {
      rest += bytes.substr(kept);
      break;
    }
    const char c = bytes[at];
    if ((c == '{' || c == '[') && ++depth > deepest_nesting)
      return wrong(fmt::format("lists and objects are nested more than {} deep", deepest_nesting));
    if ((c == '}' || c == ']') && depth > 0) --depth;
    if (c != '"') continue;
    const std::size_t end = end_of_string(bytes, at + 1);
    if (end == std::string_view::npos) return wrong("a text without its last quote");
    if (end - at > long_text) {
      auto meant = unescaped(bytes.substr(at + 1, end - at - 1));
      if (!meant) return wrong("a text with an escape that JSON does not have");
      rest += bytes.substr(kept, at - kept);
      rest += fmt::format("\"\\u0001{}{}\"", placeholder.substr(1), message.long_texts.size());
      message.long_texts.push_back(std::move(*meant));
      kept = end + 1;
    }
    at = end;
  }
  message.value = json::parse(rest, nullptr, false);
  if (message.value.is_discarded()) return wrong("the message is not JSON in UTF-8");
  return message;
}

}  // namespace gapcheck::app::lsp
