#include "results/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "base/number.hpp"
#include "results/printed_number.hpp"

namespace gapcheck::results {
namespace {

/// What Fortran prints for a value that is none.
bool says_no_number(std::string_view token) {
  if (!token.empty() && (token.front() == '+' || token.front() == '-')) token.remove_prefix(1);
  constexpr std::array<std::string_view, 3> words{"nan", "infinity", "inf"};
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return std::equal(token.begin(), token.end(), word.begin(), word.end(),
                      [](unsigned char a, char b) { return std::tolower(a) == b; });
  });
}

std::string others(std::uint64_t count) {
  return count > 1 ? fmt::format(", and so it is in {} more places", count - 1) : "";
}

}  // namespace

void ResultText::advance() {
  last_line_ = lines_.number();
  lines_.advance();
  leave_out_open();
}

void ResultText::leave_out_open() {
  if (lines_.done() || !lines_.open()) return;
  open_ = true;
  last_line_ = lines_.number();
  lines_.advance();
}

double ResultText::take(std::string_view& rest) {
  std::string_view again = rest;
  if (const auto value = take_real(rest)) return *value;
  if (!says_no_number(take_token(again))) unreadable();
  return std::numeric_limits<double>::quiet_NaN();
}

void ResultText::unreadable() { unreadable_.add(lines_.number()); }

void ResultText::incomplete() { incomplete_.add(lines_.done() ? last_line_ : lines_.number()); }

bool ResultText::take_legend(std::vector<LegendEntry>& entries) {
  if (!trimmed(line()).starts_with("{BEGIN LEGEND}")) return false;
  for (advance(); !done() && !trimmed(line()).starts_with("{END LEGEND}"); advance()) {
    std::string_view rest = line();
    if (const auto id = take_integer(rest)) entries.push_back({*id, std::string(trimmed(rest))});
  }
  return true;
}

void ResultText::finish() {
  if (unreadable_.count > 0)
    diagnostics_.error(name_, unreadable_.first, "a number cannot be read and is left out" + others(unreadable_.count));
  if (lines_.first_nul() > 0)
    diagnostics_.error(name_, lines_.first_nul(), "there are NUL bytes; the file is damaged or no text file");
  if (lines_.cut_lines() > 0)
    diagnostics_.error(name_, lines_.first_cut(), "a line is longer than 64 KiB; what is behind that is left out");
  if (incomplete_.count > 0)
    diagnostics_.warning(name_, incomplete_.first,
                         "a state ends before it is complete and is left out" + others(incomplete_.count));
  else if (open_)
    diagnostics_.warning(name_, last_line_, "the file ends inside a line: the run may still be writing it");
}

}  // namespace gapcheck::results
