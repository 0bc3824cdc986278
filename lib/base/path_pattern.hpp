#pragma once
#include <string_view>

namespace gapcheck {

/// True if the whole path is what the pattern describes. Both are folders and a name with `/` between them; nothing is
/// looked up and nothing is made normal. In the pattern `?` is one character and `*` any number of them, but never a
/// `/`; a folder `**` is any number of folders, also none; `**` at the end is all that lies below. All other characters
/// stand for themselves, case counts. Time is at most the product of both lengths, squared where there is a `**`.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view path);

}  // namespace gapcheck
