#include "results/history/weld_forces.hpp"

#include <fmt/format.h>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

constexpr std::array<std::string_view, 4> weld_names{"constraint/weld", "generalized weld", "spotweld beam",
                                                     "spotweld solid"};

std::string weld_row(std::size_t number, double time, const WeldForce& w) {
  std::string text = fmt::format("      {:5}{}{}{}  {:<7}    ", number, scientific(w.axial, 13, 5),
                                 scientific(w.shear, 13, 5), scientific(time, 13, 5), w.failed ? "failure" : "");
  if (w.kind == WeldForce::Kind::link || w.kind == WeldForce::Kind::generalized)
    return text + fmt::format("{:<16} ID {:8}\n", name(w.kind), w.id);
  text += fmt::format("{:<14} ID   {:8}", name(w.kind), w.id);
  return text + (w.failed ? "  failure time=" + scientific(w.failure_time, 12, 4) : scientific(w.length, 13, 5)) + '\n';
}

void take_weld(ResultText& file, History<WeldForce>& history) {
  std::string_view rest = file.line();
  WeldForce weld;
  if (!take_integer(rest)) return file.unreadable();
  weld.axial = file.take(rest);
  weld.shear = file.take(rest);
  history.at(file.take(rest));
  weld.failed = rest.find("failure") != std::string_view::npos;
  for (std::size_t kind = 0; kind < weld_names.size(); ++kind)
    if (rest.find(weld_names[kind]) != std::string_view::npos) weld.kind = static_cast<WeldForce::Kind>(kind);
  std::string_view numbers = behind(rest, " ID ");
  const auto id = take_integer(numbers);
  if (!id) return file.unreadable();
  weld.id = *id;
  if (std::string_view time = behind(numbers, "time="); !time.empty())
    weld.failure_time = file.take(time);
  else if (!trimmed(numbers).empty())
    weld.length = file.take(numbers);
  history.add(weld);
}

}  // namespace

std::string_view name(WeldForce::Kind kind) { return weld_names[static_cast<std::size_t>(kind)]; }

std::string swforc_header(const FileHeader& header) { return header_text(header); }

std::string swforc_text(double time, std::span<const WeldForce> welds) {
  std::string text = "\n constraint #      axial        shear         time" + std::string(48, ' ') + "length\n";
  for (std::size_t i = 0; i < welds.size(); ++i) text += weld_row(i + 1, time, welds[i]);
  return text;
}

History<WeldForce> read_swforc(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  History<WeldForce> history;
  ResultText file(text, name, diagnostics);
  bool inside = false;
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    const std::string_view line = trimmed(file.line());
    const bool heading = line.starts_with("constraint #");
    if (inside && !heading && !line.empty()) take_weld(file, history);
    inside = inside || heading;
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
