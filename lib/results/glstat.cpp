#include "results/glstat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/number.hpp"
#include "results/fortran_number.hpp"
#include "results/lines.hpp"
#include "results/printed_number.hpp"

namespace gapcheck::results {
namespace {

/// A row's label, filled up with dots as far as the numbers, and where its value is kept; no place: zero is printed.
struct Row {
  std::string_view label;
  double GlobalState::*value = nullptr;
};

constexpr std::array<Row, 8> rows_before_walls{{
    {"time...........................", &GlobalState::time},
    {"time step......................", &GlobalState::time_step},
    {"kinetic energy.................", &GlobalState::kinetic},
    {"internal energy................", &GlobalState::internal},
    {"spring and damper energy.......", &GlobalState::springs},
    {"hourglass energy ..............", &GlobalState::hourglass},
    {"system damping energy..........", &GlobalState::damping},
    {"sliding interface energy.......", &GlobalState::sliding},
}};

constexpr std::array<Row, 7> rows_behind_walls{{
    {"external work..................", &GlobalState::external},
    {"eroded kinetic energy.........."},
    {"eroded internal energy........."},
    {"eroded hourglass energy........"},
    {"total energy...................", &GlobalState::total},
    {"total energy / initial energy..", &GlobalState::ratio},
    {"energy ratio w/o eroded energy.", &GlobalState::ratio},
}};

constexpr std::string_view wall_label = "stonewall energy...............";

std::string row(std::string_view label, double value) {
  return fmt::format(" {}{}\n", label, scientific(value, 14, 5));
}

std::string_view before_dots(std::string_view text) { return trimmed(text.substr(0, text.find(".."))); }

void set(const Row& entry, std::string_view label, double value, GlobalState& state) {
  if (entry.value != nullptr && before_dots(entry.label) == label) state.*entry.value = value;
}

/// The number behind "dt of cycle".
std::optional<std::uint64_t> cycle_of(std::string_view line) {
  constexpr std::string_view words = "dt of cycle";
  if (!line.starts_with(words)) return std::nullopt;
  std::string_view rest = line.substr(words.size());
  const auto cycle = take_integer(rest);
  return cycle && *cycle >= 0 ? std::optional(static_cast<std::uint64_t>(*cycle)) : std::nullopt;
}

}  // namespace

std::string glstat_header(const FileHeader& header) { return header_text(header); }

std::string glstat_text(const GlobalState& state) {
  std::string text = fmt::format("\n\n dt of cycle{:8} is controlled by {:<10}", state.cycle, state.controlled_by);
  text += state.element != 0 ? fmt::format("{:10} of part{:10}\n\n", state.element, state.part) : "\n\n";
  const auto add = [&](const Row& entry) { text += row(entry.label, entry.value != nullptr ? state.*entry.value : 0); };
  for (const Row& entry : rows_before_walls) add(entry);
  for (const GlobalState::Wall& wall : state.walls)
    text += fmt::format(" {}{} wall#{:5}\n", wall_label, scientific(wall.energy, 14, 5), wall.number);
  for (const Row& entry : rows_behind_walls) add(entry);
  for (int axis = 0; axis < 3; ++axis)
    text += row(fmt::format("global {} velocity..............", "xyz"[axis]), state.velocity[axis]);
  return text + fmt::format(" time per zone cycle.(nanosec)..{:14}\n", state.nanoseconds);
}

std::vector<GlobalState> read_glstat(std::string_view text) {
  std::vector<GlobalState> states;
  std::uint64_t cycle = 1;
  for (Lines lines(text); !lines.done(); lines.advance()) {
    const std::string_view line = trimmed(lines.line());
    if (const auto given = cycle_of(line)) cycle = *given;
    const std::size_t dots = line.find("..");
    if (dots == std::string_view::npos) continue;
    const std::string_view label = before_dots(line);
    std::string_view rest = trimmed(line.substr(std::min(line.find_first_not_of('.', dots), line.size())));
    const double value = take_real(rest).value_or(0);
    if (label == "time") states.emplace_back().cycle = cycle;
    if (states.empty()) continue;
    GlobalState& state = states.back();
    for (const Row& entry : rows_before_walls) set(entry, label, value, state);
    for (const Row& entry : rows_behind_walls) set(entry, label, value, state);
    for (int axis = 0; axis < 3; ++axis)
      if (label == fmt::format("global {} velocity", "xyz"[axis])) state.velocity[axis] = value;
    if (label == before_dots(wall_label)) {
      constexpr std::string_view words = "wall#";
      const std::size_t at = rest.find(words);
      std::string_view number = at == std::string_view::npos ? std::string_view{} : rest.substr(at + words.size());
      state.walls.push_back({take_integer(number).value_or(0), value});
    }
  }
  return states;
}

}  // namespace gapcheck::results
