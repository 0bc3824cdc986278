#pragma once
#include <cstddef>

namespace gapcheck::system {

/// Zeroed memory that is taken as it is written to, in large pages if it is large. Null: errno says why.
[[nodiscard]] char* take_memory(std::size_t bytes);
/// All of it.
void give_back_memory(char* memory, std::size_t bytes) noexcept;
/// Gives back whole pages within [begin, end); the addresses stay taken.
void give_back_pages(char* begin, char* end);

/// Memory that is freed stays with the process for what comes next, and the heap is in large pages where the system
/// gives them. Before there are threads.
void keep_freed_memory();

}  // namespace gapcheck::system
