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
  if (!text_.empty()) return;
  const auto begin = static_cast<std::size_t>(part.data() - bytes().data());
  file_.release(begin, begin + part.size());
  complete_ = false;
}

Result<std::shared_ptr<KeywordFile>> FileCache::open(const std::string& path, const std::string& canonical) {
  const std::string& key = canonical.empty() ? path : canonical;
  const auto known = files_.find(key);
  if (known != files_.end())
    if (auto file = known->second.file.lock(); file != nullptr && file->complete()) {
      ++shared_;
      return file;
    }
  auto read = FileBytes::open(path);
  if (!read) return read.error();
  if (const Status same = read.value().unchanged(); !same.ok()) return same.error();
  const FileStamp stamp = read.value().stamp();
  const bool shared = known != files_.end() && known->second.stamp == stamp;
  shared_ += shared ? 1 : 0;
  auto scan = shared ? known->second.scan : std::make_shared<FileScan>();
  auto file = std::make_shared<KeywordFile>(std::move(read).value(), scan);
  files_.insert_or_assign(key, Entry{file, stamp, std::move(scan)});
  return file;
}

}  // namespace gapcheck::keyword
