#pragma once
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "report/write/base64.hpp"

namespace gapcheck::report {

/// Numbers beyond 2^53 become texts: a browser would round them.
inline std::string id_text(std::int64_t id) {
  constexpr std::int64_t largest = std::int64_t{1} << 53;
  return id > largest || id < -largest ? fmt::format("\"{}\"", id) : fmt::format("{}", id);
}

/// An array with the result of `text` for each element.
template <class Range, class Text>
std::string json_array(const Range& range, const Text& text) {
  std::string out = "[";
  for (const auto& element : range) {
    if (out.size() > 1) out += ',';
    out += text(element);
  }
  return out + "]";
}

/// Numbers of four bytes.
template <class Number>
std::string binary(std::span<const Number> values) {
  static_assert(sizeof(Number) == 4 && std::endian::native == std::endian::little);
  std::string out = "\"";
  append_base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number)}, out);
  return out + '"';
}

template <class Number, std::size_t N>
std::string binary(const std::vector<std::array<Number, N>>& rows) {
  return binary(std::span<const Number>(rows.empty() ? nullptr : rows.front().data(), rows.size() * N));
}

}  // namespace gapcheck::report
