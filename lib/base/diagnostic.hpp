#pragma once
#include <cstddef>
#include <cstdint>
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
  [[nodiscard]] bool has_errors() const;
  [[nodiscard]] std::size_t dropped() const;
  /// Sorted by file and line, so the order does not depend on threads. Errors first.
  [[nodiscard]] std::vector<Diagnostic> sorted() const;

 private:
  static constexpr std::size_t limit = 1000;
  mutable std::mutex mutex_;
  std::vector<Diagnostic> list_;
  std::size_t errors_ = 0, dropped_ = 0;
};

}  // namespace gapcheck
