#include "keyword/cases.hpp"

#include <algorithm>
#include <iterator>

#include "base/number.hpp"

namespace gapcheck::keyword {
namespace {

/// The number behind `beginning`; 0: the name is another one.
std::int64_t number_after(std::string_view beginning, std::string_view name) {
  if (!name.starts_with(beginning)) return 0;
  const auto number = parse_integer(name.substr(beginning.size()));
  return number && *number > 0 ? *number : 0;
}

}  // namespace

std::int64_t case_begun(std::string_view name) { return number_after("CASE_BEGIN_", name); }

std::int64_t case_that_writes(std::string_view file, const std::set<std::int64_t>& begun) {
  const std::size_t slash = file.find_last_of("/\\");
  const std::string_view name = slash == std::string_view::npos ? file : file.substr(slash + 1);
  const std::size_t dot = name.find('.');
  const std::int64_t number = dot == std::string_view::npos ? 0 : number_after("case", name.substr(0, dot));
  return begun.contains(number) ? number : 0;
}

Cases::Cases(const Deck& deck) {
  const auto begins = [](const Block& block) { return block.name.starts_with("CASE_BEGIN_"); };
  if (std::none_of(deck.blocks().begin(), deck.blocks().end(), begins)) return;
  Numbers open;
  for (const Block& block : deck.blocks()) {
    if (const std::int64_t first = case_begun(block.name); first > 0) {
      const auto place = std::lower_bound(open.begin(), open.end(), first);
      if (place == open.end() || *place != first) open.insert(place, first);
    } else if (const std::int64_t last = number_after("CASE_END_", block.name); last > 0) {
      std::erase(open, last);
    }
    std::vector<Start>& starts = of_file_[block.file.value];
    if (starts.empty() || starts.back().cases != open) starts.push_back({block.line, open});
  }
}

const Cases::Numbers& Cases::at(FileLine place) const {
  static const Numbers none_of_them;
  const auto file = of_file_.find(place.file.value);
  if (file == of_file_.end()) return none_of_them;
  const auto behind = std::upper_bound(file->second.begin(), file->second.end(), place.line,
                                       [](std::uint32_t line, const Start& start) { return line < start.line; });
  return behind == file->second.begin() ? none_of_them : std::prev(behind)->cases;
}

bool Cases::never_together(FileLine a, FileLine b) const {
  const Numbers &of_a = at(a), &of_b = at(b);
  if (of_a.empty() || of_b.empty()) return false;
  return std::none_of(of_a.begin(), of_a.end(),
                      [&](std::int64_t n) { return std::binary_search(of_b.begin(), of_b.end(), n); });
}

}  // namespace gapcheck::keyword
