#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "base/parallel.hpp"
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
  void flush() { pass_on(buffer); }
  /// The entries of a list: append(i, buffer) appends entry i < count. Formatted side by side on all threads, passed on
  /// in order, some megabytes at a time.
  template <class Append>
  void entries(std::size_t count, const Append& append) {
    if (count < piece) {
      for (std::size_t i = 0; i < count && open_; ++i, pause()) append(i, buffer);
      return;
    }
    flush();
    for (std::size_t done = 0; done < count && open_; done += piece * pieces_at_once) {
      pieces_.resize(std::min(pieces_at_once, (count - done + piece - 1) / piece));
      parallel_for(pieces_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const std::size_t first = done + k * piece;
          for (std::size_t i = first; i < std::min(count, first + piece); ++i) append(i, pieces_[k]);
        }
      });
      for (Buffer& text : pieces_) pass_on(text);
    }
  }
  /// The same as lines of a list in JSON. `first`: nothing of the list has been written.
  template <class Append>
  void lines(std::size_t count, bool first, const Append& append) {
    entries(count, [&](std::size_t i, Buffer& out) {
      out.append(first && i == 0 ? std::string_view("\n  ") : std::string_view(",\n  "));
      append(i, out);
    });
  }
  [[nodiscard]] bool open() const { return open_; }
  Buffer buffer;

 private:
  static constexpr std::size_t limit = std::size_t{1} << 20;
  static constexpr std::size_t piece = 512, pieces_at_once = 16;

  void pass_on(Buffer& text) {
    if (open_ && text.size() > 0) open_ = sink_({text.data(), text.size()});
    text.clear();
  }

  const Sink& sink_;
  std::vector<Buffer> pieces_;
  bool open_ = true;
};

}  // namespace gapcheck::report
