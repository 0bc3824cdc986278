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
  if (!std::exchange(scanned_, true)) marks_ = marks_of_file(bytes());
  return marks_;
}

Result<std::shared_ptr<KeywordFile>> FileCache::open(const std::string& path, const std::string& canonical) {
  const std::string& key = canonical.empty() ? path : canonical;
  if (const auto known = files_.find(key); known != files_.end()) {
    ++shared_;
    return known->second;
  }
  auto mapped = MappedFile::open(path);
  if (!mapped) return mapped.error();
  auto file = std::make_shared<KeywordFile>(std::move(mapped).value());
  files_.emplace(key, file);
  return file;
}

}  // namespace gapcheck::keyword
