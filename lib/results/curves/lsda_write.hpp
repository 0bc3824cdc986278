#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/file_writer.hpp"
#include "base/result.hpp"
#include "results/curves/lsda.hpp"

namespace gapcheck::results {

struct LsdaWriteSettings {
  std::uint64_t member_bytes = std::uint64_t{1} << 30;  ///< a file that has become so long is continued in another one
};

/// Writes an LSDA file as its numbers come: lengths and offsets of eight bytes, commands and types of one, in this
/// machine's byte order, as LS-DYNA does in double precision. Each flush() ends with a table of the symbols since the
/// last one, which the table before it (of the first one, a record at the beginning) refers to: readers that know the
/// symbols only and those that go through all records see the same. Files after the first are named "PATH%001", ….
class LsdaWriter {
 public:
  static Result<LsdaWriter> create(const std::string& path, const LsdaWriteSettings& settings = {});

  /// What follows lies in this directory, an absolute path.
  void change_directory(std::string_view path);
  /// Arrays of the directory; names have at most 255 bytes.
  void text(std::string_view name, std::string_view value);
  void integers(std::string_view name, std::span<const std::int64_t> values);
  void reals(std::string_view name, std::span<const double> values);
  void integer(std::string_view name, std::int64_t value) { integers(name, {&value, 1}); }
  void real(std::string_view name, double value) { reals(name, {&value, 1}); }

  /// Everything so far is in the file, visible to other programs. The first failure since the last call is reported.
  [[nodiscard]] Status flush();
  /// An error if one of the files is no longer where it was written.
  [[nodiscard]] Status check_names() const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  struct Symbol {
    std::string directory, name;
    LsdaArray::Type type;
    std::uint64_t record, count;
  };

  [[nodiscard]] Status open_member();
  /// Between two tables: begins the next file if this one is long enough.
  void continue_if_full();
  void array(std::string_view name, LsdaArray::Type type, const char* bytes, std::size_t size, std::uint64_t count);
  void append_table();
  /// Moves the buffer into the file.
  [[nodiscard]] bool write_buffer();
  /// Lets the last table, or the beginning, refer to the table at `table`.
  [[nodiscard]] bool refer_to(std::uint64_t table);
  [[nodiscard]] Diagnostic failure() const;

  std::string path_, member_path_;
  LsdaWriteSettings settings_;
  std::uint32_t member_ = 0;
  std::unique_ptr<std::FILE, Close> file_;
  std::string buffer_;           ///< records that are not in the file yet
  std::uint64_t written_ = 0;    ///< bytes that are
  std::uint64_t reference_ = 0;  ///< where the offset of the next table belongs
  std::string directory_;        ///< of the last record
  std::vector<Symbol> symbols_;  ///< since the last table
  int error_ = 0;
  std::vector<std::pair<std::string, FileId>> files_;  ///< all, the open one last
};

}  // namespace gapcheck::results
