#include "results/history/wall_forces.hpp"

#include <fmt/format.h>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {

std::string rwforc_header(const FileHeader& header, std::vector<LegendEntry> walls) {
  return header_text(header) + legend_text(std::move(walls), 70) +
         "\n\n\n    time       wall#   normal-force    x-force        y-force        z-force\n";
}

std::string rwforc_text(double time, std::span<const WallForce> walls) {
  std::string text;
  for (const WallForce& w : walls) {
    text += fmt::format("{}{:8}", scientific(time, 12, 5), w.wall);
    for (const double value : {w.normal, w.force.x(), w.force.y(), w.force.z()}) text += scientific(value, 15, 6);
    text += '\n';
  }
  return text;
}

History<WallForce> read_rwforc(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  constexpr std::size_t time_columns = 12;
  History<WallForce> history;
  ResultText file(text, name, diagnostics);
  bool inside = false;
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    std::string_view rest = file.line();
    if (trimmed(rest).starts_with("time")) inside = true;
    // Rows of segments leave the columns of the time blank; the sum over them begins with a word.
    const std::string_view first = trimmed(rest.substr(0, time_columns));
    if (!inside || first.empty() || first.find_first_of("0123456789") == std::string_view::npos) continue;
    const double time = file.take(rest);
    const auto wall = take_integer(rest);
    if (!wall) {
      file.unreadable();
      continue;
    }
    history.at(time);
    const double normal = file.take(rest);
    history.add({*wall, normal, take_vector(file, rest)});
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
