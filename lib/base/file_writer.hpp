#pragma once
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace gapcheck {

/// Writes a file so that its name has either what was there before or all of the new text, whatever happens in between:
/// a new file in the same folder takes the name over at the end. Its name begins with ".gapcheck-". Symbolic links stay
/// and lead to the new text; the permissions of the old file stay; other hard links keep the old text. What is not a
/// regular file (terminal, pipe, /dev/stdout) is written directly, and so is a file whose folder takes no new ones.
class FileWriter {
 public:
  /// Errors: the file cannot be written.
  static Result<FileWriter> create(const std::string& path);
  FileWriter(FileWriter&& other) noexcept;
  FileWriter& operator=(FileWriter&&) = delete;
  /// Without commit() nothing has happened.
  ~FileWriter();

  /// False from the first failure on; commit() says which.
  bool write(std::string_view text);
  /// Everything is on the disk, the name still has what was there before. The first failure, if there was any.
  [[nodiscard]] Status finish();
  /// finish(), and the name gets the new text.
  [[nodiscard]] Status commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  class Temporary;

  FileWriter(std::string path, std::string target);
  [[nodiscard]] Diagnostic failure(int error) const;
  [[nodiscard]] Status open_directly();
  [[nodiscard]] int put_over();

  std::string path_, target_;  ///< as given, and where links lead
  std::unique_ptr<std::FILE, Close> file_;
  std::unique_ptr<Temporary> temporary_;  ///< none: written directly
  bool replaces_ = false;                 ///< there is an old file
  int error_ = 0;
};

/// A whole file at once, by a FileWriter.
[[nodiscard]] Status write_file(const std::string& path, std::string_view text);

/// Which file an open one is, whatever its name, and how long it is.
struct FileId {
  std::uint64_t device = 0, inode = 0, size = 0;
};
[[nodiscard]] FileId id_of(std::FILE* file);
/// For files that are written as results come. An error if the name does not lead to this file: it was removed, moved
/// or replaced meanwhile. `closed`: it is known by its size, since its inode may be another file's by now.
[[nodiscard]] Status check_name(const std::string& path, const FileId& file, bool closed);

/// Deletes the files that writers have not committed. For signal handlers that end the process: async-signal-safe, and
/// no writer works any more afterwards.
void remove_uncommitted_files() noexcept;

}  // namespace gapcheck
