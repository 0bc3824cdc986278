#pragma once
#include <span>
#include <string_view>

namespace gapcheck::embedded {

/// A text file that was compiled in (see cmake/embed.cmake).
struct Text {
  std::string_view name;  ///< base name of the file
  std::string_view content;
};

}  // namespace gapcheck::embedded
