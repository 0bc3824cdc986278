#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::results {

/// The beginning of every result file of a run.
struct FileHeader {
  std::string title;    ///< of the model
  std::string program;  ///< "gapcheck 0.1.0"
};

/// A line of a legend.
struct LegendEntry {
  std::int64_t id = 0;
  std::string title;
};

/// Title line and, indented below it, the program that wrote the file: where the solver has its version.
[[nodiscard]] std::string header_text(const FileHeader& header);

/// The block from {BEGIN LEGEND} to {END LEGEND}, by id. `width`: of the titles.
[[nodiscard]] std::string legend_text(std::vector<LegendEntry> entries, std::size_t width);

/// The text in a column of this width: cut or filled with blanks, control characters replaced by '?'.
[[nodiscard]] std::string column_text(std::string_view text, std::size_t width);

}  // namespace gapcheck::results
