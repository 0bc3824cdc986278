#pragma once
#include <cstddef>
#include <string_view>

#include "report/write/json_members.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {

/// A buffered piece of output; passes it on when it is large enough.
class Stream {
 public:
  explicit Stream(const Sink& sink) : sink_(sink) { buffer.reserve(limit + limit / 16); }
  void text(std::string_view text) { buffer.append(text); }
  /// Between the lines of a list in JSON; also passes on the buffer.
  void separator(bool first) {
    text(first ? "\n  " : ",\n  ");
    pause();
  }
  /// Passes on the buffer if it is large.
  void pause() {
    if (buffer.size() >= limit) flush();
  }
  void flush() {
    if (open_) open_ = sink_({buffer.data(), buffer.size()});
    buffer.clear();
  }
  [[nodiscard]] bool open() const { return open_; }
  Buffer buffer;

 private:
  static constexpr std::size_t limit = std::size_t{1} << 20;
  const Sink& sink_;
  bool open_ = true;
};

}  // namespace gapcheck::report
