#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gapcheck::results {

/// Iterates over the lines of a text in memory without copying. LF, CR LF, CR CR LF and CR all end a line; leading and
/// trailing NUL bytes of a line are left out. The text must outlive the views. Work is linear in the size for any
/// input.
class Lines {
 public:
  /// Longer lines are cut to this many bytes (see `cut_lines`).
  static constexpr std::size_t longest = std::size_t{1} << 16;

  explicit Lines(std::string_view text);
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

 private:
  /// Searches one character in steps just ahead of the reader: rare ones cost next to nothing, no byte is searched
  /// twice, and pages far ahead stay untouched.
  class Ahead {
   public:
    Ahead(std::string_view text, char wanted, std::size_t step) : text_(text), wanted_(wanted), step_(step) {}
    /// Position of the first one in [begin, end), or `end`. `begin` must not decrease.
    std::size_t find(std::size_t begin, std::size_t end);

   private:
    std::string_view text_;
    char wanted_;
    std::size_t step_, found_ = 0, searched_ = 0;
    bool known_ = false;
  };

  void check_line(std::size_t begin, std::size_t end);

  std::string_view text_, line_;
  Ahead feeds_, returns_, nuls_;
  std::size_t next_ = 0;
  std::uint64_t cut_lines_ = 0;
  std::uint32_t number_ = 0, first_cut_ = 0, first_nul_ = 0;
  bool done_ = false, open_ = false;
};

}  // namespace gapcheck::results
