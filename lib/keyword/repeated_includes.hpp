#pragma once
#include <cstdint>
#include <string>
#include <unordered_set>

namespace gapcheck::keyword {

/// Bounds the bytes of files that one deck includes again and again: small files can become gigabytes that way.
class RepeatedIncludes {
 public:
  /// Why a file is not read once more; empty: it may be. `canonical` identifies it, `read`: bytes of the deck so far,
  /// `most`: bytes that may be read again in any case (ReadOptions::max_repeated_bytes).
  [[nodiscard]] std::string reason_against(const std::string& canonical, std::uint64_t read, std::uint64_t most);
  [[nodiscard]] bool exceeded() const { return exceeded_; }

 private:
  std::unordered_set<std::string> names_;
  std::uint64_t repeated_ = 0;  ///< bytes
  bool exceeded_ = false;
};

}  // namespace gapcheck::keyword
