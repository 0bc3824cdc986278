#include "keyword/text/line_ends.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace gapcheck::keyword {
namespace {

struct LineEnd {
  std::string_view bytes, name;
};
constexpr std::array<LineEnd, 4> foreign_ends{
    {{"\r", "CR alone"}, {"\xC2\x85", "U+0085"}, {"\xE2\x80\xA8", "U+2028"}, {"\xE2\x80\xA9", "U+2029"}}};

/// As much of a file as tells which line ends it has.
constexpr std::size_t beginning_of_file = 65536;

bool begins_a_line(std::string_view text) { return text.starts_with('*') || text.starts_with('$'); }

/// The first CR that does not belong to the end of the line.
std::size_t lone_return(std::string_view line) { return without_returns(line).find('\r'); }

std::size_t times(std::string_view text, std::string_view what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + what.size())) ++count;
  return count;
}

}  // namespace

std::size_t foreign_break(std::string_view line) {
  std::size_t first = lone_return(line);
  const bool keyword = line.starts_with('*');
  for (const LineEnd& end : foreign_ends) {
    if (end.bytes == "\r") continue;
    for (std::size_t at = line.find(end.bytes); at < first; at = line.find(end.bytes, at + end.bytes.size()))
      if (keyword || begins_a_line(line.substr(at + end.bytes.size()))) first = at;
  }
  return first;
}

std::string foreign_line_ends(std::string_view bytes) {
  const std::string_view text = bytes.substr(0, beginning_of_file);
  // A CR in front of LF or of another CR is part of one line end.
  const auto follows = [](char a, char b) { return a == '\r' && (b == '\n' || b == '\r'); };
  std::size_t paired = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) paired += follows(text[i], text[i + 1]) ? 1 : 0;
  std::size_t most = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  std::string_view ends;
  for (const LineEnd& end : foreign_ends) {
    const std::size_t count = times(text, end.bytes) - (end.bytes == "\r" ? paired : 0);
    if (count > most) std::tie(most, ends) = std::tuple(count, end.name);
  }
  return std::string(ends);
}

std::string about_line_ends(std::string_view ends) {
  const std::string how =
      ends == foreign_ends[0].name ? "for instance with: tr '\\r' '\\n' < FILE > NEW" : "for instance in an editor";
  return "has lines that end with " + std::string(ends) + "; the solver needs LF or CR LF. Convert the line ends, " +
         how;
}

}  // namespace gapcheck::keyword
