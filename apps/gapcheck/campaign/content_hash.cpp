#include "campaign/content_hash.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace gapcheck::app {

ContentHash hash_of(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return {hash.low64, hash.high64};
}

}  // namespace gapcheck::app
