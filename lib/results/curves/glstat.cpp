#include "results/curves/glstat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"
#include "results/text/result_text.hpp"

namespace gapcheck::results {
namespace {

/// A row's label, padded with dots up to the numbers, and where its value is kept; no place: zero is printed.
struct Row {
  std::string_view label;
  double GlobalState::*value = nullptr;
};

constexpr std::array<Row, 4> rows_before_walls{{
    {"time...........................", &GlobalState::time},
    {"time step......................", &GlobalState::time_step},
    {"kinetic energy.................", &GlobalState::kinetic},
    {"internal energy................", &GlobalState::internal},
}};

/// Walls come between the two, as in the solver developer's own converter from binout to text (l2a).
constexpr std::array<Row, 11> rows_behind_walls{{
    {"spring and damper energy.......", &GlobalState::springs},
    {"hourglass energy ..............", &GlobalState::hourglass},
    {"system damping energy..........", &GlobalState::damping},
    {"sliding interface energy.......", &GlobalState::sliding},
    {"external work..................", &GlobalState::external},
    {"eroded kinetic energy.........."},
    {"eroded internal energy.........", &GlobalState::eroded_internal},
    {"eroded hourglass energy........", &GlobalState::eroded_hourglass},
    {"total energy...................", &GlobalState::total},
    {"total energy / initial energy..", &GlobalState::ratio},
    {"energy ratio w/o eroded energy.", &GlobalState::ratio_without_eroded},
}};

/// Behind the block, with mass scaling.
constexpr std::array<Row, 2> rows_of_scaling{{
    {"added mass.....................", &GlobalState::added_mass},
    {"percentage increase............", &GlobalState::added_percent},
}};

/// 0.28468E-03 in a field of 14.
std::string fortran_row(std::string_view label, double value) {
  int exponent = 0;
  double digits = std::abs(value);
  if (digits > 0 && std::isfinite(digits)) {
    exponent = static_cast<int>(std::floor(std::log10(digits))) + 1;
    digits /= std::pow(10.0, exponent);
    if (digits >= 0.999995) {
      digits /= 10;
      ++exponent;
    }
  }
  return fmt::format(
      " {}{:>14}\n", label,
      fmt::format("{}{:.5f}E{}{:02}", value < 0 ? "-" : "", digits, exponent < 0 ? '-' : '+', std::abs(exponent)));
}

constexpr std::string_view total_label = "total energy";
constexpr std::string_view wall_label = "stonewall energy...............";

std::string labelled_row(std::string_view label, double value) {
  return fmt::format(" {}{}\n", label, scientific(value, 14, 5));
}

/// Where the dots after a label begin; a label that fills its columns has only one.
std::size_t dots_of(std::string_view line) { return std::min(line.find(".."), line.find(". ")); }

std::string_view before_dots(std::string_view label) {
  return trimmed(label.substr(0, label.find_last_not_of('.') + 1));
}

/// Where a row's value is kept; nullptr if it is not.
double* global_value(std::string_view label, GlobalState& state) {
  for (const auto& rows : {std::span<const Row>(rows_before_walls), std::span<const Row>(rows_behind_walls),
                           std::span<const Row>(rows_of_scaling)})
    for (const Row& entry : rows)
      if (entry.value != nullptr && before_dots(entry.label) == label) return &(state.*entry.value);
  for (int axis = 0; axis < 3; ++axis)
    if (label == fmt::format("global {} velocity", "xyz"[axis])) return &state.velocity[axis];
  return nullptr;
}

/// False if the row is not kept.
bool take_labelled_row(std::string_view label, std::string_view rest, ResultText& file, GlobalState& state) {
  if (double* place = global_value(label, state)) {
    *place = file.take(rest);
    if (place == &state.added_mass) state.mass_scaling = true;
    return true;
  }
  if (label == before_dots(wall_label)) {
    constexpr std::string_view words = "wall#";
    const double energy = file.take(rest);
    const std::size_t at = rest.find(words);
    std::string_view number = at == std::string_view::npos ? std::string_view{} : rest.substr(at + words.size());
    state.walls.push_back({take_integer(number).value_or(0), energy});
    return true;
  }
  return false;
}

/// The number after "dt of cycle".
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
  const auto add = [&](const Row& entry) {
    text += labelled_row(entry.label, entry.value != nullptr ? state.*entry.value : 0);
  };
  for (const Row& entry : rows_before_walls) add(entry);
  for (const GlobalState::Wall& wall : state.walls)
    text += fmt::format(" {}{} wall#{:5}\n", wall_label, scientific(wall.energy, 14, 5), wall.number);
  for (const Row& entry : rows_behind_walls) add(entry);
  for (int axis = 0; axis < 3; ++axis)
    text += labelled_row(fmt::format("global {} velocity..............", "xyz"[axis]), state.velocity[axis]);
  text += fmt::format(" time per zone cycle.(nanosec)..{:14}\n", state.nanoseconds);
  if (!state.mass_scaling) return text;
  text += "\n\n";
  for (const Row& entry : rows_of_scaling) text += fortran_row(entry.label, state.*entry.value);
  return text;
}

std::vector<GlobalState> read_glstat(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  std::vector<GlobalState> states;
  std::uint64_t cycle = 1;
  bool open = false;                      // the last state has no total energy yet
  std::size_t rows = 0, rows_before = 0;  // of the last state and the one before it
  ResultText file(text, name, diagnostics);
  const auto drop_open = [&] {
    if (open) states.pop_back();
    if (open) file.incomplete();
    if (open) rows = rows_before;
    open = false;
  };
  for (; !file.done(); file.advance()) {
    const std::string_view line = trimmed(file.line());
    if (const auto given = cycle_of(line)) cycle = *given;
    const std::size_t dots = dots_of(line);
    if (dots == std::string_view::npos) continue;
    const std::string_view label = trimmed(line.substr(0, dots));
    std::string_view rest = line.substr(std::min(line.find_first_not_of('.', dots), line.size()));
    if (label == before_dots(rows_before_walls.front().label)) {
      drop_open();
      const double time = file.take(rest);
      open = time == time;
      if (!open) continue;
      states.emplace_back().cycle = cycle;
      states.back().time = time;
      states.back().ratio = states.back().ratio_without_eroded = std::numeric_limits<double>::quiet_NaN();
      rows_before = rows;
      rows = 0;
    } else if (!states.empty()) {
      if (take_labelled_row(label, rest, file, states.back())) ++rows;
      if (label == total_label) open = false;
    }
  }
  if (rows < rows_before) open = true;
  drop_open();
  file.finish();
  return states;
}

std::vector<GlobalState> read_glstat(std::string_view text) {
  Diagnostics diagnostics;
  return read_glstat(text, "glstat", diagnostics);
}

}  // namespace gapcheck::results
