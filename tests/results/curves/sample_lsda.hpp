#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "results/curves/lsda.hpp"

namespace gapcheck::results {

/// Writes an LSDA file record by record, in any of its forms.
class SampleLsda {
 public:
  explicit SampleLsda(bool swapped = false, std::size_t length_bytes = 8, std::size_t command_bytes = 1)
      : swapped_(swapped), length_bytes_(length_bytes), command_bytes_(command_bytes) {
    const bool little = (std::endian::native == std::endian::little) != swapped;
    for (const std::size_t byte : {std::size_t{8}, length_bytes, std::size_t{8}, command_bytes, std::size_t{1},
                                   std::size_t{little}, std::size_t{0}, std::size_t{0}})
      bytes.push_back(static_cast<char>(byte));
  }

  void change(const std::string& way) { record(2, way); }
  template <class T>
  void array(const std::string& name, LsdaArray::Type type, const std::vector<T>& values) {
    std::string data{static_cast<char>(type), static_cast<char>(name.size())};
    data += name;
    for (const T& value : values) data += raw(value, sizeof(T));
    record(3, data);
  }
  void record(std::uint64_t command, const std::string& data) {
    bytes += raw(static_cast<std::uint64_t>(length_bytes_ + command_bytes_ + data.size()), length_bytes_);
    bytes += raw(command, command_bytes_) + data;
  }

  std::string bytes;

 private:
  /// The `size` low bytes of an integer, or all of a number, in the file's order.
  template <class T>
  std::string raw(T value, std::size_t size) const {
    std::string text(sizeof(T), '\0');
    std::memcpy(text.data(), &value, sizeof(T));
    text.resize(size);  // this machine has the lowest byte first
    if (swapped_) std::reverse(text.begin(), text.end());
    return text;
  }

  bool swapped_;
  std::size_t length_bytes_, command_bytes_;
};

static_assert(std::endian::native == std::endian::little, "SampleLsda::raw");

}  // namespace gapcheck::results
