#include "contact/surface/coincident.hpp"

#include <algorithm>
#include <mutex>
#include <tuple>

#include "base/parallel.hpp"
#include "contact/surface/segment_elements.hpp"

namespace gapcheck::contact {
namespace {

std::uint32_t lowest(const model::SegmentNodes& n) { return std::min({n[0], n[1], n[2], n[3]}).value; }

}  // namespace

std::vector<Coincidence> coincident_segments(std::span<const model::SegmentNodes> segments, std::size_t nodes) {
  // Segments in buckets by their lowest node: equal ones meet in one small bucket.
  constexpr std::size_t grain = 16384;
  std::vector<std::uint32_t> start(nodes + 1, 0), list(segments.size());
  for (const auto& n : segments)
    if (lowest(n) < nodes) ++start[lowest(n) + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t s = 0; s < segments.size(); ++s)
    if (lowest(segments[s]) < nodes) list[next[lowest(segments[s])]++] = s;

  std::vector<Coincidence> found;
  std::mutex mutex;
  parallel_for(nodes, grain, [&](std::size_t begin, std::size_t end) {
    struct Entry {
      SegmentKey key;
      std::uint32_t segment;
    };
    std::vector<Entry> bucket;
    for (std::size_t n = begin; n < end; ++n) {
      if (start[n + 1] - start[n] < 2) continue;
      bucket.clear();
      for (std::uint32_t i = start[n]; i < start[n + 1]; ++i)
        bucket.push_back({segment_key(segments[list[i]]), list[i]});
      std::sort(bucket.begin(), bucket.end(),
                [](const Entry& a, const Entry& b) { return std::tie(a.key, a.segment) < std::tie(b.key, b.segment); });
      for (std::size_t first = 0, i = 1; i < bucket.size(); ++i) {
        if (bucket[i].key != bucket[first].key) {
          first = i;
          continue;
        }
        const std::lock_guard lock(mutex);
        found.push_back({bucket[first].segment, bucket[i].segment});
      }
    }
  });
  std::sort(found.begin(), found.end(), [](const Coincidence& a, const Coincidence& b) { return a.again < b.again; });
  return found;
}

}  // namespace gapcheck::contact
