#pragma once
#include <algorithm>
#include <string_view>

namespace gapcheck::results {

/// True for binout, binout0000, and binout0000%001, which continues it.
[[nodiscard]] inline bool is_binout_name(std::string_view name) {
  constexpr std::string_view digits = "0123456789", begin = "binout";
  if (!name.starts_with(begin)) return false;
  const std::size_t end = std::min(name.find_first_not_of(digits, begin.size()), name.size());
  if (end == name.size()) return true;
  return name[end] == '%' && end + 1 < name.size() && name.find_first_not_of(digits, end + 1) == std::string_view::npos;
}

/// The array "version" of the binouts that gapcheck writes, where LS-DYNA has "smp d R14   ".
inline constexpr std::string_view binout_program = "gapcheck    ";

/// True if a binout with this beginning was written by gapcheck.
[[nodiscard]] inline bool has_binout_mark(std::string_view head) {
  constexpr std::string_view array = "version";
  const std::size_t at = head.find(array);
  return at != std::string_view::npos && head.substr(at + array.size()).starts_with(binout_program);
}

}  // namespace gapcheck::results
