#pragma once
#include <string_view>

namespace gapcheck {

/// True if the pattern matches the whole path. Both are folders and a name separated by `/`; nothing is looked up or
/// normalised. In the pattern `?` is one character and `*` any number of them, but never a `/`; a folder `**` is any
/// number of folders, or none; `**` at the end is everything below. All other characters match themselves,
/// case-sensitively. Time is at most the product of both lengths, squared where there is a `**`.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view path);

}  // namespace gapcheck
