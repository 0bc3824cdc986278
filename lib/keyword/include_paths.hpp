#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "keyword/card.hpp"

namespace gapcheck::keyword {

/// The longest name that is read; a longer one is kept with one character more, so that it can be told.
constexpr std::size_t max_include_name = 236;

/// A file name as an include gives it.
struct IncludeName {
  std::string name;
  std::uint32_t line = 0;
};

/// The next file name of the block of `reader`; a line that ends in " +" continues in the next, and `&name` is a
/// parameter of type C. Nothing at the end of the block.
std::optional<IncludeName> next_include_name(CardReader& reader, const Parameters& parameters);

/// A name with a drive letter, backslashes or an absolute path: what it leads to may be on another machine only.
[[nodiscard]] bool may_be_of_another_machine(const std::string& name);

/// Where an include was found.
struct FoundInclude {
  std::string path;
  bool by_end = false;  ///< not where the name says: by the end of the name
  std::string other;    ///< then: a different file that would have done as well; empty: none
};

/// Where included files are looked for.
class IncludePaths {
 public:
  static constexpr std::size_t most = 200;
  /// `further`: the paths of the options, the last to be searched; must outlive this.
  explicit IncludePaths(const std::vector<std::string>& further) : further_(further) {}
  /// *INCLUDE_PATH. Known paths change nothing; false if there are too many.
  bool add(const std::string& path);
  /// The first place that has the file: working directory, directory of the main file, of the including file, the paths
  /// added so far, those of the options. Names of another machine then by their last three parts, their last two and
  /// the last one: beside the including file, beside the main one, in the paths added so far, in those of the options;
  /// a file that was taken for another such name is passed over.
  /// So is one that `open` accepts, by its canonical path: it includes the file with the name.
  [[nodiscard]] std::optional<FoundInclude> find(const std::string& name, const std::string& main_file,
                                                 const std::string& including_file,
                                                 const std::function<bool(const std::string&)>& open);
  /// A file with the longest end of the name, where find() looks for names of another machine.
  [[nodiscard]] std::optional<FoundInclude> find_by_end(const std::string& name, const std::string& main_file,
                                                        const std::string& including_file,
                                                        const std::function<bool(const std::string&)>& open) const;

 private:
  const std::vector<std::string>& further_;
  std::vector<std::string> paths_;
  std::map<std::string, std::string> taken_;  ///< files found by the end of a name, and that name
};

}  // namespace gapcheck::keyword
