#include "base/diagnostic.hpp"

#include <algorithm>
#include <tuple>

namespace gapcheck {

void Diagnostics::add(Diagnostic diagnostic) {
  const std::lock_guard lock(mutex_);
  if (diagnostic.severity == Severity::error) ++errors_;
  if (list_.size() < limit)
    list_.push_back(std::move(diagnostic));
  else
    ++dropped_;
}

void Diagnostics::error(std::string file, std::uint32_t line, std::string message) {
  add({Severity::error, std::move(file), line, std::move(message)});
}

void Diagnostics::warning(std::string file, std::uint32_t line, std::string message) {
  add({Severity::warning, std::move(file), line, std::move(message)});
}

bool Diagnostics::has_errors() const {
  const std::lock_guard lock(mutex_);
  return errors_ > 0;
}

std::size_t Diagnostics::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> copy;
  {
    const std::lock_guard lock(mutex_);
    copy = list_;
  }
  std::stable_sort(copy.begin(), copy.end(), [](const Diagnostic& a, const Diagnostic& b) {
    if (a.severity != b.severity) return a.severity > b.severity;
    return std::tie(a.file, a.line, a.message) < std::tie(b.file, b.line, b.message);
  });
  return copy;
}

}  // namespace gapcheck
