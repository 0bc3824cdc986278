#include "results/d3plot/run_folder.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "results/d3plot/d3plot_header.hpp"
#include "results/text/binout_name.hpp"

namespace gapcheck::results {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view plot_name = "d3plot", intfor_name = "intfor";

/// The first file of the database to which d3plot01, intfor01, … belong; empty: they belong to none.
std::string_view first_of_member(std::string_view name) {
  for (const std::string_view first : {plot_name, intfor_name})
    if (name.starts_with(first) && name.size() > first.size() &&
        name.find_first_not_of("0123456789", first.size()) == std::string_view::npos)
      return first;
  return {};
}

/// The beginning of a file, which says who wrote it.
std::string head_of(const fs::path& path) {
  std::string head(4096, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool has_plot_mark(std::string_view head) {
  for (const std::size_t word : {4, 8})
    if (head.size() > control_words::release * word &&
        head.substr(control_words::release * word).starts_with(d3plot_mark))
      return true;
  return false;
}

/// Banner of the logs; or the program's name in the line below the title, which is the first one.
bool has_text_mark(std::string_view head) {
  if (head.find("|  gapcheck, explicit verification solver ") != std::string_view::npos) return true;
  const std::size_t second = head.find('\n');
  if (second == std::string_view::npos) return false;
  const std::size_t begin = head.find_first_not_of(' ', second + 1);
  return begin != std::string_view::npos && head.substr(begin).starts_with("gapcheck ");
}

/// The first file of a binout has the metadata.
fs::path binout_beginning(const fs::path& path) {
  const std::string name = path.filename().string();
  return path.parent_path() / name.substr(0, name.find('%'));
}

bool is_own(const fs::path& path) {
  const std::string name = path.filename().string();
  if (is_binout_name(name)) return has_binout_mark(head_of(binout_beginning(path)));
  if (const std::string_view first = first_of_member(name); !first.empty())
    return has_plot_mark(head_of(path.parent_path() / first));
  return name == plot_name || name == intfor_name ? has_plot_mark(head_of(path)) : has_text_mark(head_of(path));
}

}  // namespace

bool is_result_name(std::string_view name) {
  constexpr std::array<std::string_view, 17> names{"messag", "d3hsp",  "glstat",  "matsum",  "nodout",   "rcforc",
                                                   "sleout", "ncforc", "secforc", "spcforc", "bndout",   "rwforc",
                                                   "rbdout", "swforc", "elout",   plot_name, intfor_name};
  return std::find(names.begin(), names.end(), name) != names.end() || !first_of_member(name).empty() ||
         is_binout_name(name);
}

std::vector<std::string> result_files(const std::string& directory) {
  std::vector<std::string> files;
  std::error_code failed;
  const fs::path folder(directory), place = directory.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator entry(place, failed), end; !failed && entry != end; entry.increment(failed))
    if (const fs::path name = entry->path().filename(); is_result_name(name.string()))
      files.push_back((folder / name).string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> foreign_results(const std::string& directory) {
  std::vector<std::string> files = result_files(directory);
  std::erase_if(files, [](const std::string& file) {
    std::error_code failed;
    return (fs::is_regular_file(file, failed) && fs::file_size(file, failed) == 0) || is_own(file);
  });
  return files;
}

}  // namespace gapcheck::results
