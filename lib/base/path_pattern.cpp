#include "base/path_pattern.hpp"

#include <cstddef>
#include <vector>

namespace gapcheck {
namespace {

constexpr std::string_view any_folders = "**";

std::vector<std::string_view> split(std::string_view path) {
  std::vector<std::string_view> names;
  for (;;) {
    const std::size_t slash = path.find('/');
    names.push_back(path.substr(0, slash));
    if (slash == std::string_view::npos) return names;
    path.remove_prefix(slash + 1);
  }
}

/// Bytes of the UTF-8 character at `at`; of a broken one, one.
std::size_t character_size(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  if (static_cast<unsigned char>(text[at]) >= 0xC0)
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
  return end - at;
}

/// How much of the text the item of the pattern matches; 0: no match.
std::size_t taken(std::string_view pattern, std::size_t item, std::string_view text, std::size_t at) {
  if (pattern[item] == '?') return character_size(text, at);
  return pattern[item] == text[at] ? 1 : 0;
}

std::size_t taken(const std::vector<std::string_view>& pattern, std::size_t item,
                  const std::vector<std::string_view>& text, std::size_t at);

bool is_star(std::string_view pattern, std::size_t item) { return pattern[item] == '*'; }
bool is_star(const std::vector<std::string_view>& pattern, std::size_t item) { return pattern[item] == any_folders; }

/// Matches items against a text; stars match any run. Only the last star is ever tried with a longer run: everything
/// before it was matched as early as possible, so a longer run there gains nothing.
template <class Sequence>
bool match(const Sequence& pattern, const Sequence& text) {
  constexpr auto none = static_cast<std::size_t>(-1);
  std::size_t item = 0, at = 0, star = none, behind_run = 0;
  while (at < text.size()) {
    if (item < pattern.size() && is_star(pattern, item)) {
      star = item++;
      behind_run = at;
    } else if (const std::size_t n = item < pattern.size() ? taken(pattern, item, text, at) : 0; n > 0) {
      ++item;
      at += n;
    } else if (star != none) {
      item = star + 1;
      at = ++behind_run;
    } else {
      return false;
    }
  }
  while (item < pattern.size() && is_star(pattern, item)) ++item;
  return item == pattern.size();
}

std::size_t taken(const std::vector<std::string_view>& pattern, std::size_t item,
                  const std::vector<std::string_view>& text, std::size_t at) {
  return match(pattern[item], text[at]) ? 1 : 0;
}

}  // namespace

bool matches(std::string_view pattern, std::string_view path) {
  std::vector<std::string_view> names = split(pattern);
  if (names.back() == any_folders) names.emplace_back("*");
  return match(names, split(path));
}

}  // namespace gapcheck
