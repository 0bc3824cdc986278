#include "common/freed_memory.hpp"

#if defined(__GLIBC__)
#include <malloc.h>

#include <limits>
#endif
#if defined(__GLIBC__) && defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#endif

namespace gapcheck::app {
namespace {

/// Asks the system for large pages in the heap that large arrays will use first: it then provides memory in a few
/// hundred steps instead of a hundred thousand. Nothing is used up by that, and where it is refused nothing is lost.
void prefer_large_pages() {
#if defined(__GLIBC__) && defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t heap = std::size_t{1} << 30;
  void* const start = std::malloc(heap);  // NOLINT(cppcoreguidelines-no-malloc)
  if (start == nullptr) return;
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(start) + page - 1) / page * page;
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(start) + heap) / page * page;
  static_cast<void>(::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE));
  std::free(start);  // NOLINT(cppcoreguidelines-no-malloc)
#endif
}

}  // namespace

void keep_freed_memory() {
#if defined(__GLIBC__)
  // Large arrays come from the heap and not from mappings of their own, and the heap does not shrink.
  // Called before there are threads, so NOLINTBEGIN(concurrency-mt-unsafe).
  static_cast<void>(::mallopt(M_MMAP_MAX, 0));
  static_cast<void>(::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max()));
  // NOLINTEND(concurrency-mt-unsafe)
  prefer_large_pages();
#endif
}

}  // namespace gapcheck::app
