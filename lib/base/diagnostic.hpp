#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gapcheck {

enum class Severity : std::uint8_t { note, warning, error };

/// What could not be read or was skipped: which file and line (1-based; 0 = the whole file), what is wrong, what to do.
/// An error means that the tool could not do its job (exit code 2).
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;
  std::uint32_t line = 0;
  std::string message;
  std::string excerpt = {};  ///< lines of the file to show below the message, and marks in them; may be empty
};

/// An error about no file in particular.
[[nodiscard]] inline Diagnostic plain_error(std::string message) {
  return {Severity::error, "", 0, std::move(message)};
}

/// Collects diagnostics from any thread. Keeps the first `limit` of them and counts the rest, so a hostile file cannot
/// fill the memory.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic);
  void error(std::string file, std::uint32_t line, std::string message);
  void warning(std::string file, std::uint32_t line, std::string message);
  /// An error with one cause in many places, which becomes one diagnostic at the first of them: what is wrong, with
  /// the number of lines and the first ones, then the advice. `where`: "*NODE, field x".
  void error_of_cause(const std::string& what, const std::string& advice, const std::string& file, std::uint32_t line,
                      const std::string& where);
  /// Adds all that another list has, the kept ones in the order in which it got them.
  void take(const Diagnostics& other);
  /// True if there is an error in one of the lines.
  [[nodiscard]] bool has_error_in(const std::string& file, std::uint32_t first, std::uint32_t last) const;
  /// File and line of all errors that are kept, each once, ascending.
  [[nodiscard]] std::vector<std::pair<std::string, std::uint32_t>> error_lines() const;
  [[nodiscard]] bool has_errors() const;
  [[nodiscard]] std::size_t dropped() const;
  /// Sorted by file and line, so the order does not depend on threads. Errors first.
  [[nodiscard]] std::vector<Diagnostic> sorted() const;

 private:
  static constexpr std::size_t limit = 1000;
  using Line = std::pair<std::string, std::uint32_t>;
  /// The places of one cause.
  struct Cause {
    std::string advice;
    std::map<Line, std::string> places;  ///< the first ones by file and line, with `where`
    std::size_t more = 0;                ///< beyond these
  };
  void add_place(const std::string& what, const std::string& advice, const Line& line, const std::string& where);
  [[nodiscard]] static Diagnostic told(const std::string& what, const Cause& cause);
  mutable std::mutex mutex_;
  std::vector<Diagnostic> list_;
  std::map<std::string, Cause> causes_;
  std::size_t errors_ = 0, dropped_ = 0, places_ = 0;  ///< places_: of all causes
};

}  // namespace gapcheck
