#include "results/curves/binout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/file_bytes.hpp"
#include "results/curves/binout_histories.hpp"
#include "results/curves/binout_states.hpp"
#include "results/curves/lsda.hpp"
#include "results/text/binout_name.hpp"

namespace gapcheck::results {
namespace {

/// "/glstat/d000001" is a state of the branch glstat, "/glstat/metadata" is for all of them.
struct BinoutPlace {
  std::string branch;
  bool metadata = false, state = false;
};

BinoutPlace place_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  if (!path.starts_with('/') || slash == 0) return {};
  const std::string_view last = path.substr(slash + 1);
  return {
      std::string(path.substr(1, slash - 1)), last == "metadata",
      last.starts_with('d') && last.size() > 1 && last.find_first_not_of("0123456789", 1) == std::string_view::npos};
}

/// Collects the states of all files of a run.
class BinoutCollector {
 public:
  BinoutCollector(RunResults& run, std::vector<std::string> wanted) : run_(run), wanted_(std::move(wanted)) {}

  void take(const LsdaArray& array) {
    if (array.path() != path_) {
      finish(false);
      path_ = array.path();
      place_ = place_of(path_);
      const std::string file = place_.branch.substr(0, place_.branch.find('/'));
      chosen_ = std::find(wanted_.begin(), wanted_.end(), file) != wanted_.end();
    }
    if (!chosen_) return;
    if (place_.metadata) add_metadata(meta_[place_.branch], array);
    if (place_.state) row_.add(array);
  }

  /// The last state; `end_of_file`: it is left out if it has fewer arrays than the one before it.
  void finish(bool end_of_file) {
    if (!row_.empty()) {
      BinoutMeta& meta = meta_[place_.branch];
      // A state in which all elements have failed has no ids.
      const bool failed = place_.branch.starts_with("elout/") && !row_.has("ids");
      const bool whole = !end_of_file || failed || row_.size() >= meta.arrays;
      meta.arrays = row_.size();
      if (!whole || !add_binout_state(place_.branch, meta, row_, run_)) ++left_out_;
    }
    row_.clear();
    if (end_of_file) path_.clear();
  }

  [[nodiscard]] std::size_t take_left_out() { return std::exchange(left_out_, 0); }

 private:
  void add_metadata(BinoutMeta& meta, const LsdaArray& array) {
    constexpr std::array<std::string_view, 11> lists{"ids",       "force_ids",    "moment_ids", "side",
                                                     "single",    "single_sided", "types",      "setid",
                                                     "num_nodal", "irot",         "local"};
    if (std::find(lists.begin(), lists.end(), array.name()) == lists.end()) return;
    std::vector<std::int64_t>& list = meta.lists[std::string(array.name())];
    list.resize(array.size());
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = array.integer(i);
    if (place_.branch == "rcforc") note_single_surfaces(meta);
  }

  void note_single_surfaces(const BinoutMeta& meta) {
    std::set<std::int64_t> single;
    for (std::size_t i = 0; i < meta.ids().size(); ++i)
      if (meta.is_single(i)) single.insert(meta.ids()[i]);
    run_.rcforc.single_surface.assign(single.begin(), single.end());
  }

  RunResults& run_;
  std::vector<std::string> wanted_;
  std::string path_;  ///< of the last array
  BinoutPlace place_;
  bool chosen_ = false;
  std::map<std::string, BinoutMeta> meta_;
  BinoutRow row_;
  std::size_t left_out_ = 0;
};

/// binout, binout0000, binout0000%001, …, sorted: a file comes before those that continue it.
std::vector<std::string> binout_files(const std::string& directory) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator entry(directory.empty() ? "." : directory, failed), end; !failed && entry != end;
       entry.increment(failed))
    if (is_binout_name(entry->path().filename().string())) names.push_back(entry->path().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// What a run has no text file of.
std::vector<std::string> wanted_files(const RunResults& run, bool nodes) {
  std::vector<std::string> wanted = run.missing;
  if (!nodes) std::erase(wanted, "nodout");
  std::error_code failed;
  for (const std::string_view file : history_files)
    if (nodes && !std::filesystem::exists(run.path(file), failed)) wanted.emplace_back(file);
  return wanted;
}

bool has_states(const RunResults& run, const std::string& name) {
  return (name == "glstat" && !run.glstat.empty()) || (name == "rcforc" && !run.rcforc.states.empty()) ||
         (name == "sleout" && !run.sleout.states.empty()) || (name == "matsum" && !run.matsum.states.empty()) ||
         (name == "nodout" && !run.nodout.states.empty());
}

}  // namespace

void read_binout(RunResults& run, bool nodes, Diagnostics& diagnostics) {
  BinoutCollector collector(run, wanted_files(run, nodes));
  for (const std::string& path : binout_files(run.directory)) {
    const auto file = FileBytes::open(path);
    if (!file) {
      diagnostics.add(file.error());
      continue;
    }
    const Status read = read_lsda(
        file.value().bytes(), path, [&](const LsdaArray& array) { collector.take(array); }, diagnostics);
    if (!read.ok()) {
      diagnostics.warning(path, 0, read.error().message);
      continue;
    }
    collector.finish(true);
    if (const std::size_t count = collector.take_left_out(); count > 0)
      diagnostics.warning(path, 0,
                          fmt::format("{} states without their time or the values of all ids are left out", count));
  }
  std::erase_if(run.missing, [&](const std::string& name) { return has_states(run, name); });
}

}  // namespace gapcheck::results
