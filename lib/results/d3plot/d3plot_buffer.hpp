#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>

namespace gapcheck::results {

/// A row of words of 4 or 8 bytes in this machine's byte order.
class WordBuffer {
 public:
  explicit WordBuffer(int word_bytes) : bytes_(static_cast<std::size_t>(word_bytes)) {}

  void integer(std::int64_t value) {
    if (bytes_ == 8)
      put(value);
    else
      put(static_cast<std::int32_t>(value));
  }
  void integers(std::initializer_list<std::int64_t> values) {
    for (const std::int64_t value : values) integer(value);
  }
  /// In words of 4 bytes, numbers beyond the range are clipped.
  void real(double value) {
    constexpr double most = std::numeric_limits<float>::max();
    if (bytes_ == 8)
      put(value);
    else
      put(static_cast<float>(std::isnan(value) ? value : std::clamp(value, -most, most)));
  }
  template <class Values>
  void reals(const Values& values) {
    for (const double value : values) real(value);
  }
  void zeros(std::uint64_t words) { text_.append(words * bytes_, '\0'); }
  /// Text in `bytes` bytes, a multiple of the word.
  void text(std::string_view text, std::size_t bytes) {
    std::string filled(text.substr(0, bytes));
    filled.resize(bytes, ' ');
    text_ += filled;
  }
  /// Pads with zeros to whole blocks of `block` words.
  void pad(std::uint64_t block) {
    if (const std::uint64_t rest = words() % block; rest != 0) zeros(block - rest);
  }
  [[nodiscard]] std::uint64_t words() const { return text_.size() / bytes_; }
  [[nodiscard]] std::string_view bytes() const { return text_; }

 private:
  template <class Value>
  void put(Value value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    text_.append(bytes, sizeof value);
  }

  std::size_t bytes_;
  std::string text_;
};

}  // namespace gapcheck::results
