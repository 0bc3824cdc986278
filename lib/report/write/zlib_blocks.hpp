#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gapcheck::report {

/// Bytes compressed in blocks, as VTK's XML files have them.
struct ZlibBlocks {
  /// Number of blocks, bytes of a whole block, bytes of the last one if it is shorter (otherwise 0), then the length of
  /// each block compressed.
  std::vector<std::uint64_t> header;
  std::string data;  ///< the compressed blocks, one after the other
};

/// Compresses with zlib, blocks side by side on all threads; the result does not depend on their number.
[[nodiscard]] ZlibBlocks zlib_blocks(std::span<const char> bytes);

}  // namespace gapcheck::report
