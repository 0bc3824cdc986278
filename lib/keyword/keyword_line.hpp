#pragma once
#include <string>
#include <string_view>

#include "keyword/deck.hpp"

namespace gapcheck::keyword {

/// What a line that starts with `*` says.
struct KeywordLine {
  std::string name;  ///< upper case, without `*` and format suffix; empty: none
  Format format = Format::standard;
};

/// Reads a keyword line without its line end. `of_file`: the format that holds where the keyword has no suffix of its
/// own; *KEYWORD changes it for the rest of its file.
[[nodiscard]] KeywordLine read_keyword_line(std::string_view line, Format& of_file);

}  // namespace gapcheck::keyword
