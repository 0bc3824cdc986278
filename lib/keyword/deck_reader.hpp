#pragma once
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "keyword/card.hpp"
#include "keyword/highest_ids.hpp"
#include "keyword/include_paths.hpp"
#include "keyword/include_transforms.hpp"
#include "keyword/repeated_includes.hpp"
#include "keyword/scan.hpp"

namespace gapcheck::keyword {

/// The transformations of the blocks of one file. *INCLUDE_AUTO_OFFSET shifts the ids of nodes and elements where they
/// are defined and in the elements, but not in sets and other lists.
struct FileTransforms {
  TransformIndex mesh{0}, others{0};
};

/// What the blocks of one file share.
struct FileContext {
  FileIndex file;
  Format format = Format::standard;
  FileTransforms transforms;
  std::uint32_t scope = Parameters::global, depth = 0;
};

/// What becomes of a parameter that is defined again.
struct ParameterDuplicates {
  std::int64_t flag = 1;  ///< DFLAG of *PARAMETER_DUPLICATION: 1, 3, 5 keep the first value, 2 and 4 take the new one
  std::map<std::pair<std::string, std::uint32_t>, bool> defined;  ///< by upper-case name and scope: whether _MUTABLE
};

/// Builds a deck: follows includes, collects parameters, and resolves transformations once everything is read.
class DeckReader {
 public:
  DeckReader(const ReadOptions& options, Diagnostics& diagnostics)
      : options_(options), diagnostics_(diagnostics), paths_(options.include_directories) {}
  Result<Deck> read_path(const std::string& path);
  Result<Deck> read_text(std::string text, const std::string& name);

 private:
  Result<Deck> read_all(const std::string& path, std::string_view bytes, const std::vector<Mark>& marks);
  Result<Deck> finish();

  // deck.cpp: one file
  [[nodiscard]] Result<std::shared_ptr<KeywordFile>> open_file(const std::string& path, const std::string& canonical);
  FileIndex add_file(const std::string& path, std::string_view bytes, const FileContext* includer, std::uint32_t line);
  void read_file(FileContext context, const std::vector<Mark>& marks);
  bool add_block(Block block, const FileContext& context, bool templated);
  void dispatch(const FileContext& context, const Block& block);

  // read_includes.cpp
  void read_include(const FileContext& context, const Block& block);
  void read_include_path(CardReader& reader, bool relative);
  void open_transformed(const FileContext& context, CardReader& reader, const IncludeName& include);
  void open_shifted(const FileContext& context, CardReader& reader, const IncludeName& include);
  bool open_include(const FileContext& context, const Block& block, const IncludeName& include,
                    FileTransforms transforms);
  [[nodiscard]] std::shared_ptr<KeywordFile> map_include(const std::string& path, const std::string& canonical,
                                                         const Block& block, std::uint32_t line);

  // read_parameters.cpp
  void read_parameters(const Block& block);

  [[nodiscard]] const std::string& path_of(FileIndex file) const { return deck_.files_[file.value].path; }

  const ReadOptions& options_;
  Diagnostics& diagnostics_;
  Deck deck_;
  FileCache own_;                       ///< where the options give none
  std::vector<std::string> canonical_;  ///< beside Deck::files_
  RepeatedIncludes repeats_;
  IncludePaths paths_;
  IncludeTransforms transforms_;
  HighestIds highest_;
  ParameterDuplicates duplicates_;
  std::size_t includes_ = 0;      ///< names of includes so far
  std::set<std::int64_t> cases_;  ///< whose *CASE_BEGIN was read; 0: one without a number
  bool stopped_ = false;          ///< a limit was exceeded: nothing more is read
};

}  // namespace gapcheck::keyword
