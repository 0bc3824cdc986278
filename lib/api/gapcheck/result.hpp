#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gapcheck::api {

/// How severe a finding or a diagnostic is.
enum class Severity : std::uint8_t { note, warning, error };

/// What could not be read or was skipped.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;        ///< empty: about no file in particular
  std::uint32_t line = 0;  ///< from 1; 0: the whole file
  std::string message;     ///< one line: what is wrong, and what to do; text from decks is in it as it is
};

/// Why a function gives no result.
struct Error {
  std::string file;                     ///< empty: about no file in particular
  std::uint32_t line = 0;               ///< from 1; 0: the whole file
  std::string message;                  ///< one line: what is wrong, and what to do
  std::vector<Diagnostic> diagnostics;  ///< further diagnostics about the input: errors first, then by file and line
};

/// A value, or the error that says why there is none. Bad input, bad options and files that cannot be read or written
/// are errors; the library does not throw for them. Lack of memory throws std::bad_alloc.
///
///     const auto report = gapcheck::api::audit_deck("model.k");
///     if (!report.ok()) return complain(report.error().message);
///     use(report.value());
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}
  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  /// Only if ok(); anything else throws std::bad_variant_access.
  [[nodiscard]] T& value() & { return std::get<0>(state_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
  [[nodiscard]] T&& value() && { return std::get<0>(std::move(state_)); }
  /// Only if not ok().
  [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

}  // namespace gapcheck::api
