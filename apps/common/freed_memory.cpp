#include "common/freed_memory.hpp"

#if defined(__GLIBC__)
#include <malloc.h>

#include <limits>
#endif

namespace gapcheck::app {

void keep_freed_memory() {
#if defined(__GLIBC__)
  // Large arrays come from the heap and not from mappings of their own, and the heap does not shrink.
  // Called before there are threads, so NOLINTBEGIN(concurrency-mt-unsafe).
  static_cast<void>(::mallopt(M_MMAP_MAX, 0));
  static_cast<void>(::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max()));
  // NOLINTEND(concurrency-mt-unsafe)
#endif
}

}  // namespace gapcheck::app
