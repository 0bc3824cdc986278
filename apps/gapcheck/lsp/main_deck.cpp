#include "lsp/main_deck.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "base/file_bytes.hpp"
#include "base/number.hpp"
#include "keyword/file_cache.hpp"
#include "keyword/keyword_line.hpp"
#include "keyword/scan.hpp"
#include "keyword/upper_case.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 10'000, most_entries = 200'000, most_names = 10'000;
constexpr int deepest_folder = 12;

bool is_deck_name(const fs::path& path) {
  constexpr std::array<std::string_view, 8> endings{".K", ".KEY", ".DYN", ".INC", ".KW", ".KEYWORD", ".LSD", ".ASC"};
  const std::string ending = keyword::upper_case(path.extension().string());
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// What the includes of a file name, and its *INCLUDE_PATHs.
struct NamedFiles {
  std::vector<std::string> names, paths;
};

NamedFiles names_in(std::string_view bytes) {
  NamedFiles named;
  keyword::Format format = keyword::Format::standard;
  for (const keyword::Mark& mark : keyword::marks_of_file(bytes)) {
    if (mark.kind != keyword::Mark::Kind::keyword) continue;
    std::size_t at = 0;
    const std::string name = keyword::read_keyword_line(keyword::line_at(bytes, mark.offset, at), format).name;
    if (name == "END") break;
    if (!name.starts_with("INCLUDE")) continue;
    std::vector<std::string>& to = name.starts_with("INCLUDE_PATH") ? named.paths : named.names;
    bool continued = false;
    while (at < bytes.size() && bytes[at] != '*' && to.size() < most_names) {
      std::string_view line = trimmed(keyword::line_at(bytes, at, at));
      if (line.empty() || line.starts_with('$')) continue;
      const bool goes_on = line.ends_with(" +");
      if (goes_on) line = trimmed(line.substr(0, line.size() - 2));
      if (!continued) to.emplace_back();
      to.back() += line;
      continued = goes_on;
    }
  }
  return named;
}

std::string last_part(std::string_view name) {
  const std::size_t cut = name.find_last_of("/\\:");
  return std::string(cut == std::string_view::npos ? name : name.substr(cut + 1));
}

}  // namespace

void MainDecks::look_at(const fs::path& file) {
  std::error_code failed;
  const auto written = fs::last_write_time(file, failed);
  const std::uintmax_t size = failed ? 0 : fs::file_size(file, failed);
  if (failed) return;
  Entry& entry = files_[canonical(file.string())];
  if (entry.size == size && entry.written == written) return;
  entry = {written, size, {}, {}};
  const auto bytes = FileBytes::open(file.string());
  if (!bytes) return;
  const NamedFiles named = names_in(bytes.value().bytes());
  for (std::string name : named.names) {
    std::replace(name.begin(), name.end(), '\\', '/');
    std::vector<fs::path> places{file.parent_path() / name};
    for (const std::string& path : named.paths) places.push_back(file.parent_path() / path / name);
    const auto place = std::find_if(places.begin(), places.end(),
                                    [&](const fs::path& each) { return fs::is_regular_file(each, failed); });
    if (place != places.end())
      entry.found.insert(canonical(place->string()));
    else
      entry.missing.insert(last_part(name));
  }
}

void MainDecks::scan(const std::vector<std::string>& folders, const std::function<bool()>& go_on) {
  std::erase_if(files_, [](const auto& file) {
    std::error_code unknown;
    return !fs::is_regular_file(file.first, unknown);
  });
  std::size_t files = 0, entries = 0;
  for (const std::string& folder : folders) {
    std::error_code failed;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && at != fs::recursive_directory_iterator(); at.increment(failed)) {
      if (++entries > most_entries || files >= most_files || !go_on()) return;
      const std::string name = at->path().filename().string();
      std::error_code unknown;
      if (at->is_directory(unknown) && (name.starts_with('.') || at.depth() >= deepest_folder))
        at.disable_recursion_pending();
      if (!is_deck_name(at->path()) || !at->is_regular_file(unknown)) continue;
      ++files;
      look_at(at->path());
    }
  }
}

std::vector<std::string> MainDecks::includers(const std::string& file) const {
  std::vector<std::string> list;
  const std::string name = last_part(file);
  for (const auto& [path, entry] : files_)
    if (path != file && (entry.found.contains(file) || entry.missing.contains(name))) list.push_back(path);
  return list;
}

std::string MainDecks::main_of(const std::string& file, const std::set<std::string>& preferred) const {
  std::set<std::string> seen{file}, mains;
  std::vector<std::string> open{file};
  while (!open.empty()) {
    const std::string at = open.back();
    open.pop_back();
    const std::vector<std::string> above = includers(at);
    if (above.empty()) mains.insert(at);
    for (const std::string& each : above)
      if (seen.insert(each).second) open.push_back(each);
  }
  for (const std::string& each : mains)
    if (preferred.contains(each)) return each;
  return mains.empty() ? file : *mains.begin();
}

}  // namespace gapcheck::app::lsp
