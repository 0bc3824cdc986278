#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lsp/position.hpp"

namespace gapcheck::app::lsp {

/// How deep lists and objects of a message may be in one another.
inline constexpr std::size_t deepest_nesting = 100;

/// A message of JSON-RPC. Its long texts, which are whole decks, are kept beside the other values.
struct Message {
  json value;  ///< discarded: `wrong` says why
  std::string wrong;
  std::vector<std::string> long_texts;
  /// A text of the message, long or short; empty for anything else.
  [[nodiscard]] const std::string& text(const json& member) const;
};

/// Reads a message; anything may be in the bytes. Texts of a megabyte and more are taken out before the rest is parsed.
/// Half a character of UTF-16, "\ud800" without the other half, is read as U+FFFD: in the editor both are one unit.
[[nodiscard]] Message read_message(std::string bytes);

}  // namespace gapcheck::app::lsp
