// The module's own operator new and delete: blocks are those of malloc(), whoever frees them. CMakeLists.txt keeps the
// operators inside the module.
#include "kept_memory.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <new>

namespace gapcheck::python {
namespace {

/// From this size on the C library maps blocks one by one.
constexpr std::size_t mapped_size = std::size_t{1} << 17;
/// From this size on blocks are in large pages where the system gives them.
constexpr std::size_t large_size = std::size_t{1} << 20, large_page = std::size_t{2} << 20;

class FreedBlocks {
 public:
  void begin() { ++users_; }
  void end() {
    if (--users_ > 0) return;
    const std::unique_lock guard(lock_, std::try_to_lock);
    if (!guard.owns_lock() || users_ > 0) return;  // then it is for the next end
    for (std::size_t i = 0; i < count_; ++i) std::free(blocks_[i].memory);
    count_ = 0;
  }
  /// The smallest that is large enough and at most twice as large; null: there is none.
  [[nodiscard]] void* take(std::size_t size) {
    const std::unique_lock guard(lock_, std::try_to_lock);
    if (!guard.owns_lock()) return nullptr;
    Block* best = nullptr;
    for (std::size_t i = 0; i < count_; ++i)
      if (blocks_[i].size >= size && blocks_[i].size / 2 <= size && (best == nullptr || blocks_[i].size < best->size))
        best = &blocks_[i];
    if (best == nullptr) return nullptr;
    void* const memory = best->memory;
    *best = blocks_[--count_];
    return memory;
  }
  /// False: it is not kept.
  [[nodiscard]] bool keep(void* memory) {
    const std::unique_lock guard(lock_, std::try_to_lock);
    if (!guard.owns_lock() || users_ == 0 || count_ == blocks_.size()) return false;
    // It may be larger than the last that asked for it knows.
    blocks_[count_++] = {memory, ::malloc_usable_size(memory)};
    return true;
  }
  [[nodiscard]] bool used() const { return users_ > 0; }

 private:
  struct Block {
    void* memory = nullptr;
    std::size_t size = 0;
  };

  std::mutex lock_;  ///< only tried: in a process that was forked meanwhile nobody may be left to open it
  std::atomic<int> users_ = 0;
  std::array<Block, 256> blocks_{};
  std::size_t count_ = 0;
};

constinit FreedBlocks freed;

void* aligned_block(std::size_t size) {
  // With its last page whole, or that would be small ones.
  if (size > std::numeric_limits<std::size_t>::max() - large_page) return nullptr;
  const std::size_t whole = (size + large_page - 1) / large_page * large_page;
  void* memory = nullptr;
  if (::posix_memalign(&memory, large_page, whole) != 0) return nullptr;
  ::madvise(memory, whole, MADV_HUGEPAGE);
  return memory;
}

void* allocate_block(std::size_t size) {
  if (size >= mapped_size && freed.used())
    if (void* const kept = freed.take(size); kept != nullptr) return kept;
  void* const memory = size >= large_size ? aligned_block(size) : std::malloc(std::max<std::size_t>(size, 1));
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void release_block(void* memory, std::size_t size) noexcept {
  if (size >= mapped_size && freed.used() && freed.keep(memory)) return;
  std::free(memory);
}

}  // namespace

KeptMemory::KeptMemory() { freed.begin(); }

KeptMemory::~KeptMemory() { freed.end(); }

}  // namespace gapcheck::python

void* operator new(std::size_t size) { return gapcheck::python::allocate_block(size); }
void* operator new[](std::size_t size) { return gapcheck::python::allocate_block(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t size) noexcept { gapcheck::python::release_block(memory, size); }
void operator delete[](void* memory, std::size_t size) noexcept { gapcheck::python::release_block(memory, size); }
