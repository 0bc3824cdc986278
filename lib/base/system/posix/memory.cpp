#include "base/system/memory.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <limits>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace gapcheck::system {
namespace {

/// Below this size huge pages would only waste memory.
constexpr std::size_t worth_huge_pages = std::size_t{16} << 20;

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
  static_cast<void>(::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max()));
  // NOLINTEND(concurrency-mt-unsafe)
#endif
}

}  // namespace gapcheck::system
