#pragma once
#include <cstdint>
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

/// Where included files are looked for.
class IncludePaths {
 public:
  static constexpr std::size_t most = 200;
  /// `further`: the paths of the options, the last to be searched; must outlive this.
  explicit IncludePaths(const std::vector<std::string>& further) : further_(further) {}
  /// *INCLUDE_PATH. Known paths change nothing; false if there are too many.
  bool add(const std::string& path);
  /// The first place that has the file: working directory, directory of the main file, of the including file, the paths
  /// added so far, those of the options.
  [[nodiscard]] std::optional<std::string> find(const std::string& name, const std::string& main_file,
                                                const std::string& including_file) const;

 private:
  const std::vector<std::string>& further_;
  std::vector<std::string> paths_;
};

}  // namespace gapcheck::keyword
