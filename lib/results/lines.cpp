#include "results/lines.hpp"

#include <cstring>
#include <limits>

namespace gapcheck::results {
namespace {

/// Position of the first `c` in [begin, end) of the text, or `end`.
std::size_t find(std::string_view text, char c, std::size_t begin, std::size_t end) {
  if (begin >= end) return end;
  const void* found = std::memchr(text.data() + begin, c, end - begin);
  return found == nullptr ? end : static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
}

}  // namespace

Lines::Lines(std::string_view text) : text_(text), nul_(text.size()) { advance(); }

/// The next line feed is looked up once, however many carriage returns come before it.
void Lines::find_line_feed() {
  if (feed_known_ && line_feed_ >= next_) return;
  line_feed_ = find(text_, '\n', next_, text_.size());
  feed_known_ = true;
}

void Lines::advance() {
  if (next_ >= text_.size()) {
    done_ = true;
    line_ = {};
    return;
  }
  if (number_ < std::numeric_limits<std::uint32_t>::max()) ++number_;
  find_line_feed();
  const std::size_t begin = next_, end = find(text_, '\r', begin, line_feed_);
  open_ = end == text_.size();
  if (end == line_feed_) {
    next_ = open_ ? end : end + 1;
  } else {
    next_ = end + 1;
    const bool has_feed = line_feed_ < text_.size();
    if (has_feed && next_ + 1 == line_feed_ && text_[next_] == '\r') ++next_;
    if (has_feed && next_ == line_feed_) ++next_;
  }
  line_ = text_.substr(begin, end - begin);
  if (line_.size() > longest) cut_line();
  look_for_nul(end);
}

void Lines::cut_line() {
  line_ = line_.substr(0, longest);
  if (cut_lines_++ == 0) first_cut_ = number_;
}

/// In big steps, just ahead of the reading: cheap, and no page is touched twice.
void Lines::look_for_nul(std::size_t end) {
  constexpr std::size_t step = std::size_t{1} << 18;
  while (searched_ < end && nul_ == text_.size()) {
    const std::size_t until = searched_ + step < text_.size() ? searched_ + step : text_.size();
    const std::size_t found = find(text_, '\0', searched_, until);
    if (found < until) nul_ = found;
    searched_ = until;
  }
  if (nul_ >= end) return;
  if (first_nul_ == 0) first_nul_ = number_;
  while (!line_.empty() && line_.front() == '\0') line_.remove_prefix(1);
  while (!line_.empty() && line_.back() == '\0') line_.remove_suffix(1);
}

}  // namespace gapcheck::results
