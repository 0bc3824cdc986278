#include "keyword/repeated_includes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace gapcheck::keyword {
namespace {

/// Repeating small parts of a large deck is no mistake.
constexpr std::uint64_t repeat_share = 10;

}  // namespace

std::string RepeatedIncludes::reason_against(const std::string& canonical, std::uint64_t read, std::uint64_t most) {
  if (names_.insert(canonical).second) return "";
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(canonical, error);
  if (error) return "";  // opening it says why
  const std::uint64_t different = read - std::min(read, repeated_), bound = std::max(most, repeat_share * different);
  if (size <= bound - std::min(bound, repeated_)) {
    repeated_ += size;
    return "";
  }
  exceeded_ = true;
  const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) / 1e6; };
  return fmt::format(
      "the includes repeat files: {:.1f} MB of different files have become {:.1f} MB, and at most {:.3g} MB are read "
      "again; nothing more was read; include each file once",
      megabytes(different), megabytes(read), megabytes(bound));
}

}  // namespace gapcheck::keyword
