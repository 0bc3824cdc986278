#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "lsp/text.hpp"

namespace gapcheck::app::lsp {

/// A keyword of a text and its lines; numbers from 0.
struct Keyword {
  std::string name;  ///< upper case, without `*` and format suffix
  keyword::Format format = keyword::Format::standard;
  std::uint32_t line = 0;  ///< of the keyword
  std::uint32_t end = 0;   ///< behind the last of its lines
};

/// The keywords of a text up to *END, in order.
[[nodiscard]] std::vector<Keyword> outline(const Text& text);

/// The keyword that a line belongs to; nullptr: none.
[[nodiscard]] const Keyword* keyword_at(std::span<const Keyword> outline, std::uint32_t line);

/// Nodes and elements: the blocks that can be huge.
[[nodiscard]] bool is_mesh(const Keyword& keyword);

}  // namespace gapcheck::app::lsp
