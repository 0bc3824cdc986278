#include "base/nearest_name.hpp"

#include <algorithm>

#include "base/edit_distance.hpp"

namespace gapcheck {
namespace {

constexpr std::size_t longest = 64;  // time is the product of both lengths

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

double replace(char written, char meant) {
  const char a = lower(written), b = lower(meant);
  return a == b ? 0 : (a == '_' && b == '-') ? 0.5 : 1;
}

}  // namespace

std::string_view nearest_name(std::string_view written, std::span<const std::string_view> names) {
  const std::string_view word = written.substr(0, longest);
  const double allowed = std::max(2.0, static_cast<double>(word.size()) / 3) + 0.5;
  std::string_view best;
  double least = allowed;
  for (const std::string_view name : names) {
    const double cost = edit_distance(word, name.substr(0, longest), replace);
    if (cost < std::min(least, static_cast<double>(name.size()))) least = cost, best = name;
  }
  return best;
}

std::string did_you_mean(std::string_view name) {
  return name.empty() ? std::string() : "; did you mean " + std::string(name) + "?";
}

}  // namespace gapcheck
