#pragma once
#include <cstddef>
#include <gapcheck/includes.hpp>
#include <gapcheck/result.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "base/vector.hpp"
#include "keyword/deck.hpp"

// Converts between the types of the rooms and those of the public interface.
namespace gapcheck::api {

[[nodiscard]] Severity converted(gapcheck::Severity severity);
[[nodiscard]] gapcheck::Severity converted(Severity severity);

/// Errors first, then by file and line.
[[nodiscard]] std::vector<Diagnostic> listed(const gapcheck::Diagnostics& diagnostics);

/// The error that ended the work, and the diagnostics before it.
[[nodiscard]] Error error_of(const gapcheck::Diagnostic& why, const gapcheck::Diagnostics& diagnostics);

/// The first error of the diagnostics, which has at least one, and the others after it.
[[nodiscard]] Error first_error(const gapcheck::Diagnostics& diagnostics);

/// An error about no file.
[[nodiscard]] Error plain_error(std::string message);

[[nodiscard]] keyword::ReadOptions read_options(const Includes& includes);

/// Copies a point to where an array of three begins.
inline void copy(const Vector& from, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

/// Limits the threads while it lives; 0: sets no limit.
class Jobs {
 public:
  explicit Jobs(std::size_t jobs) {
    if (jobs > 0) limit_.emplace(jobs);
  }

 private:
  std::optional<JobLimit> limit_;
};

}  // namespace gapcheck::api
