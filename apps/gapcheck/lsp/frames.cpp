#include "lsp/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/number.hpp"
#include "base/system/files.hpp"
#include "keyword/upper_case.hpp"

namespace gapcheck::app::lsp {
namespace {

constexpr std::size_t read_size = std::size_t{1} << 16;

/// The number of a Content-Length; nothing if it is none, negative or too large for a number.
std::optional<std::size_t> length_of(std::string_view value) {
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), length);
  const bool whole = error == std::errc{} && end == value.data() + value.size();
  return whole ? std::optional(length) : std::nullopt;
}

/// Waits for bytes; how many came, 0 at the end.
std::size_t read_some(int descriptor, char* to, std::size_t most) {
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(system::read_some(descriptor, to, most), 0));
}

}  // namespace

bool FrameReader::fill() {
  if (used_ == buffer_.size()) buffer_.clear(), used_ = 0;
  const std::size_t before = buffer_.size();
  buffer_.resize(before + read_size);
  const std::size_t got = read_some(descriptor_, buffer_.data() + before, read_size);
  buffer_.resize(before + got);
  return got > 0;
}

FrameReader::Line FrameReader::read_line(std::string& line) {
  for (std::size_t from = used_;;) {
    const std::size_t newline = buffer_.find('\n', from);
    if (newline != std::string::npos) {
      line = buffer_.substr(used_, newline - used_);
      if (line.ends_with('\r')) line.pop_back();
      used_ = newline + 1;
      return Line::read;
    }
    if (buffer_.size() - used_ > longest_header) return Line::too_long;
    const std::size_t kept = buffer_.size() - used_;
    buffer_.erase(0, used_);
    used_ = 0;
    from = kept;
    if (!fill()) return Line::end;
  }
}

/// `body`: where it goes; nullptr: it is passed over.
bool FrameReader::read_body(std::size_t length, std::string* body) {
  // Room for all of it is only promised by the system until it is written to.
  constexpr std::size_t part_size = std::size_t{1} << 20;
  std::string passed;
  std::string& to = body != nullptr ? *body : passed;
  if (body != nullptr) to.reserve(length);
  while (length > 0) {
    if (used_ < buffer_.size()) {
      const std::size_t part = std::min(length, buffer_.size() - used_);
      to.append(buffer_, used_, part);
      used_ += part;
      length -= part;
      continue;
    }
    if (body == nullptr) to.clear();
    const std::size_t before = to.size(), part = std::min(length, part_size);
    to.resize(before + part);
    std::size_t got = 0;
    while (got < part) {
      const std::size_t now = read_some(descriptor_, to.data() + before + got, part - got);
      if (now == 0) return false;
      got += now;
    }
    length -= part;
  }
  return true;
}

Frame FrameReader::next() {
  std::optional<std::size_t> length;
  std::string line;
  bool any = false;
  for (;;) {
    switch (read_line(line)) {
      case Line::end:
        return any || !buffer_.empty() ? Frame{Frame::Kind::broken, "the input ends in the header of a message"}
                                       : Frame{};
      case Line::too_long:
        return {Frame::Kind::broken, fmt::format("a header line has more than {} characters", longest_header)};
      case Line::read:
        break;
    }
    if (line.empty() && any) break;
    if (line.empty()) continue;  // line ends between messages do no harm
    any = true;
    const std::size_t colon = line.find(':');
    if (keyword::upper_case(trimmed(std::string_view(line).substr(0, colon))) != "CONTENT-LENGTH") continue;
    length = length_of(trimmed(std::string_view(line).substr(std::min(colon + 1, line.size()))));
    if (!length) return {Frame::Kind::broken, "Content-Length is not a number of bytes"};
  }
  if (!length) return {Frame::Kind::broken, "a message without Content-Length"};
  const bool fits = *length <= largest_;
  Frame frame{Frame::Kind::message, {}};
  if (!read_body(*length, fits ? &frame.text : nullptr))
    return {Frame::Kind::broken, "the input ends in the middle of a message"};
  if (fits) return frame;
  return {Frame::Kind::refused, fmt::format("the message has {} bytes; at most {} are read", *length, largest_)};
}

void enlarge_pipe(int descriptor) {
  constexpr int room = 1 << 20;
  system::enlarge_pipe(descriptor, room);
}

bool write_frame(int descriptor, std::string_view message) {
  const std::string header = fmt::format("Content-Length: {}\r\n\r\n", message.size());
  for (std::string_view left : {std::string_view(header), message})
    while (!left.empty()) {
      const std::ptrdiff_t written = system::write_some(descriptor, left);
      if (written <= 0) return false;
      left.remove_prefix(static_cast<std::size_t>(written));
    }
  return true;
}

}  // namespace gapcheck::app::lsp
