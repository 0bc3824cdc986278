#pragma once
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/file_writer.hpp"
#include "base/result.hpp"
#include "results/d3plot/d3plot_buffer.hpp"

namespace gapcheck::results {

/// The files of a database as they are written: the first one holds what lies before the states, files with the
/// suffixes 01, 02, … the states, each behind the other, with an end mark behind the last one.
class D3plotFamily {
 public:
  D3plotFamily() = default;
  /// Creates the first file and removes further ones of an older family. `member_words`: of a file of states; one that
  /// does not fit begins the next file, even if it alone is too large.
  static Result<D3plotFamily> create(const std::string& path, std::string_view first, int word_bytes,
                                     std::uint64_t member_words);
  [[nodiscard]] Status append(WordBuffer state);
  /// An error if one of the files is no longer where it was written.
  [[nodiscard]] Status check_names() const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[nodiscard]] Status open_member();

  std::string path_, member_path_;
  int word_bytes_ = 4;
  std::uint64_t member_words_ = 0;
  std::uint32_t member_ = 0;
  std::uint64_t position_ = 0;  ///< words of states in the member
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::pair<std::string, FileId>> written_;  ///< all files, the open one last
};

/// Removes a database's files, also behind a gap: the next one may fill it, and they would be taken for its states. The
/// first file too, so that what is linked to it stays.
void remove_family(const std::string& path);

}  // namespace gapcheck::results
