#pragma once
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "records/baseline.hpp"
#include "report/write/short_decimal.hpp"

namespace gapcheck::report {

using Buffer = fmt::memory_buffer;

/// A JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_string(std::string_view text);
void append_json_string(std::string_view text, Buffer& out);

/// Room for the longest number.
inline constexpr std::size_t number_room = 32;

/// Appends what `write` puts behind the pointer that it gets; it returns the end, at most `room` further. Much quicker
/// than byte by byte.
template <class Write>
[[gnu::always_inline]] inline void append_by(std::size_t room, Buffer& out, const Write& write) {
  const std::size_t size = out.size();
  out.resize(size + room);
  out.resize(static_cast<std::size_t>(write(out.data() + size) - out.data()));
}

/// The shortest text that reads back as the same number.
template <class Number>
void append_number(Number value, Buffer& out) {
  append_by(number_room, out, [value](char* end) {
    if constexpr (std::is_same_v<Number, double>)
      if (char* shorter = write_short_decimal(value, end)) return shorter;
    return fmt::format_to(end, FMT_COMPILE("{}"), value);
  });
}

/// Text that needs no escapes, in quotes.
inline void append_quoted(std::string_view text, Buffer& out) {
  append_by(text.size() + 2, out, [text](char* end) {
    *end++ = '"';
    std::memcpy(end, text.data(), text.size());
    end += text.size();
    *end++ = '"';
    return end;
  });
}

/// Appends members of objects to a buffer; every call except the first of an object writes a comma first.
class Members {
 public:
  explicit Members(Buffer& out) : out_(out) { out_.push_back('{'); }
  void close() { out_.push_back('}'); }

  void key(std::string_view name) {
    constexpr std::size_t marks = 4;
    append_by(name.size() + marks, out_, [&](char* end) {
      if (!first_) *end++ = ',';
      *end++ = '"';
      std::memcpy(end, name.data(), name.size());
      end += name.size();
      *end++ = '"';
      *end++ = ':';
      return end;
    });
    first_ = false;
  }
  /// `text` needs no escapes.
  void plain(std::string_view name, std::string_view text) {
    key(name);
    append_quoted(text, out_);
  }
  void string(std::string_view name, std::string_view text) {
    key(name);
    append_json_string(text, out_);
  }
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
    append_number(value, out_);
  }
  void number(std::string_view name, double value) {
    key(name);
    finite_number(value);
  }
  /// An array of numbers or integers.
  template <class Range>
  void array(std::string_view name, const Range& values) {
    key(name);
    char separator = '[';
    for (const auto value : values) {
      out_.push_back(separator);
      if constexpr (std::is_floating_point_v<std::remove_const_t<decltype(value)>>)
        finite_number(value);
      else
        append_number(value, out_);
      separator = ',';
    }
    out_.push_back(']');
  }
  void fingerprint(std::uint64_t value, std::string_view name = "fingerprint") {
    key(name);
    append_by(number_room, out_, [value](char* end) { return fmt::format_to(end, FMT_COMPILE("\"{:016x}\""), value); });
  }

 private:
  /// JSON has no infinity.
  void finite_number(double value) {
    if (std::isfinite(value))
      append_number(value, out_);
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
