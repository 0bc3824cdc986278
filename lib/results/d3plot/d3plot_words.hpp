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

#include "base/mapped_file.hpp"

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

/// A database as one row of words. Files of the family after the first are opened when `reach` asks for more than is
/// loaded: only after a file that ends with a whole block, since only such a file can be continued.
class D3plotWords {
 public:
  static constexpr std::size_t block_words = 512;

  /// `first` must outlive the words. `family`: path of the first file; empty: there are no others.
  D3plotWords(std::string_view first, std::string family, WordForm form)
      : form_(form), family_(std::move(family)), members_{{0, first}}, size_(first.size() / form.bytes) {}

  [[nodiscard]] WordForm form() const { return form_; }
  /// Number of words so far.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// True if words [0, count) exist; opens further files if necessary.
  bool reach(std::uint64_t count) {
    while (size_ < count)
      if (!open_next()) return false;
    return true;
  }
  /// Word `at` < size().
  [[nodiscard]] std::int64_t integer(std::uint64_t at) const { return words::integer(place(at), form_); }
  [[nodiscard]] double real(std::uint64_t at) const { return words::real(place(at), form_); }

 private:
  struct Member {
    std::uint64_t first_word;
    std::string_view bytes;
  };

  [[nodiscard]] const char* place(std::uint64_t at) const {
    const Member* member = &members_.front();
    if (members_.size() > 1)
      member = &*std::prev(std::upper_bound(members_.begin(), members_.end(), at,
                                            [](std::uint64_t word, const Member& m) { return word < m.first_word; }));
    return member->bytes.data() + (at - member->first_word) * form_.bytes;
  }

  bool open_next() {
    const std::string_view last = members_.back().bytes;
    if (family_.empty() || last.empty() || last.size() % (block_words * form_.bytes) != 0) return false;
    const std::string number = std::to_string(members_.size());
    auto file = MappedFile::open(family_ + (number.size() < 2 ? "0" : "") + number);
    if (!file) return false;
    files_.push_back(std::move(file).value());
    members_.push_back({size_, files_.back().bytes()});
    size_ += files_.back().bytes().size() / form_.bytes;
    return true;
  }

  WordForm form_;
  std::string family_;
  std::vector<MappedFile> files_;
  std::vector<Member> members_;
  std::uint64_t size_;
};

}  // namespace gapcheck::results
