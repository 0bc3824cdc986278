#include "base/system/memory.hpp"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

// The sanitizers have an allocator of their own, which ends the process when asked for all memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GAPCHECK_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GAPCHECK_SANITIZED
#endif
#endif
#if defined(__GLIBC__) && !defined(GAPCHECK_SANITIZED)
#define GAPCHECK_LARGE_PAGES
#endif

namespace gapcheck::system {
namespace {

/// Below this size huge pages would only waste memory.
constexpr std::size_t worth_huge_pages = std::size_t{16} << 20;

#if defined(GAPCHECK_LARGE_PAGES)
/// Someone has limited the addresses that this process may have.
bool addresses_are_limited() {
  return std::ranges::any_of(std::array{RLIMIT_AS, RLIMIT_DATA}, [](auto resource) {
    rlimit limit{};
    return ::getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
  });
}

/// Lets the heap grow over the addresses of nearly all memory that the machine has, and asks for large pages there.
/// This takes no memory: a page is taken once it is written to. A system that counts what it has promised refuses; then
/// pages stay small.
void take_heap_in_large_pages() {
  if (addresses_are_limited()) return;
  constexpr std::uintptr_t large_page = std::uintptr_t{2} << 20;
  // One request for all memory is refused, and the C library adds to it.
  const std::size_t room =
      static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) / 8 * 7 * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  void* heap = std::malloc(room);
  if (heap == nullptr) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(heap);
  const std::uintptr_t first = (begin + large_page - 1) / large_page * large_page;
  ::madvise(reinterpret_cast<void*>(first), room - (first - begin), MADV_HUGEPAGE);
  std::free(heap);
}
#endif

}  // namespace

char* take_memory(std::size_t bytes) {
  void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  if (bytes >= worth_huge_pages) ::madvise(memory, bytes, MADV_HUGEPAGE);
  return static_cast<char*>(memory);
}

void give_back_memory(char* memory, std::size_t bytes) noexcept { ::munmap(memory, bytes); }

void give_back_pages(char* begin, char* end) {
  static const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
  const std::uintptr_t last = reinterpret_cast<std::uintptr_t>(end) / page * page;
  if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED);
}

void keep_freed_memory() {
#if defined(__GLIBC__)
  // Large arrays come from the heap and not from mappings of their own, and the heap does not shrink.
  // Called before there are threads, so NOLINTBEGIN(concurrency-mt-unsafe).
  static_cast<void>(::mallopt(M_MMAP_MAX, 0));
  static_cast<void>(::mallopt(M_TRIM_THRESHOLD, -1));
  // NOLINTEND(concurrency-mt-unsafe)
#endif
#if defined(GAPCHECK_LARGE_PAGES)
  take_heap_in_large_pages();
#endif
}

}  // namespace gapcheck::system
