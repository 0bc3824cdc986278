#include "keyword/file_cache.hpp"

#include <utility>

namespace gapcheck::keyword {

std::vector<Mark> marks_of_file(std::string_view bytes) {
  const std::size_t begin = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  std::vector<Mark> marks = find_marks(bytes.substr(begin));
  for (Mark& mark : marks) mark.offset += begin;
  return marks;
}

const std::vector<Mark>& KeywordFile::marks() {
  if (!std::exchange(scan_->done, true)) scan_->marks = marks_of_file(bytes());
  return scan_->marks;
}

void KeywordFile::drop(std::string_view part) {
  if (!text_.empty() || kept_) return;
  const auto begin = static_cast<std::size_t>(part.data() - bytes().data());
  file_.release(begin, begin + part.size());
  complete_ = false;
}

std::uint64_t FileCache::used_tables() const {
  std::uint64_t used = 0;
  for (const auto& [name, entry] : files_) used += entry.scan->rows.used();
  return used;
}

/// Keeps an included file if its bytes are allowed.
void FileCache::keep(Entry& entry) {
  if (*left_ == 0 || *left_ < entry.stamp.size) return;
  *left_ -= entry.stamp.size;
  entry.kept = entry.file.lock();
  entry.kept->keep();
  entry.scan->rows = KeptRows(left_);
}

Result<std::shared_ptr<KeywordFile>> FileCache::open(const std::string& path, const std::string& canonical,
                                                     bool included) {
  const std::string& key = canonical.empty() ? path : canonical;
  const auto known = files_.find(key);
  if (known != files_.end()) {
    auto file = known->second.file.lock();
    // A kept file may have changed since an earlier deck was read.
    const bool current = known->second.kept == nullptr || known->second.kept->unchanged().ok();
    if (file != nullptr && file->complete() && current) {
      ++shared_;
      return file;
    }
  }
  auto read = FileBytes::open(path);
  if (!read) return read.error();
  if (const Status same = read.value().unchanged(); !same.ok()) return same.error();
  const FileStamp stamp = read.value().stamp();
  const bool shared = known != files_.end() && known->second.stamp == stamp;
  shared_ += shared ? 1 : 0;
  auto scan = shared ? known->second.scan : std::make_shared<FileScan>();
  auto file = std::make_shared<KeywordFile>(std::move(read).value(), scan);
  Entry& entry = files_.insert_or_assign(key, Entry{file, stamp, std::move(scan), nullptr}).first->second;
  if (included) keep(entry);
  return file;
}

}  // namespace gapcheck::keyword
