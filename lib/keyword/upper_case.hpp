#pragma once
#include <string>
#include <string_view>

namespace gapcheck::keyword {

/// The text with letters a to z as capitals; keywords and options are case-insensitive.
[[nodiscard]] inline std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

}  // namespace gapcheck::keyword
