#include "campaign/shard.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <numeric>
#include <queue>
#include <system_error>
#include <utility>

namespace gapcheck::app {
namespace {

constexpr std::size_t most_shares = 100'000;

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::uint64_t size_of(const std::string& file) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  return failed ? 0 : size;
}

}  // namespace

std::optional<Shard> read_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto number = whole_number(text.substr(0, slash)), count = whole_number(text.substr(slash + 1));
  if (!number || !count || *number == 0 || *number > *count || *count > most_shares) return std::nullopt;
  return Shard{*number, *count};
}

std::string check_shard(const std::string& text) {
  return read_shard(text) ? "" : "'" + text + "' is not a share; write K/N: 3/8 is the third of eight";
}

std::vector<std::size_t> share_of(const std::vector<std::uint64_t>& sizes, const Shard& shard) {
  std::vector<std::size_t> largest_first(sizes.size());
  std::iota(largest_first.begin(), largest_first.end(), std::size_t{0});
  std::ranges::stable_sort(largest_first, std::greater(), [&](std::size_t i) { return sizes[i]; });
  // What each share has so far, with its number; the least one on top.
  using Load = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (std::size_t number = 1; number <= std::min(shard.count, sizes.size()); ++number) loads.emplace(0, number);
  std::vector<std::size_t> own;
  for (const std::size_t i : largest_first) {
    const auto [load, number] = loads.top();
    loads.pop();
    // Decks of no size count too, or all of them would go to one share.
    loads.emplace(load + std::max<std::uint64_t>(sizes[i], 1), number);
    if (number == shard.number) own.push_back(i);
  }
  std::ranges::sort(own);
  return own;
}

std::vector<std::uint64_t> sizes_of(const std::vector<std::string>& decks, DeckFiles& files) {
  std::vector<std::uint64_t> sizes;
  for (const std::string& deck : decks) {
    std::uint64_t size = size_of(deck);
    for (const std::string& include : files.includes(deck)) size += size_of(include);
    sizes.push_back(size);
  }
  return sizes;
}

}  // namespace gapcheck::app
