#include "results/text/lines.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/work_watch.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t rare_step = std::size_t{1} << 18;
/// So often the reader asks whether it is to go on.
constexpr std::uint32_t asking_step = 1 << 10;

}  // namespace

std::size_t Lines::Ahead::find(std::string_view text, std::size_t begin, std::size_t end) {
  if (known_ && found_ >= begin) return std::min(found_, end);
  known_ = false;
  searched_ = std::max(searched_, begin);
  while (searched_ < end) {
    const std::size_t until = text.size() - searched_ > step_ ? searched_ + step_ : text.size();
    const void* hit = std::memchr(text.data() + searched_, wanted_, until - searched_);
    if (hit == nullptr) {
      searched_ = until;
      continue;
    }
    found_ = static_cast<std::size_t>(static_cast<const char*>(hit) - text.data());
    searched_ = found_ + 1;
    known_ = true;
    return std::min(found_, end);
  }
  return end;
}

Lines::Lines(std::string_view text)
    : text_(text),
      feeds_('\n', std::numeric_limits<std::size_t>::max()),
      returns_('\r', rare_step),
      nuls_('\0', rare_step) {
  advance();
}

Lines::Lines(FileBytes& file) : Lines(std::string_view()) {
  file_ = &file;
  text_ = file.bytes();
  done_ = false;
  advance();
}

/// True if there is more text.
bool Lines::read_on() {
  if (file_ == nullptr || !status_.ok() || text_.size() == file_->size()) return false;
  status_ = file_->load(text_.size() + 1);
  text_ = file_->bytes();
  return status_.ok();
}

/// Nothing more is read.
void Lines::end_here() {
  file_ = nullptr;
  next_ = text_.size();
}

/// The next line feed, or the end of the text.
std::size_t Lines::next_feed() {
  std::size_t feed = feeds_.find(text_, next_, text_.size());
  while (feed == text_.size() && read_on()) feed = feeds_.find(text_, next_, text_.size());
  return feed;
}

void Lines::advance() {
  if (number_ % asking_step == 0 && work_stopped()) end_here();
  if (next_ >= text_.size() && !read_on()) {
    done_ = true;
    line_ = {};
    return;
  }
  if (number_ < std::numeric_limits<std::uint32_t>::max()) ++number_;
  const std::size_t begin = next_, feed = next_feed(), end = returns_.find(text_, begin, feed);
  open_ = end == text_.size();
  next_ = open_ ? end : end + 1;
  if (end < feed && feed < text_.size()) {
    if (next_ + 1 == feed && text_[next_] == '\r') ++next_;
    if (next_ == feed) ++next_;
  }
  line_ = text_.substr(begin, end - begin);
  check_line(begin, end);
}

void Lines::check_line(std::size_t begin, std::size_t end) {
  if (line_.size() > longest) {
    line_ = line_.substr(0, longest);
    if (cut_lines_++ == 0) first_cut_ = number_;
  }
  if (nuls_.find(text_, begin, end) == end) return;
  if (first_nul_ == 0) first_nul_ = number_;
  while (!line_.empty() && line_.front() == '\0') line_.remove_prefix(1);
  while (!line_.empty() && line_.back() == '\0') line_.remove_suffix(1);
}

}  // namespace gapcheck::results
