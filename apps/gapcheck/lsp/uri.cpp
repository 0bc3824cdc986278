#include "lsp/uri.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace gapcheck::app::lsp {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

bool unreserved(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("/-._~").find(c) != std::string_view::npos;
}

}  // namespace

std::string path_of(std::string_view uri) {
  constexpr std::string_view scheme = "file://", local = "localhost";
  if (!uri.starts_with(scheme)) return {};
  uri.remove_prefix(scheme.size());
  if (uri.starts_with(local)) uri.remove_prefix(local.size());
  if (!uri.starts_with('/')) return {};
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
    path += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
    if (low >= 0) i += 2;
  }
  if (path.find('\0') != std::string::npos) return {};
  // Where drives have letters, "/C:/a" is C:/a.
  if (path.size() > 2 && std::filesystem::path(path.substr(1)).has_root_name()) path.erase(0, 1);
  return path;
}

std::string uri_of(const std::string& path) {
  std::error_code failed;
  const std::filesystem::path place = std::filesystem::absolute(path, failed).lexically_normal();
  std::string uri = place.has_root_name() ? "file:///" : "file://";
  for (const char c : place.generic_string())
    uri += unreserved(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return uri;
}

std::string canonical(const std::string& path) {
  std::error_code failed;
  const auto found = std::filesystem::weakly_canonical(std::filesystem::absolute(path, failed), failed);
  return failed ? std::filesystem::path(path).lexically_normal().generic_string() : found.generic_string();
}

}  // namespace gapcheck::app::lsp
