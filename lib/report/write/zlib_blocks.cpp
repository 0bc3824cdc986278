#include "report/write/zlib_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>

#include "base/parallel.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t block_size = 1U << 18;
/// The fastest: on meshes the others take two to seven times as long for files that are not smaller.
constexpr int level = 1;

/// Memory for one stream of zlib, which needs 268 kB of it: where there is none left, this fails as other arrays do.
struct Arena {
  std::vector<std::max_align_t> bytes =
      std::vector<std::max_align_t>((std::size_t{1} << 19) / sizeof(std::max_align_t));
  std::size_t used = 0;

  static voidpf allocate(voidpf arena, uInt items, uInt size) {
    auto& own = *static_cast<Arena*>(arena);
    const std::size_t count = (std::size_t{items} * size + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t);
    if (count > own.bytes.size() - own.used) return Z_NULL;
    own.used += count;
    return own.bytes.data() + (own.used - count);
  }
  static void release(voidpf, voidpf) {}
};

std::string compressed(std::span<const char> bytes) {
  std::string out(compressBound(static_cast<uLong>(bytes.size())), '\0');
  Arena arena;
  z_stream stream{};
  stream.zalloc = Arena::allocate;
  stream.zfree = Arena::release;
  stream.opaque = &arena;
  deflateInit(&stream, level);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // it does not write there
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);  // there is room for all of it
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace

ZlibBlocks zlib_blocks(std::span<const char> bytes) {
  const std::size_t count = (bytes.size() + block_size - 1) / block_size;
  std::vector<std::string> blocks(count);
  parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      blocks[i] = compressed(bytes.subspan(i * block_size, std::min(block_size, bytes.size() - i * block_size)));
  });
  ZlibBlocks out;
  out.header = {count, block_size, bytes.size() % block_size};
  std::size_t length = 0;
  for (const std::string& block : blocks) {
    out.header.push_back(block.size());
    length += block.size();
  }
  out.data.reserve(length);
  for (const std::string& block : blocks) out.data += block;
  return out;
}

}  // namespace gapcheck::report
