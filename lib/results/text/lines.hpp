#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/file_bytes.hpp"
#include "base/result.hpp"

namespace gapcheck::results {

/// Iterates over the lines of a text in memory without copying, or of a file that is read as far as they go. LF, CR LF,
/// CR CR LF and CR all end a line; leading and trailing NUL bytes of a line are left out. The text must outlive the
/// views. Work is linear in the size for any input. Where the work is stopped, the lines end.
class Lines {
 public:
  /// Longer lines are cut to this many bytes (see `cut_lines`).
  static constexpr std::size_t longest = std::size_t{1} << 16;

  explicit Lines(std::string_view text);
  explicit Lines(FileBytes& file);
  [[nodiscard]] bool done() const { return done_; }
  /// The current line without its end; only while not done().
  [[nodiscard]] std::string_view line() const { return line_; }
  /// From 1; stays at the largest value beyond it.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  /// Lines up to now that were longer than `longest`, and the first of them (0: none).
  [[nodiscard]] std::uint64_t cut_lines() const { return cut_lines_; }
  [[nodiscard]] std::uint32_t first_cut() const { return first_cut_; }
  /// The first line up to now with a NUL byte (0: none).
  [[nodiscard]] std::uint32_t first_nul() const { return first_nul_; }
  /// The current line is the last one and has no line end.
  [[nodiscard]] bool open() const { return open_; }
  /// Bytes up to the end of the current line.
  [[nodiscard]] std::size_t offset() const { return next_; }
  void advance();
  /// Not ok() if the file could not be read to its end: the lines end where it failed.
  [[nodiscard]] const Status& status() const { return status_; }

 private:
  /// Searches one character in steps just ahead of the reader: rare ones cost next to nothing, no byte is searched
  /// twice, and pages far ahead stay untouched.
  class Ahead {
   public:
    Ahead(char wanted, std::size_t step) : wanted_(wanted), step_(step) {}
    /// Position of the first one in [begin, end) of the text, or `end`. `begin` must not decrease; the text may grow.
    std::size_t find(std::string_view text, std::size_t begin, std::size_t end);

   private:
    char wanted_;
    std::size_t step_, found_ = 0, searched_ = 0;
    bool known_ = false;
  };

  bool read_on();
  void end_here();
  [[nodiscard]] std::size_t next_feed();
  void check_line(std::size_t begin, std::size_t end);

  FileBytes* file_ = nullptr;
  Status status_;
  std::string_view text_, line_;
  Ahead feeds_, returns_, nuls_;
  std::size_t next_ = 0;
  std::uint64_t cut_lines_ = 0;
  std::uint32_t number_ = 0, first_cut_ = 0, first_nul_ = 0;
  bool done_ = false, open_ = false;
};

}  // namespace gapcheck::results
