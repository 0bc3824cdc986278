#pragma once
#include <cstdint>

namespace gapcheck::bench {

/// Number `number` of a fixed sequence of shares in [0, 1) that look drawn at random: the same on every machine. The
/// mixing is the finaliser of SplitMix64 (Steele, Lea and Flood, 2014).
[[nodiscard]] inline double random_share(std::uint64_t number) {
  std::uint64_t z = (number + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ z >> 27) * 0x94D049BB133111EBULL;
  return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
}

}  // namespace gapcheck::bench
