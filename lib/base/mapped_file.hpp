#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace gapcheck {

/// A whole file mapped read-only into memory. `bytes()` stays valid, at the same address, as long as the object lives,
/// even if it is moved. Limits: a file that another program shortens while it is mapped ends the process (SIGBUS), as
/// with every mapping.
class MappedFile {
 public:
  /// Errors: missing, directory, no permission, not a regular file. An empty file is fine and has no bytes.
  static Result<MappedFile> open(const std::string& path);
  MappedFile() = default;
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile();
  [[nodiscard]] std::string_view bytes() const { return {data_, size_}; }
  /// Releases the memory of the bytes read so far; reading them again takes it again.
  void release() const;

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace gapcheck
