#include "report/write/zlib_blocks.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "base/parallel.hpp"

namespace gapcheck::report::zlib_blocks_test {
namespace {

std::string random_bytes(std::size_t size, int most) {
  std::mt19937 engine(static_cast<unsigned>(size));
  std::uniform_int_distribution<int> any(0, most);
  std::string bytes(size, '\0');
  for (char& c : bytes) c = static_cast<char>(any(engine));
  return bytes;
}

/// All blocks, uncompressed by zlib's own function.
std::string read(const ZlibBlocks& blocks) {
  std::string bytes;
  std::size_t from = 0;
  for (std::size_t i = 0; i < blocks.header[0]; ++i) {
    const bool last = i + 1 == blocks.header[0];
    std::string block(last && blocks.header[2] > 0 ? blocks.header[2] : blocks.header[1], '\0');
    auto size = static_cast<uLongf>(block.size());
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                         reinterpret_cast<const Bytef*>(blocks.data.data() + from), blocks.header[3 + i]),
              Z_OK);
    EXPECT_EQ(size, block.size());
    from += blocks.header[3 + i];
    bytes += block;
  }
  EXPECT_EQ(from, blocks.data.size());
  return bytes;
}

TEST(ZlibBlocks, BytesComeBack) {
  const std::size_t block = zlib_blocks({}).header[1];
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, block - 1, block, block + 1, 3 * block, 3 * block + 7})
    for (const int most : {0, 3, 255}) {
      const std::string bytes = random_bytes(size, most);
      const ZlibBlocks blocks = zlib_blocks(bytes);
      ASSERT_EQ(blocks.header[0], (size + block - 1) / block);
      ASSERT_EQ(blocks.header.size(), 3 + blocks.header[0]);
      ASSERT_EQ(blocks.header[2], size % block);
      ASSERT_EQ(read(blocks), bytes) << size;
      if (most == 0 && size > 100) EXPECT_LT(blocks.data.size(), size / 100);
    }
}

TEST(ZlibBlocks, DoNotDependOnThreads) {
  const std::string bytes = random_bytes(3000000, 20);
  const ZlibBlocks all = zlib_blocks(bytes);
  const JobLimit one(1);
  const ZlibBlocks alone = zlib_blocks(bytes);
  EXPECT_EQ(all.header, alone.header);
  EXPECT_EQ(all.data, alone.data);
}

}  // namespace
}  // namespace gapcheck::report::zlib_blocks_test
