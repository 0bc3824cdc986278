#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace gapcheck::app::lsp {

/// Which deck an include belongs to: looked for among the deck files of some folders, by what these include. Files are
/// read again only if they have changed. Not for use by two threads at a time.
class MainDecks {
 public:
  /// Reads the deck files in and below the folders, at most ten thousand of them. Stops when `go_on` says no.
  void scan(const std::vector<std::string>& folders, const std::function<bool()>& go_on);
  /// The main file of a deck that includes a file, directly or not: of several one in `preferred`, else the first by
  /// name. The file itself if nothing includes it. Paths are canonical.
  [[nodiscard]] std::string main_of(const std::string& file, const std::set<std::string>& preferred) const;

 private:
  struct Entry {
    std::filesystem::file_time_type written;
    std::uintmax_t size = 0;
    std::set<std::string> found;    ///< included files that are there
    std::set<std::string> missing;  ///< last parts of the names of those that are not found
  };
  void look_at(const std::filesystem::path& file);
  [[nodiscard]] std::vector<std::string> includers(const std::string& file) const;
  std::map<std::string, Entry> files_;
};

}  // namespace gapcheck::app::lsp
