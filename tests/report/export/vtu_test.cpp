#include "report/export/vtu.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace gapcheck::report::vtu_test {
namespace {

std::string decoded(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char* const letter = std::strchr(letters, c);
    EXPECT_NE(letter, nullptr) << c;
    if (letter == nullptr) return {};
    bits = bits << 6 | static_cast<std::uint32_t>(letter - letters);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 255u);
    }
  }
  return bytes;
}

/// Bytes as so many characters.
std::size_t encoded_length(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

std::vector<std::uint64_t> words_of(const std::string& bytes) {
  std::vector<std::uint64_t> words(bytes.size() / sizeof(std::uint64_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint64_t));
  return words;
}

/// The data of one array, read as the format's description has it: at its offset behind the underscore the header in
/// base64, behind that the compressed blocks in base64.
template <class Value>
std::vector<Value> values_of(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + "\"");
  EXPECT_NE(at, std::string::npos) << name;
  if (at == std::string::npos) return {};
  const std::size_t offset = std::stoul(text.substr(text.find("offset=\"", at) + 8));
  const std::string_view all = text;
  std::size_t from = text.find("<AppendedData encoding=\"base64\">\n_") + 34 + offset;
  const std::uint64_t blocks = words_of(decoded(all.substr(from, encoded_length(24))))[0];
  const std::size_t header_length = encoded_length((3 + blocks) * 8);
  const std::vector<std::uint64_t> header = words_of(decoded(all.substr(from, header_length)));
  from += header_length;
  std::size_t length = 0;
  for (std::size_t i = 0; i < blocks; ++i) length += header[3 + i];
  const std::string data = decoded(all.substr(from, encoded_length(length)));
  EXPECT_EQ(data.size(), length);
  std::string bytes;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    std::string block(i + 1 == blocks && header[2] > 0 ? header[2] : header[1], '\0');
    auto size = static_cast<uLongf>(block.size());
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                         reinterpret_cast<const Bytef*>(data.data() + begin), header[3 + i]),
              Z_OK);
    EXPECT_EQ(size, block.size());
    begin += header[3 + i];
    bytes += block;
  }
  std::vector<Value> values(bytes.size() / sizeof(Value));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

VtuGrid sample() {
  VtuGrid grid;
  for (int i = 0; i < 8; ++i) grid.points.push_back({0.5 * i, -1, 2});
  grid.add_cell(std::array<std::uint32_t, 4>{0, 1, 2, 3});
  grid.add_cell(std::array<std::uint32_t, 4>{1, 2, 3, 3});
  grid.add_cell(std::array<std::uint32_t, 8>{0, 1, 2, 3, 4, 5, 6, 7});
  grid.add_cell(std::array<std::uint32_t, 8>{0, 1, 2, 4, 4, 4, 4, 4});
  grid.add_cell(std::array<std::uint32_t, 2>{6, 7});
  return grid;
}

TEST(Vtu, CellsOfAllKinds) {
  const std::string text = vtu(sample());
  EXPECT_NE(text.find("<Piece NumberOfPoints=\"8\" NumberOfCells=\"5\">"), std::string::npos);
  EXPECT_NE(text.find("header_type=\"UInt64\""), std::string::npos);
  EXPECT_EQ(values_of<std::uint8_t>(text, "types"), (std::vector<std::uint8_t>{9, 5, 12, 10, 3}));
  EXPECT_EQ(values_of<std::int32_t>(text, "offsets"), (std::vector<std::int32_t>{4, 7, 15, 19, 21}));
  const auto connectivity = values_of<std::int32_t>(text, "connectivity");
  ASSERT_EQ(connectivity.size(), 21u);
  EXPECT_EQ(connectivity[6], 3);
  EXPECT_EQ(connectivity[18], 4);
  const auto points = values_of<float>(text, "Points");
  ASSERT_EQ(points.size(), 24u);
  EXPECT_EQ(points[3], 0.5F);
  EXPECT_EQ(points[22], -1.0F);
}

TEST(Vtu, Data) {
  VtuGrid grid = sample();
  grid.point_data.push_back({"velocity", 3, std::vector<double>(24, 0.25)});
  grid.cell_data.push_back({"element", 1, {1, 2, 3, 123456789, 5}, true});
  grid.cell_data.push_back({"strain", 1, {0.5, std::nan(""), 1e300, -1e300, 0}});
  const std::string text = vtu(grid);
  EXPECT_EQ(values_of<float>(text, "velocity"), std::vector<float>(24, 0.25F));
  EXPECT_EQ(values_of<std::int32_t>(text, "element")[3], 123456789) << "exact, though no float holds it";
  const auto strain = values_of<float>(text, "strain");
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_EQ(strain, (std::vector<float>{0.5F, 0, most, -most, 0}));
}

TEST(Vtu, IdsThatNoDoubleHolds) {
  VtuGrid grid = sample();
  constexpr std::int64_t large = (std::int64_t{1} << 60) + 1;
  grid.point_ids.push_back({"node", {1, 2, 3, 4, 5, 6, 7, large}});
  grid.cell_ids.push_back({"part", {1, 2, 3, 4, -5}});
  const std::string text = vtu(grid);
  EXPECT_EQ(values_of<std::int64_t>(text, "node").back(), large);
  EXPECT_EQ(values_of<std::int32_t>(text, "part").back(), -5);
}

TEST(Vtu, GapsStayGaps) {
  VtuGrid grid = sample();
  grid.cell_data.push_back({.name = "remaining", .values = {0.5, std::nan(""), 1, 2, 3}, .gaps = true});
  const auto remaining = values_of<float>(vtu(grid), "remaining");
  EXPECT_TRUE(std::isnan(remaining[1]));
  EXPECT_EQ(remaining[0], 0.5F);
}

TEST(Vtu, ParticlesAndWords) {
  VtuGrid grid = sample();
  grid.add_cell(std::array<std::uint32_t, 1>{7});
  grid.words.push_back({"a<b", {"ab", "", "c\x01"}});
  const std::string text = vtu(grid);
  EXPECT_EQ(values_of<std::uint8_t>(text, "types").back(), 1);
  EXPECT_NE(text.find("Name=\"a&lt;b\" NumberOfTuples=\"3\" format=\"ascii\">\n97 98 0\n0\n99 63 0\n"),
            std::string::npos)
      << text;
}

TEST(Vtu, EmptyGrid) {
  const std::string text = vtu({});
  EXPECT_NE(text.find("NumberOfPoints=\"0\" NumberOfCells=\"0\""), std::string::npos);
  EXPECT_TRUE(values_of<float>(text, "Points").empty());
}

TEST(Vtu, LargeArraysHaveSeveralBlocks) {
  VtuGrid grid;
  for (int i = 0; i < 100000; ++i) grid.points.push_back({1.0 * i, 0.5 * i, -1.0 * (i % 977)});
  const std::vector<float> points = values_of<float>(vtu(grid), "Points");
  ASSERT_EQ(points.size(), 300000U);
  for (std::size_t i = 0; i < 100000; ++i) {
    ASSERT_EQ(points[3 * i], static_cast<float>(i));
    ASSERT_EQ(points[3 * i + 2], -static_cast<float>(i % 977));
  }
}

TEST(Vtu, Collection) {
  const std::string text = pvd(std::vector<PvdEntry>{{0, "a.vtu"}, {0.125, "b<&\".vtu"}});
  EXPECT_NE(text.find("<DataSet timestep=\"0.125\" part=\"0\" file=\"b&lt;&amp;&quot;.vtu\"/>"), std::string::npos);
  EXPECT_NE(text.find("type=\"Collection\""), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::report::vtu_test
