#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/file_bytes.hpp"
#include "base/result.hpp"

namespace gapcheck::results {

/// How a database writes its numbers.
struct WordForm {
  std::size_t bytes = 4;  ///< 4 or 8
  bool swapped = false;   ///< the other byte order than this machine's
};

namespace words {

template <class Bits>
Bits load(const char* at, bool swapped) {
  Bits bits;
  std::memcpy(&bits, at, sizeof bits);
  if (!swapped) return bits;
  if constexpr (sizeof bits == 4)
    return __builtin_bswap32(bits);
  else
    return __builtin_bswap64(bits);
}

inline std::int64_t integer(const char* at, WordForm form) {
  if (form.bytes == 8) return static_cast<std::int64_t>(load<std::uint64_t>(at, form.swapped));
  return static_cast<std::int32_t>(load<std::uint32_t>(at, form.swapped));
}

inline double real(const char* at, WordForm form) {
  if (form.bytes == 8) return std::bit_cast<double>(load<std::uint64_t>(at, form.swapped));
  return static_cast<double>(std::bit_cast<float>(load<std::uint32_t>(at, form.swapped)));
}

}  // namespace words

/// A database as one row of words. Files are read as far as `reach` asks for, and those of the family after the first
/// opened: only after a file that ends with a whole block, since only such a file can be continued.
class D3plotWords {
 public:
  static constexpr std::size_t block_words = 512;

  /// A database in memory, which must outlive the words.
  D3plotWords(std::string_view bytes, WordForm form)
      : form_(form), members_{{0, bytes.data(), bytes.size()}}, size_(bytes.size() / form.bytes) {}
  /// A database on disk; `path`: of the first file.
  D3plotWords(FileBytes first, std::string path, WordForm form)
      : form_(form),
        family_(std::move(path)),
        members_{{0, first.bytes().data(), first.size()}},
        size_(first.size() / form.bytes) {
    files_.push_back(std::move(first));
  }

  [[nodiscard]] WordForm form() const { return form_; }
  /// Number of words so far.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// True if words [0, count) exist and can be used; reads on, and opens further files, if necessary.
  bool reach(std::uint64_t count) {
    while (size_ < count)
      if (!open_next()) return false;
    for (std::size_t i = complete_; i < files_.size(); ++i) {
      if (!status_.ok() || count <= members_[i].first_word) break;
      const std::uint64_t words = std::min(count - members_[i].first_word, members_[i].size / form_.bytes);
      status_ = files_[i].load(words * form_.bytes);
    }
    complete_ = files_.empty() ? 0 : files_.size() - 1;
    return status_.ok();
  }
  /// Not ok() if a file could not be read as far as it went when it was opened.
  [[nodiscard]] const Status& status() const { return status_; }
  /// Word `at`, which reach() has made usable.
  [[nodiscard]] std::int64_t integer(std::uint64_t at) const { return words::integer(place(at), form_); }
  [[nodiscard]] double real(std::uint64_t at) const { return words::real(place(at), form_); }

 private:
  struct Member {
    std::uint64_t first_word;
    const char* data;
    std::size_t size;
  };

  [[nodiscard]] const char* place(std::uint64_t at) const {
    const Member* member = &members_.front();
    if (members_.size() > 1)
      member = &*std::prev(std::upper_bound(members_.begin(), members_.end(), at,
                                            [](std::uint64_t word, const Member& m) { return word < m.first_word; }));
    return member->data + (at - member->first_word) * form_.bytes;
  }

  bool open_next() {
    const std::size_t last = members_.back().size;
    if (family_.empty() || last == 0 || last % (block_words * form_.bytes) != 0) return false;
    const std::string number = std::to_string(members_.size());
    auto file = FileBytes::begin(family_ + (number.size() < 2 ? "0" : "") + number);
    if (!file) return false;
    files_.push_back(std::move(file).value());
    members_.push_back({size_, files_.back().bytes().data(), files_.back().size()});
    size_ += files_.back().size() / form_.bytes;
    return true;
  }

  WordForm form_;
  std::string family_;
  std::vector<FileBytes> files_;  ///< beside the members; of a database in memory none
  std::vector<Member> members_;
  std::uint64_t size_;
  std::size_t complete_ = 0;  ///< files that have been read to their end
  Status status_;
};

}  // namespace gapcheck::results
