#include "base/mapped_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace gapcheck::mapped_file_test {
namespace {

namespace fs = std::filesystem;

class MappedFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "gapcheck_XXXXXX";
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string file(const std::string& name, const std::string& content) {
    const fs::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << content;
    return path.string();
  }
  fs::path folder_;
};

TEST_F(MappedFileTest, HasTheBytesOfTheFile) {
  std::string content("a\0b\r\n", 5);
  for (int i = 0; i < 20000; ++i) content += static_cast<char>(i % 251);
  auto mapped = MappedFile::open(file("a.k", content));
  ASSERT_TRUE(mapped.ok());
  EXPECT_EQ(mapped.value().bytes(), content);
}

TEST_F(MappedFileTest, StaysAtItsAddressWhenMoved) {
  auto mapped = MappedFile::open(file("a.k", "content"));
  ASSERT_TRUE(mapped.ok());
  const char* address = mapped.value().bytes().data();
  MappedFile moved = std::move(mapped).value();
  MappedFile assigned;
  assigned = std::move(moved);
  EXPECT_EQ(assigned.bytes().data(), address);
  EXPECT_EQ(assigned.bytes(), "content");
}

TEST_F(MappedFileTest, CanBeReadAgainAfterRelease) {
  const std::string content(100000, 'x');
  const auto mapped = MappedFile::open(file("a.k", content));
  ASSERT_TRUE(mapped.ok());
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(mapped.value().bytes(), content);
    mapped.value().release();
  }
  MappedFile().release();
}

TEST_F(MappedFileTest, EmptyFileHasNoBytes) {
  auto mapped = MappedFile::open(file("empty.k", ""));
  ASSERT_TRUE(mapped.ok());
  EXPECT_TRUE(mapped.value().bytes().empty());
}

TEST_F(MappedFileTest, SaysWhyItCannotBeOpened) {
  const std::string missing = (folder_ / "none.k").string();
  const auto absent = MappedFile::open(missing);
  ASSERT_FALSE(absent.ok());
  EXPECT_EQ(absent.error().file, missing);
  EXPECT_EQ(absent.error().severity, Severity::error);
  const auto directory = MappedFile::open(folder_.string());
  ASSERT_FALSE(directory.ok());
  EXPECT_NE(directory.error().message.find("directory"), std::string::npos);
}

TEST_F(MappedFileTest, APipeDoesNotBlock) {
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(MappedFile::open(pipe).ok());
}

TEST_F(MappedFileTest, NoPermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const std::string path = file("secret.k", "x");
  fs::permissions(path, fs::perms::none);
  EXPECT_FALSE(MappedFile::open(path).ok());
}

TEST_F(MappedFileTest, NamesThatNoFileHas) {
  EXPECT_FALSE(MappedFile::open("").ok());
  EXPECT_FALSE(MappedFile::open(std::string(100'000, 'x')).ok());
}

}  // namespace
}  // namespace gapcheck::mapped_file_test
