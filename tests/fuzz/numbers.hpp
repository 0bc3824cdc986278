#pragma once
#include <cstdint>
#include <cstring>
#include <string_view>

#include "base/vector.hpp"

namespace gapcheck::fuzz {

/// Numbers out of bytes: small whole ones, halves and thirds, that often meet exactly, and any double.
class Numbers {
 public:
  explicit Numbers(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] bool left() const { return !bytes_.empty(); }
  /// 0 where there are none left.
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto first = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return first;
  }
  double number() {
    const std::uint8_t kind = byte();
    const auto whole = static_cast<double>(static_cast<std::int8_t>(byte()));
    switch (kind % 8) {
      case 0:
        return whole * 0.5;
      case 1:
        return whole / 3;
      case 2:
        return whole * 1e-9;
      case 3:
        return whole * 1e9;
      case 4:
        return any();
      default:
        return whole;
    }
  }
  Vector vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  double any() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  std::string_view bytes_;
};

}  // namespace gapcheck::fuzz
