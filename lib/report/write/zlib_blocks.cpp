#include "report/write/zlib_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <new>

#include "base/parallel.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t block_size = 1U << 18;
/// The fastest: on meshes the others take two to seven times as long for files that are not smaller.
constexpr int level = 1;

std::string compressed(std::span<const char> bytes) {
  auto length = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(length, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(out.data()), &length,
                               reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()), level);
  if (status != Z_OK) throw std::bad_alloc();  // the buffer is large enough, so memory is all that can be missing
  out.resize(length);
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
