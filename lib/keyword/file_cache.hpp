#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/mapped_file.hpp"
#include "base/result.hpp"
#include "keyword/scan.hpp"

namespace gapcheck::keyword {

/// The lines that structure a file; a byte order mark at its start is not one of them.
[[nodiscard]] std::vector<Mark> marks_of_file(std::string_view bytes);

/// A file on disk and the lines that structure it, found only once.
class KeywordFile {
 public:
  explicit KeywordFile(MappedFile mapping) : mapping_(std::move(mapping)) {}
  [[nodiscard]] std::string_view bytes() const { return mapping_.bytes(); }
  [[nodiscard]] const std::vector<Mark>& marks();
  /// Releases the memory of the pages; they can be read again.
  void release() const { mapping_.release(); }

 private:
  MappedFile mapping_;
  std::vector<Mark> marks_;
  bool scanned_ = false;
};

/// Files of one or more decks, each mapped and scanned once however often it is included. Keeps them all. Not for use
/// by two threads at a time. A file that changes after it was opened here is not read again.
class FileCache {
 public:
  /// `canonical` identifies files. Errors: those of MappedFile::open(), which are not kept.
  Result<std::shared_ptr<KeywordFile>> open(const std::string& path, const std::string& canonical);
  /// How often a file was already in the cache.
  [[nodiscard]] std::uint64_t shared() const { return shared_; }

 private:
  std::map<std::string, std::shared_ptr<KeywordFile>> files_;
  std::uint64_t shared_ = 0;
};

}  // namespace gapcheck::keyword
