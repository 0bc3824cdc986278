#include "results/history/airbag_states.hpp"

#include <fmt/format.h>

#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {

std::string abstat_header(const FileHeader& header, std::vector<LegendEntry> airbags) {
  return header_text(header) + legend_text(std::move(airbags), 70);
}

std::string abstat_text(double time, std::span<const AirbagRow> airbags) {
  if (airbags.empty()) return "";
  std::string text =
      "\n\n      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt out  "
      "total mass gas temp. surface area\n";
  for (const AirbagRow& a : airbags) {
    text += fmt::format("{}{:8}", scientific(time, 12, 5), a.airbag);
    for (const double value : {a.volume, a.pressure, a.energy, a.rate_in, a.density}) text += scientific(value, 15, 4);
    for (const double value : {a.rate_out, a.mass, a.temperature, a.area}) text += scientific(value, 11, 3);
    text += '\n';
  }
  return text;
}

History<AirbagRow> read_abstat(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  History<AirbagRow> history;
  ResultText file(text, name, diagnostics);
  bool inside = false;
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    std::string_view rest = file.line();
    const std::string_view first = trimmed(rest);
    if (first.starts_with("time")) {
      inside = true;
      continue;
    }
    if (!inside || first.empty()) continue;
    const double time = file.take(rest);
    const auto id = take_integer(rest);
    if (!id) {
      file.unreadable();
      continue;
    }
    history.at(time);
    AirbagRow row;
    row.airbag = *id;
    for (double AirbagRow::*const member :
         {&AirbagRow::volume, &AirbagRow::pressure, &AirbagRow::energy, &AirbagRow::rate_in, &AirbagRow::density,
          &AirbagRow::rate_out, &AirbagRow::mass, &AirbagRow::temperature, &AirbagRow::area})
      row.*member = file.take(rest);
    history.add(row);
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
