#pragma once
#include <cstddef>

namespace gapcheck {

/// Asks the processor for an object that will be read soon; nullptr: for nothing. No result depends on it.
template <class T>
inline void prefetch([[maybe_unused]] const T* object) {
#if defined(__GNUC__)
  constexpr std::size_t line = 64;
  if (object == nullptr) return;
  for (std::size_t byte = 0; byte < sizeof(T); byte += line)
    __builtin_prefetch(reinterpret_cast<const char*>(object) + byte);
#endif
}

}  // namespace gapcheck
