#include "results/curves/lsda_write.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/file_bytes.hpp"

namespace gapcheck::results::lsda_write_test {
namespace {

namespace fs = std::filesystem;

struct Seen {
  std::string path, name;
  std::vector<double> values;
  std::string text;
};

std::vector<Seen> read_back(const std::string& path, Diagnostics& diagnostics) {
  std::vector<Seen> all;
  const auto file = FileBytes::open(path);
  EXPECT_TRUE(file.ok());
  EXPECT_TRUE(read_lsda(
                  file.value().bytes(), path,
                  [&](const LsdaArray& array) {
                    Seen& seen = all.emplace_back();
                    seen.path = array.path();
                    seen.name = array.name();
                    seen.text = array.text();
                    for (std::size_t i = 0; i < array.size(); ++i) seen.values.push_back(array.real(i));
                  },
                  diagnostics)
                  .ok());
  return all;
}

// Arrays longer than the buffer, empty ones, and names that are too long for their length byte.
TEST(LsdaWrite, ArraysOfAnyLength) {
  const std::string path = (fs::temp_directory_path() / ("gapcheck_lsda_" + std::to_string(::getpid()))).string();
  std::vector<double> many(300'000);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = static_cast<double>(i) / 7;
  {
    auto writer = LsdaWriter::create(path);
    ASSERT_TRUE(writer);
    writer.value().change_directory("/a/metadata");
    writer.value().text("title", "a run");
    writer.value().integers("none", {});
    writer.value().change_directory("/a/d000001");
    writer.value().reals("many", many);
    writer.value().integer("large", std::int64_t{1} << 52);
    ASSERT_TRUE(writer.value().flush().ok());
    ASSERT_TRUE(writer.value().flush().ok()) << "with nothing new";
    writer.value().real(std::string(300, 'n'), -0.5);
    ASSERT_TRUE(writer.value().flush().ok());
  }
  Diagnostics diagnostics;
  const std::vector<Seen> all = read_back(path, diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty());
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[0].path, "/a/metadata");
  EXPECT_EQ(all[0].text, "a run");
  EXPECT_TRUE(all[1].values.empty());
  EXPECT_EQ(all[2].path, "/a/d000001");
  EXPECT_EQ(all[2].values, many);
  EXPECT_EQ(all[3].values, std::vector<double>{4503599627370496.0});
  EXPECT_EQ(all[4].name, std::string(255, 'n'));
  EXPECT_EQ(all[4].path, "/a/d000001") << "the directory is that before the table of symbols";
  fs::remove(path);
}

}  // namespace
}  // namespace gapcheck::results::lsda_write_test
