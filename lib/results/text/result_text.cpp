#include "results/text/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "base/number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

/// What Fortran prints for NaN and infinity.
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

bool begins_legend(std::string_view line) { return trimmed(line).starts_with("{BEGIN LEGEND}"); }

/// Other lines of a legend besides its entries: blank lines, the heading, numbers too long for their column.
bool may_stand_in_legend(std::string_view text) {
  return text.empty() || text.starts_with("Entity #") || text.starts_with('*');
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
  while (begins_legend(line())) {
    const std::uint32_t begin = lines_.number();
    bool inside = true;
    for (advance(); inside && !done();) {
      if (trimmed(line()).starts_with("{END LEGEND}")) return true;
      std::string_view rest = line();
      if (const auto id = take_integer(rest))
        entries.push_back({*id, std::string(trimmed(rest))});
      else
        inside = may_stand_in_legend(trimmed(line()));
      if (inside) advance();
    }
    (inside ? cut_legend_ : open_legend_).add(begin);
    if (done()) return true;
  }
  return false;
}

void ResultText::finish() {
  if (unreadable_.count > 0)
    diagnostics_.error(name_, unreadable_.first, "a number cannot be read and is left out" + others(unreadable_.count));
  if (open_legend_.count > 0)
    diagnostics_.error(
        name_, open_legend_.first,
        "the legend has no {END LEGEND} before the results begin; the file is damaged: add that line, or "
        "write or copy the file again" +
            others(open_legend_.count));
  if (lines_.first_nul() > 0)
    diagnostics_.error(name_, lines_.first_nul(), "there are NUL bytes; the file is damaged or no text file");
  if (lines_.cut_lines() > 0)
    diagnostics_.error(name_, lines_.first_cut(), "a line is longer than 64 KiB; what is behind that is left out");
  if (incomplete_.count > 0)
    diagnostics_.warning(name_, incomplete_.first,
                         "a state ends before it is complete and is left out" + others(incomplete_.count));
  else if (cut_legend_.count > 0)
    diagnostics_.warning(name_, cut_legend_.first, "the file ends inside its legend: the run may still be writing it");
  else if (open_)
    diagnostics_.warning(name_, last_line_, "the file ends inside a line: the run may still be writing it");
}

}  // namespace gapcheck::results
