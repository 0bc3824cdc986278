#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/deck_files.hpp"

namespace gapcheck::app {

/// --shard K/N: the K-th of N shares of the decks of a call.
struct Shard {
  std::size_t number = 1, count = 1;  ///< from 1
  [[nodiscard]] bool whole() const { return count == 1; }
};

/// Reads "K/N", 1 <= K <= N <= 100000. Nothing for anything else.
[[nodiscard]] std::optional<Shard> read_shard(std::string_view text);
/// The same for an option: what is wrong, or empty.
[[nodiscard]] std::string check_shard(const std::string& text);

/// Which of the sizes belong to a share, ascending positions: the largest first, each to the share that has least so
/// far; of equal ones the first. Every position is in exactly one share.
[[nodiscard]] std::vector<std::size_t> share_of(const std::vector<std::uint64_t>& sizes, const Shard& shard);

/// Bytes of all files of each deck; 0 for files that cannot be read.
[[nodiscard]] std::vector<std::uint64_t> sizes_of(const std::vector<std::string>& decks, DeckFiles& files);

}  // namespace gapcheck::app
