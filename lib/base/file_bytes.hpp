#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace gapcheck {

/// Which file it is and in which state. Equal stamps: the same file, not written to in between.
struct FileStamp {
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;  ///< of the last change of its content
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// The bytes of a file in memory of the process: not a mapping, because a mapped file that another program shortens
/// ends the process (SIGBUS). They are read at once, or piece by piece. Bytes stay at the same address as long as the
/// object lives, even if it is moved.
class FileBytes {
 public:
  /// All bytes. Errors: missing, directory, no permission, not a regular file, shortened while it is read. An empty
  /// file is fine and has no bytes.
  static Result<FileBytes> open(const std::string& path);
  /// No bytes yet: those up to a position come with load().
  static Result<FileBytes> begin(const std::string& path);

  FileBytes() = default;
  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&& other) noexcept;
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;
  ~FileBytes();

  /// What has been read.
  [[nodiscard]] std::string_view bytes() const { return {data_, loaded_}; }
  /// Of the whole file when it was opened. What others append later is not read.
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(stamp_.size); }
  /// Reads on until at least the first `end` bytes, or all, are there. Errors: as open().
  [[nodiscard]] Status load(std::size_t end);
  /// Frees the memory of whole pages in [begin, end). These bytes must not be used any more.
  void release(std::size_t begin, std::size_t end);

  /// As it was opened.
  [[nodiscard]] const FileStamp& stamp() const { return stamp_; }
  /// An error if the name now leads to another file, or the file has been written to since it was opened.
  [[nodiscard]] Status unchanged() const;

 private:
  [[nodiscard]] Status read_piece(std::size_t begin, std::size_t end) const;

  std::string path_;
  FileStamp stamp_;
  int fd_ = -1;  ///< until everything has been read
  char* data_ = nullptr;
  std::size_t loaded_ = 0;
};

}  // namespace gapcheck
