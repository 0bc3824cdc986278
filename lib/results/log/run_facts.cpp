#include "results/log/run_facts.hpp"

#include <algorithm>
#include <limits>

#include "base/number.hpp"
#include "results/log/message_block.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

void set_once(std::string& target, std::string_view value) {
  if (target.empty()) target = value;
}

/// "gapcheck 0.1.0": in this place in the files of our own solver.
bool is_own_stamp(std::string_view text) {
  constexpr std::string_view words = "gapcheck ";
  return text.starts_with(words) && text.size() > words.size() &&
         text.find_first_not_of("0123456789.", words.size()) == std::string_view::npos;
}

/// The text without any blanks, to compare spaced-out headings.
std::string squeezed(std::string_view text) {
  std::string result(text);
  std::erase(result, ' ');
  return result;
}

}  // namespace

bool RunFacts::banner_line(std::string_view text) {
  if (!text.starts_with('|')) return false;
  text.remove_prefix(1);
  if (!text.empty() && text.back() == '|') text.remove_suffix(1);
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return true;
  const std::string_view label = trimmed(text.substr(0, colon)), value = trimmed(text.substr(colon + 1));
  if (label == "Version") {
    set_once(run_.version, value);
    run_.mpp = run_.mpp || value.starts_with("mpp");
  }
  if (label == "Revision") set_once(run_.revision, value);
  if (label == "Platform") set_once(run_.platform, value);
  if (label == "Precision") set_once(run_.precision, value);
  return true;
}

bool RunFacts::version_stamp(std::string_view text, std::string_view line_before) {
  if (is_own_stamp(text)) {
    set_once(run_.title, trimmed(line_before));
    set_once(run_.version, text);
    return true;
  }
  if (!text.starts_with("ls-dyna ")) return false;
  const std::size_t date = text.find(" date ");
  if (date == std::string_view::npos) return false;
  set_once(run_.title, trimmed(line_before));
  std::string_view rest = trimmed(text.substr(8, date - 8));
  run_.mpp = run_.mpp || rest.starts_with("mpp");
  const std::size_t last = rest.rfind(' ');
  // "smp d R14 R14.0_515_8a12796" today, "smp.78769 d" formerly.
  const std::size_t point = rest.substr(0, last).find('.');
  if (point == 3) {
    set_once(run_.revision, rest.substr(4, rest.find(' ') - 4));
    set_once(run_.version,
             std::string(rest.substr(0, 3)) + std::string(rest.substr(std::min(rest.find(' '), rest.size()))));
  } else if (last != std::string_view::npos) {
    set_once(run_.revision, rest.substr(last + 1));
    set_once(run_.version, trimmed(rest.substr(0, last)));
  }
  return true;
}

bool RunFacts::termination(std::string_view text) {
  if (text.size() > 200 || !(text.starts_with("N o") || text.starts_with("E r"))) return false;
  const std::string letters = squeezed(text);
  if (letters.starts_with("Errortermination")) {
    if (!collector_.companion()) run_.termination = SolverRun::Termination::error;
    return true;
  }
  if (!letters.starts_with("Normaltermination")) return false;
  // An error of one rank is an error of the run.
  if (!collector_.companion() && run_.termination == SolverRun::Termination::unknown)
    run_.termination = SolverRun::Termination::normal;
  return true;
}

bool RunFacts::cycle_line(std::string_view text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  if (end == std::string_view::npos || end == 0 || !text.substr(end).starts_with(" t ")) return false;
  const auto cycle = parse_integer(text.substr(0, end));
  text.remove_prefix(end + 3);
  const auto time = take_real(text);
  if (!cycle || !time) return false;
  if (collector_.companion()) return true;
  run_.cycles = std::max(run_.cycles, *cycle);
  run_.problem_time = std::max(run_.problem_time, *time);
  return true;
}

bool RunFacts::problem_line(std::string_view text) {
  if (!text.starts_with("Problem ")) return false;
  const auto entry = field(text);
  if (!entry) return false;
  std::string_view value = entry->value;
  if (entry->label == "Problem time") {
    if (const auto time = take_real(value); time && !collector_.companion())
      run_.problem_time = std::max(run_.problem_time, *time);
    return true;
  }
  if (entry->label != "Problem cycle") return false;
  if (const auto cycles = take_integer(value); cycles && !collector_.companion())
    run_.cycles = std::max(run_.cycles, *cycles);
  return true;
}

bool RunFacts::end_time(std::string_view text) {
  constexpr std::string_view words = "termination time...";
  if (!text.starts_with(words)) return false;
  text.remove_prefix(std::min(text.find_first_not_of('.', words.size()), text.size()));
  if (const auto time = take_real(text); time && *time > 0 && run_.end_time == 0) run_.end_time = *time;
  return true;
}

bool RunFacts::contact_limit(std::string_view text, std::uint32_t line) {
  constexpr std::string_view words = "time step size should not exceed";
  const std::size_t at = text.find(words);
  if (at == std::string_view::npos) return false;
  std::string_view rest = text.substr(at + words.size());
  const auto limit = take_real(rest);
  if (!limit) {
    collector_.error(line, "the time step that should not be exceeded is not a number");
    return true;
  }
  if (run_.contact_timestep == 0 || *limit < run_.contact_timestep) run_.contact_timestep = *limit;
  return true;
}

bool RunFacts::smallest_timesteps(Lines& lines, std::string_view text) {
  if (!text.starts_with("100 smallest timesteps")) return false;
  collector_.mark_d3hsp();
  for (lines.advance(); !lines.done(); lines.advance()) {
    std::string_view row = trimmed(lines.line());
    if (row.starts_with("---") || row.starts_with("element ")) continue;
    if (row.empty()) break;
    take_token(row);
    const auto element = take_integer(row);
    const auto part = take_integer(row);
    const auto timestep = take_real(row);
    if (!element || !part || !timestep) break;
    if (run_.element_timestep == 0 || *timestep < run_.element_timestep) run_.element_timestep = *timestep;
  }
  return true;
}

bool RunFacts::ranks(std::string_view text) {
  constexpr std::string_view words = "execution with ";
  if (!text.starts_with("MPP ") && !text.starts_with("Parallel ")) return false;
  const std::size_t at = text.find(words);
  if (at == std::string_view::npos) return false;
  std::string_view rest = text.substr(at + words.size());
  const auto count = take_integer(rest);
  if (!count || *count <= 0 || *count > std::numeric_limits<std::uint32_t>::max()) return false;
  run_.ranks = std::max(run_.ranks, static_cast<std::uint32_t>(*count));
  run_.mpp = true;
  return true;
}

}  // namespace gapcheck::results
