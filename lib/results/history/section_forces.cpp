#include "results/history/section_forces.hpp"

#include <fmt/format.h>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t words_of_row = 27;  ///< columns before the four numbers of the second and third line

std::string section_row(const Vector& v, double last) {
  return scientific(v.x(), 15, 4) + scientific(v.y(), 12, 4) + scientific(v.z(), 12, 4) + scientific(last, 12, 4) +
         '\n';
}

}  // namespace

std::string secforc_header(const FileHeader& header, std::vector<LegendEntry> sections) {
  return header_text(header) + legend_text(std::move(sections), 70) +
         "\n\n\n line#1  section#     time        x-force     y-force     z-force    magnitude\n"
         " line#2  resultant  moments       x-moment    y-moment    z-moment   magnitude\n"
         " line#3  centroids                x           y           z            area  \n";
}

std::string secforc_text(double time, std::span<const SectionState> sections) {
  std::string text;
  for (const SectionState& s : sections) {
    text += fmt::format("{:12}{}", s.section, scientific(time, 15, 5)) + section_row(s.force, s.force.stableNorm());
    text += fmt::format("{:27}", "global system") + section_row(s.moment, s.moment.stableNorm());
    text += fmt::format("{:27}", "") + section_row(s.centroid, s.area) + '\n';
  }
  return text;
}

History<SectionState> read_secforc(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  History<SectionState> history;
  ResultText file(text, name, diagnostics);
  SectionState section;
  int line = 0;  // of the three of a section; 0: before the first section
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    const std::string_view words = trimmed(file.line());
    if (words.starts_with("line#3")) line = 1;
    if (words.empty() || words.starts_with("line#") || line == 0) continue;
    std::string_view rest = line == 1 ? file.line() : behind_columns(file.line(), words_of_row);
    if (line == 1) {
      const auto id = take_integer(rest);
      if (!id) {
        file.unreadable();
        continue;
      }
      section = {};
      section.section = *id;
      history.at(file.take(rest));
      section.force = take_vector(file, rest);
    } else if (line == 2) {
      section.moment = take_vector(file, rest);
    } else {
      section.centroid = take_vector(file, rest);
      section.area = file.take(rest);
      history.add(section);
    }
    line = line % 3 + 1;
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
