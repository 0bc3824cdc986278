#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number.hpp"
#include "base/vector.hpp"
#include "results/text/file_header.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"
#include "results/text/result_text.hpp"

namespace gapcheck::results {

/// All rows of a file at one time.
template <class Row>
struct Timed {
  double time = 0;
  std::vector<Row> rows;
};

/// What a file of curves says over the whole run.
template <class Row>
struct History {
  std::vector<LegendEntry> titles;
  std::vector<Timed<Row>> states;  ///< in order of the file

  /// A row without a time of its own belongs to the last state.
  void add(Row row) {
    if (!states.empty()) states.back().rows.push_back(std::move(row));
  }
  /// Rows with one time are one state. A time that is not a number begins none.
  void at(double time) {
    if (time == time && (states.empty() || states.back().time != time)) states.push_back({time, {}});
  }
  /// Leaves out a last state with fewer rows than the one before it.
  void end(ResultText& file) {
    if (states.size() < 2 || states.back().rows.size() >= states[states.size() - 2].rows.size()) return;
    states.pop_back();
    file.incomplete();
  }
};

/// Three numbers off the front of `rest`.
[[nodiscard]] inline Vector take_vector(ResultText& file, std::string_view& rest) {
  Vector value = Vector::Zero();
  for (int axis = 0; axis < 3; ++axis) value[axis] = file.take(rest);
  return value;
}

/// What follows the first `word` in a line; nothing where it is missing.
[[nodiscard]] inline std::string_view behind(std::string_view line, std::string_view word) {
  const std::size_t at = line.find(word);
  return at == std::string_view::npos ? std::string_view{} : line.substr(at + word.size());
}

/// What follows the first columns of a line.
[[nodiscard]] inline std::string_view behind_columns(std::string_view line, std::size_t columns) {
  return line.substr(std::min(columns, line.size()));
}

/// " x-force......................   1.00000E+00", as deforc and jntforc have it.
[[nodiscard]] inline std::string dotted_row(std::string_view label, double value) {
  return fmt::format(" {:.<29}{}\n", label, scientific(value, 14, 5));
}
[[nodiscard]] inline std::string dotted_row(std::string_view label, std::int64_t value) {
  return fmt::format(" {:.<29}{:10}\n", label, value);
}
/// Its label, empty for other lines; `value` becomes what follows the dots.
[[nodiscard]] inline std::string_view dotted_label(std::string_view line, std::string_view& value) {
  const std::size_t dots = line.find("..");
  if (dots == std::string_view::npos) return {};
  value = line.substr(std::min(line.find_first_not_of('.', dots), line.size()));
  return trimmed(line.substr(0, dots));
}

/// Reads a file of dotted rows. A block begins with the id that `head` labels and ends at the next time, or at a label
/// that begins with `other`. `blank(id)` is its empty row; `take(file, label, rest, row)` puts a number into it.
template <class Row, class Blank, class Take>
[[nodiscard]] History<Row> read_dotted(ResultText file, std::string_view head, std::string_view other,
                                       const Blank& blank, const Take& take) {
  History<Row> history;
  bool open = false;
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    std::string_view rest;
    const std::string_view label = dotted_label(file.line(), rest);
    if (label == "time") {
      history.at(file.take(rest));
      open = false;
    } else if (label == head) {
      const auto id = take_integer(rest);
      open = id.has_value() && !history.states.empty();
      if (open) history.add(blank(*id));
      if (!id) file.unreadable();
    } else if (!other.empty() && label.starts_with(other)) {
      open = false;
    } else if (open && !label.empty()) {
      take(file, label, rest, history.states.back().rows.back());
    }
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
