#pragma once
#include <cstdint>
#include <string_view>

namespace gapcheck::app {

/// 128 bits that change when the content does (XXH3: against accidents, not against an adversary).
struct ContentHash {
  std::uint64_t low = 0, high = 0;
  friend bool operator==(const ContentHash&, const ContentHash&) = default;
};

[[nodiscard]] ContentHash hash_of(std::string_view bytes);

}  // namespace gapcheck::app
