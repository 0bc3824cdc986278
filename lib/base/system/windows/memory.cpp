#include "base/system/memory.hpp"

#include <windows.h>

#include <cerrno>
#include <cstdint>

namespace gapcheck::system {

char* take_memory(std::size_t bytes) {
  void* memory = ::VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
  if (memory == nullptr) errno = ENOMEM;
  return static_cast<char*>(memory);
}

void give_back_memory(char* memory, std::size_t) noexcept { ::VirtualFree(memory, 0, MEM_RELEASE); }

void give_back_pages(char* begin, char* end) {
  SYSTEM_INFO info{};
  ::GetSystemInfo(&info);
  const std::uintptr_t page = info.dwPageSize;
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
  const std::uintptr_t last = reinterpret_cast<std::uintptr_t>(end) / page * page;
  if (first < last) ::VirtualFree(reinterpret_cast<void*>(first), last - first, MEM_DECOMMIT);
}

void keep_freed_memory() {}

}  // namespace gapcheck::system
