#include "base/system/files.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include "folder_test.hpp"

namespace gapcheck::system_test {
namespace {

class SystemFilesTest : public FolderTest {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
  }
};

TEST_F(SystemFilesTest, ReadsAtAnyPlaceUpToTheEnd) {
  const int descriptor = system::open_to_read(file("a", "0123456789"));
  ASSERT_GE(descriptor, 0);
  std::string got(20, ' ');
  EXPECT_EQ(system::read_at(descriptor, got.data(), 4, 3), 4);
  EXPECT_EQ(got.substr(0, 4), "3456");
  EXPECT_EQ(system::read_at(descriptor, got.data(), 20, 7), 3);
  EXPECT_EQ(system::read_at(descriptor, got.data(), 20, 10), 0);
  EXPECT_EQ(system::read_at(descriptor, got.data(), 20, 1000), 0);
  system::close(descriptor);
  EXPECT_EQ(system::read_at(descriptor, got.data(), 1, 0), -1);
}

TEST_F(SystemFilesTest, StatesTellFilesApart) {
  system::FileState a, again, b, folder;
  ASSERT_TRUE(system::state_of(file("a", "four"), a) && system::state_of(path("a"), again));
  ASSERT_TRUE(system::state_of(file("b", ""), b) && system::state_of(folder_.string(), folder));
  EXPECT_EQ(a.kind, system::FileKind::regular);
  EXPECT_EQ(a.size, 4U);
  EXPECT_EQ(a.inode, again.inode);
  EXPECT_NE(a.inode, b.inode);
  EXPECT_EQ(folder.kind, system::FileKind::folder);
  EXPECT_FALSE(system::state_of(path("none"), a));
  EXPECT_EQ(errno, ENOENT);
}

TEST_F(SystemFilesTest, NewFilesInAFolder) {
  const int folder = system::open_folder(folder_.string());
  ASSERT_GE(folder, 0);
  const int made = system::create_in(folder, "new");
  ASSERT_GE(made, 0);
  EXPECT_EQ(system::write_some(made, "text"), 4);
  system::close(made);
  EXPECT_EQ(text_of("new"), "text");
  EXPECT_EQ(system::create_in(folder, "new"), -1);
  EXPECT_EQ(errno, EEXIST);
  system::remove_in(folder, "new");
  EXPECT_FALSE(std::filesystem::exists(path("new")));
  system::close(folder);
  EXPECT_EQ(system::open_folder(path("none")), -1);
}

TEST_F(SystemFilesTest, TakesTheNameOfAnother) {
  file("old", "old");
  ASSERT_TRUE(system::rename_over(file("new", "new"), path("old")));
  EXPECT_EQ(text_of("old"), "new");
  EXPECT_FALSE(std::filesystem::exists(path("new")));
  EXPECT_FALSE(system::rename_over(path("new"), path("old")));
  EXPECT_EQ(errno, ENOENT);
}

TEST_F(SystemFilesTest, LocksShortensAndSeeks) {
  file("a", "0123456789");
  std::FILE* first = system::open_stream(path("a"), "ab");
  std::FILE* second = system::open_stream(path("a"), "ab");
  ASSERT_TRUE(first != nullptr && second != nullptr);
  EXPECT_TRUE(system::lock(system::descriptor_of(first)));
  EXPECT_FALSE(system::lock(system::descriptor_of(second)));
  EXPECT_TRUE(system::shorten(system::descriptor_of(first), 6));
  std::fclose(first);
  EXPECT_TRUE(system::lock(system::descriptor_of(second)));
  std::fclose(second);
  EXPECT_EQ(text_of("a"), "012345");
  std::FILE* again = system::open_stream(path("a"), "wb");
  std::fputs("abc", again);
  EXPECT_TRUE(system::seek(again, 1));
  std::fputs("X", again);
  std::fclose(again);
  EXPECT_EQ(text_of("a"), "aXc");
}

TEST(SystemFiles, NamesOfStreams) {
  EXPECT_TRUE(system::names_stream("/dev/stdout"));
  EXPECT_TRUE(system::names_stream("/proc/self/fd/1"));
  EXPECT_FALSE(system::names_stream("/devices/a"));
}

}  // namespace
}  // namespace gapcheck::system_test
