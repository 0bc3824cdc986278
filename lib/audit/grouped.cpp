#include "audit/grouped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/parallel.hpp"

namespace gapcheck::audit {

void add_grouped(Report& report, std::vector<Found> found, const std::function<Finding(const Found&)>& words,
                 const std::function<Finding(const Found&, std::uint64_t)>& rest, const Collect& collect) {
  parallel_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    if (a.group != b.group) return a.group < b.group;
    if (a.weight != b.weight) return a.weight > b.weight;
    return std::tie(a.ids, a.item) < std::tie(b.ids, b.item);
  });
  for (std::size_t first = 0; first < found.size();) {
    std::size_t end = first;
    while (end < found.size() && found[end].group == found[first].group) ++end;
    // A single extra finding is as short in full as a line that counts it.
    const std::size_t shown = end - first <= found_in_full + 1 ? end : first + found_in_full;
    for (std::size_t i = first; i < shown; ++i) {
      report.findings.push_back(words(found[i]));
      if (collect) collect(found[i], report.findings.back().members);
    }
    if (shown < end) {
      Finding f = rest(found[shown], end - shown);
      f.count = end - shown;
      for (std::size_t i = shown; collect && i < end; ++i) collect(found[i], f.members);
      report.findings.push_back(std::move(f));
    }
    first = end;
  }
}

void add_first(Report& report, std::vector<Finding> found, std::string_view what) {
  const std::size_t shown = std::min(found.size(), found_in_full), more = found.size() - shown;
  for (std::size_t i = 0; i < shown; ++i) report.findings.push_back(std::move(found[i]));
  if (more == 0) return;
  Finding rest = std::move(found[shown]);
  rest.message = fmt::format("{} {}, the first of them contact {}", more, what, rest.contact);
  rest.count = more;
  report.findings.push_back(std::move(rest));
}

}  // namespace gapcheck::audit
