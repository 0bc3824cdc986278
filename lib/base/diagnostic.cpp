#include "base/diagnostic.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace gapcheck {
namespace {

/// Places of one cause that are named.
constexpr std::size_t named_places = 5;

void sort_by_place(std::vector<Diagnostic>& list) {
  std::stable_sort(list.begin(), list.end(), [](const Diagnostic& a, const Diagnostic& b) {
    if (a.severity != b.severity) return a.severity > b.severity;
    return std::tie(a.file, a.line, a.message) < std::tie(b.file, b.line, b.message);
  });
}

}  // namespace

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

void Diagnostics::add_place(const std::string& what, const std::string& advice, const Line& line,
                            const std::string& where) {
  const auto found = causes_.find(what);
  if (found == causes_.end() && causes_.size() >= limit) {
    ++errors_;
    ++dropped_;
    return;
  }
  Cause& cause = found == causes_.end() ? causes_[what] : found->second;
  cause.advice = advice;
  if (!cause.places.emplace(line, where).second) return;
  if (cause.places.size() == 1 || ++places_ < limit) return;
  cause.places.erase(std::prev(cause.places.end()));
  ++cause.more;
  --places_;
}

void Diagnostics::error_of_cause(const std::string& what, const std::string& advice, const std::string& file,
                                 std::uint32_t line, const std::string& where) {
  const std::lock_guard lock(mutex_);
  add_place(what, advice, {file, line}, where);
}

void Diagnostics::take(const Diagnostics& other) {
  // Causes apart: they are told when everything is known.
  std::vector<Diagnostic> list;
  std::map<std::string, Cause> causes;
  std::size_t errors = 0, dropped = 0;
  {
    const std::lock_guard lock(other.mutex_);
    list = other.list_;
    causes = other.causes_;
    errors = other.errors_;
    dropped = other.dropped_;
  }
  for (Diagnostic& diagnostic : list) {
    if (diagnostic.severity == Severity::error) --errors;
    add(std::move(diagnostic));
  }
  const std::lock_guard lock(mutex_);
  errors_ += errors;
  dropped_ += dropped;
  for (const auto& [what, cause] : causes) {
    for (const auto& [line, where] : cause.places) add_place(what, cause.advice, line, where);
    if (const auto known = causes_.find(what); known != causes_.end()) known->second.more += cause.more;
  }
}

bool Diagnostics::has_error_in(const std::string& file, std::uint32_t first, std::uint32_t last) const {
  const std::lock_guard lock(mutex_);
  for (const Diagnostic& d : list_)
    if (d.severity == Severity::error && d.line >= first && d.line <= last && d.file == file) return true;
  for (const auto& [what, cause] : causes_) {
    const auto place = cause.places.lower_bound({file, first});
    if (place != cause.places.end() && place->first.first == file && place->first.second <= last) return true;
  }
  return false;
}

std::vector<std::pair<std::string, std::uint32_t>> Diagnostics::error_lines() const {
  std::vector<Line> lines;
  {
    const std::lock_guard lock(mutex_);
    for (const Diagnostic& d : list_)
      if (d.severity == Severity::error) lines.emplace_back(d.file, d.line);
    for (const auto& [what, cause] : causes_)
      for (const auto& [line, where] : cause.places) lines.push_back(line);
  }
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

Diagnostic Diagnostics::told(const std::string& what, const Cause& cause) {
  const auto& [first, where] = *cause.places.begin();
  const std::size_t count = cause.places.size() + cause.more;
  if (count == 1) return {Severity::error, first.first, first.second, where + ": " + what + "; " + cause.advice};
  std::string text = what + ", in " + std::to_string(count) + " lines:";
  std::size_t named = 0;
  for (auto place = cause.places.begin(); place != cause.places.end() && named < named_places; ++place, ++named)
    text += (named == 0 ? " " : ", ") + place->first.first + ":" + std::to_string(place->first.second);
  text += (count > named ? ", …; " : "; ") + cause.advice;
  return {Severity::error, first.first, first.second, where + ": " + text};
}

bool Diagnostics::has_errors() const {
  const std::lock_guard lock(mutex_);
  return errors_ > 0 || !causes_.empty();
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
    for (const auto& [what, cause] : causes_) copy.push_back(told(what, cause));
  }
  sort_by_place(copy);
  return copy;
}

}  // namespace gapcheck
