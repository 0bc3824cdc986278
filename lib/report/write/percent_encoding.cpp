#include "report/write/percent_encoding.hpp"

#include <fmt/format.h>

#include "report/write/normal_path.hpp"

namespace gapcheck::report {

std::string percent_encoded(std::string_view path) {
  std::string link;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    if (plain)
      link += c;
    else
      link += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

std::string file_uri(std::string_view path) {
  const std::string normal = normal_path(path);
  return (normal.starts_with('/') ? "file://" : "") + percent_encoded(normal);
}

}  // namespace gapcheck::report
