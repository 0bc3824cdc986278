#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::results {

/// In the control words of a d3plot, where the solver has its release: who wrote it.
constexpr std::string_view d3plot_mark = "gapc";

/// A name that `gapcheck run` gives to results: messag, d3hsp, glstat, …, d3plot, d3plot01, …, intfor, …, binout0000,
/// …; or one that readers of these would take for such a result, as binout.
[[nodiscard]] bool is_result_name(std::string_view name);

/// The entries of a directory that have such names, sorted. Empty: the working directory.
[[nodiscard]] std::vector<std::string> result_files(const std::string& directory);

/// Those of them that are not gapcheck's own: messag and d3hsp without its banner, texts without its name below the
/// title, a d3plot, intfor or binout without its mark, d3plot01, … without a d3plot of gapcheck. Empty files are
/// nobody's.
[[nodiscard]] std::vector<std::string> foreign_results(const std::string& directory);

}  // namespace gapcheck::results
