#pragma once
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "records/baseline.hpp"

namespace gapcheck::report {

using Buffer = fmt::memory_buffer;

/// A JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_string(std::string_view text);

/// Appends members of objects to a buffer; every call except the first of an object writes a comma first.
class Members {
 public:
  explicit Members(Buffer& out) : out_(out) { out_.push_back('{'); }
  void close() { out_.push_back('}'); }

  void key(std::string_view name) {
    if (!first_) out_.push_back(',');
    first_ = false;
    out_.push_back('"');
    out_.append(name);
    out_.append(std::string_view("\":"));
  }
  /// `text` needs no escapes.
  void plain(std::string_view name, std::string_view text) {
    key(name);
    out_.push_back('"');
    out_.append(text);
    out_.push_back('"');
  }
  void string(std::string_view name, std::string_view text) { raw(name, json_string(text)); }
  void raw(std::string_view name, std::string_view json) {
    key(name);
    out_.append(json);
  }
  /// An object, whose members `fill` appends.
  template <class Fill>
  void object(std::string_view name, const Fill& fill) {
    key(name);
    Members members(out_);
    fill(members);
    members.close();
  }
  template <class Integer>
  void integer(std::string_view name, Integer value) {
    key(name);
    fmt::format_to(fmt::appender(out_), FMT_COMPILE("{}"), value);
  }
  void number(std::string_view name, double value) {
    key(name);
    append_number(value);
  }
  /// An array of numbers or integers.
  template <class Range>
  void array(std::string_view name, const Range& values) {
    key(name);
    char separator = '[';
    for (const auto value : values) {
      out_.push_back(separator);
      if constexpr (std::is_floating_point_v<std::remove_const_t<decltype(value)>>)
        append_number(value);
      else
        fmt::format_to(fmt::appender(out_), FMT_COMPILE("{}"), value);
      separator = ',';
    }
    out_.push_back(']');
  }
  void fingerprint(std::uint64_t value, std::string_view name = "fingerprint") {
    key(name);
    fmt::format_to(fmt::appender(out_), FMT_COMPILE("\"{:016x}\""), value);
  }

 private:
  /// Shortest text that reads back as the same number; JSON has no infinity.
  void append_number(double value) {
    if (std::isfinite(value))
      fmt::format_to(fmt::appender(out_), FMT_COMPILE("{}"), value);
    else
      out_.append(std::string_view("null"));
  }

  Buffer& out_;
  bool first_ = true;
};

/// "baseline": "new", if there is one.
inline void append_state(std::optional<BaselineState> state, Members& object) {
  if (state) object.plain("baseline", name(*state));
}

}  // namespace gapcheck::report
