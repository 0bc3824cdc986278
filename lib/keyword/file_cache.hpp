#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_bytes.hpp"
#include "base/result.hpp"
#include "keyword/scan.hpp"
#include "keyword/text/kept_rows.hpp"

namespace gapcheck::keyword {

/// The lines that structure a file; a byte order mark at its start is not one of them.
[[nodiscard]] std::vector<Mark> marks_of_file(std::string_view bytes);

/// What is known of a file's text: the lines that structure it, once they have been found, and tables kept for later
/// decks.
struct FileScan {
  std::vector<Mark> marks;
  bool done = false;
  KeptRows rows;
};

/// A file in memory and the lines that structure it, found only once.
class KeywordFile {
 public:
  KeywordFile(FileBytes file, std::shared_ptr<FileScan> scan) : file_(std::move(file)), scan_(std::move(scan)) {}
  /// A text in place of a file; it must outlive this.
  explicit KeywordFile(std::string_view text) : text_(text), scan_(std::make_shared<FileScan>()) {}
  [[nodiscard]] std::string_view bytes() const { return text_.empty() ? file_.bytes() : text_; }
  [[nodiscard]] const std::vector<Mark>& marks();
  /// Frees the memory of a part of the bytes, which must not be used any more. Kept files stay as they are.
  void drop(std::string_view part);
  void keep() { kept_ = true; }
  /// Of the bytes of a file that is kept; nullptr: it is not.
  [[nodiscard]] std::shared_ptr<FileScan> kept() const { return kept_ ? scan_ : nullptr; }
  [[nodiscard]] bool complete() const { return complete_; }
  /// An error if the file on disk has been written to since it was read.
  [[nodiscard]] Status unchanged() const { return text_.empty() ? file_.unchanged() : Status(); }

 private:
  FileBytes file_;
  std::string_view text_;
  std::shared_ptr<FileScan> scan_;
  bool complete_ = true, kept_ = false;
};

/// Files of one or more decks, each scanned once however often it is included. A file stays in memory as long as a deck
/// uses it; a later deck reads it again, and scans it again if it has changed. Of files that are included, as many
/// bytes as allowed are kept for later decks, as text and as tables. Not for use by two threads at a time.
class FileCache {
 public:
  /// From now on, at most so many bytes are kept. At first none are: one deck alone needs its files only once.
  void keep_included(std::uint64_t bytes) { *left_ = bytes; }
  /// `canonical` identifies files. Errors: those of FileBytes::open(), and a file that changes while it is read. They
  /// are not kept.
  Result<std::shared_ptr<KeywordFile>> open(const std::string& path, const std::string& canonical,
                                            bool included = false);
  /// How often a file was already in the cache.
  [[nodiscard]] std::uint64_t shared() const { return shared_; }
  /// How often a table of rows was there from an earlier deck.
  [[nodiscard]] std::uint64_t used_tables() const;

 private:
  struct Entry {
    std::weak_ptr<KeywordFile> file;
    FileStamp stamp;
    std::shared_ptr<FileScan> scan;
    std::shared_ptr<KeywordFile> kept;
  };
  void keep(Entry& entry);

  std::map<std::string, Entry> files_;
  std::shared_ptr<std::uint64_t> left_ = std::make_shared<std::uint64_t>(0);  ///< bytes that may still be kept
  std::uint64_t shared_ = 0;
};

}  // namespace gapcheck::keyword
