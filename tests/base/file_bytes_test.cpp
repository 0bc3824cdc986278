#include "base/file_bytes.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "folder_test.hpp"

namespace gapcheck::file_bytes_test {
namespace {

namespace fs = std::filesystem;

class FileBytesTest : public FolderTest {
 protected:
  std::string file(const std::string& name, const std::string& content) {
    const fs::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << content;
    return path.string();
  }
};

TEST_F(FileBytesTest, HasTheBytesOfTheFile) {
  std::string content("a\0b\r\n", 5);
  for (int i = 0; i < 20000; ++i) content += static_cast<char>(i % 251);
  auto read = FileBytes::open(file("a.k", content));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value().bytes(), content);
}

TEST_F(FileBytesTest, StaysAtItsAddressWhenMoved) {
  auto read = FileBytes::open(file("a.k", "content"));
  ASSERT_TRUE(read.ok());
  const char* address = read.value().bytes().data();
  FileBytes moved = std::move(read).value();
  FileBytes assigned;
  assigned = std::move(moved);
  EXPECT_EQ(assigned.bytes().data(), address);
  EXPECT_EQ(assigned.bytes(), "content");
}

TEST_F(FileBytesTest, PieceByPiece) {
  std::string content(20'000'000, 'x');
  for (std::size_t i = 0; i < content.size(); i += 997) content[i] = static_cast<char>(i % 251);
  auto read = FileBytes::begin(file("a.k", content));
  ASSERT_TRUE(read.ok());
  FileBytes& bytes = read.value();
  EXPECT_EQ(bytes.size(), content.size());
  EXPECT_EQ(bytes.bytes(), "");
  const char* address = bytes.bytes().data();
  for (const std::size_t end : {std::size_t{1}, std::size_t{9'000'000}, std::size_t{9'000'001}, content.size() * 2}) {
    ASSERT_TRUE(bytes.load(end).ok());
    EXPECT_GE(bytes.bytes().size(), std::min(end, content.size()));
    EXPECT_TRUE(bytes.bytes() == std::string_view(content).substr(0, bytes.bytes().size()));
    EXPECT_EQ(bytes.bytes().data(), address);
  }
  bytes.release(100, 10'000'000);
  EXPECT_TRUE(bytes.bytes().substr(0, 100) == content.substr(0, 100));
  EXPECT_TRUE(bytes.bytes().substr(10'000'000) == content.substr(10'000'000));
}

// With a mapping this would be SIGBUS.
TEST_F(FileBytesTest, AFileThatBecomesShorter) {
  const std::string path = file("a.k", std::string(20'000'000, 'x'));
  auto read = FileBytes::open(path), begun = FileBytes::begin(path);
  ASSERT_TRUE(read.ok() && begun.ok());
  EXPECT_TRUE(read.value().unchanged().ok());
  ASSERT_TRUE(begun.value().load(1).ok());
  fs::resize_file(path, 10'000'000);
  const Status rest = begun.value().load(20'000'000);
  ASSERT_FALSE(rest.ok());
  EXPECT_EQ(rest.error().file, path);
  EXPECT_NE(rest.error().message.find("became shorter"), std::string::npos);
  EXPECT_EQ(begun.value().bytes(), std::string(begun.value().bytes().size(), 'x'));
  EXPECT_TRUE(read.value().bytes() == std::string(20'000'000, 'x'));
  EXPECT_FALSE(read.value().unchanged().ok());
}

TEST_F(FileBytesTest, AFileThatGrowsEndsWhereItDid) {
  const std::string path = file("a.k", std::string(9'000'000, 'x'));
  auto begun = FileBytes::begin(path);
  ASSERT_TRUE(begun.ok());
  std::ofstream(path, std::ios::app) << "more";
  ASSERT_TRUE(begun.value().load(100'000'000).ok());
  EXPECT_EQ(begun.value().bytes().size(), 9'000'000u);
}

TEST_F(FileBytesTest, KnowsWhetherTheFileIsTheSame) {
  const std::string path = file("a.k", "text");
  const auto read = FileBytes::open(path);
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(read.value().unchanged().ok());
  const auto time = fs::last_write_time(path);
  file("b.k", "text");
  fs::last_write_time(folder_ / "b.k", time);
  fs::rename(folder_ / "b.k", path);
  EXPECT_FALSE(read.value().unchanged().ok()) << "another file of the same name, size and time";
  fs::remove(path);
  EXPECT_FALSE(read.value().unchanged().ok());
}

TEST_F(FileBytesTest, EmptyFileHasNoBytes) {
  auto read = FileBytes::open(file("empty.k", ""));
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(read.value().bytes().empty());
}

TEST_F(FileBytesTest, SaysWhyItCannotBeOpened) {
  const std::string missing = (folder_ / "none.k").string();
  const auto absent = FileBytes::open(missing);
  ASSERT_FALSE(absent.ok());
  EXPECT_EQ(absent.error().file, missing);
  EXPECT_EQ(absent.error().severity, Severity::error);
  const auto directory = FileBytes::open(folder_.string());
  ASSERT_FALSE(directory.ok());
  EXPECT_NE(directory.error().message.find("directory"), std::string::npos);
}

TEST_F(FileBytesTest, APipeDoesNotBlock) {
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(FileBytes::open(pipe).ok());
}

TEST_F(FileBytesTest, NoPermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const std::string path = file("secret.k", "x");
  fs::permissions(path, fs::perms::none);
  EXPECT_FALSE(FileBytes::open(path).ok());
}

TEST_F(FileBytesTest, NamesThatNoFileHas) {
  EXPECT_FALSE(FileBytes::open("").ok());
  EXPECT_FALSE(FileBytes::open(std::string(100'000, 'x')).ok());
}

}  // namespace
}  // namespace gapcheck::file_bytes_test
