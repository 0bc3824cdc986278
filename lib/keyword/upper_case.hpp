#pragma once
#include <string>
#include <string_view>

namespace gapcheck::keyword {

/// The text with its letters a to z as capitals; keywords and options count the same in either case.
[[nodiscard]] inline std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

}  // namespace gapcheck::keyword
