#include "results/text/file_header.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gapcheck::results {

std::string column_text(std::string_view text, std::size_t width) {
  std::string column(text.substr(0, width));
  for (char& letter : column)
    if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = '?';
  column.resize(width, ' ');
  return column;
}

std::string header_text(const FileHeader& header) {
  return fmt::format(" {}\n                    {}\n", column_text(header.title, 72),
                     column_text(header.program, std::min<std::size_t>(header.program.size(), 60)));
}

std::string legend_text(std::vector<LegendEntry> entries, std::size_t width) {
  const auto before = [](const LegendEntry& a, const LegendEntry& b) { return a.id < b.id; };
  std::stable_sort(entries.begin(), entries.end(), before);
  std::string text = "\n{BEGIN LEGEND}\n Entity #        Title\n";
  for (const LegendEntry& entry : entries)
    text += fmt::format("{:9}     {}\n", entry.id, column_text(entry.title, width));
  return text + "{END LEGEND}\n";
}

}  // namespace gapcheck::results
