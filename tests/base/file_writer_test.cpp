#include "base/file_writer.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "folder_test.hpp"

namespace gapcheck::file_writer_test {
namespace {

namespace fs = std::filesystem;

class FileWriterTest : public FolderTest {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::ostringstream all;
    all << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return all.str();
  }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  [[nodiscard]] FileWriter writer(const std::string& name) const {
    auto made = FileWriter::create(path(name));
    EXPECT_TRUE(made.ok());
    return std::move(made).value();
  }
};

TEST_F(FileWriterTest, NamesThatLeadToAnotherFile) {
  std::FILE* file = std::fopen(path("a").c_str(), "wb");
  ASSERT_NE(file, nullptr);
  const FileId id = id_of(file);
  EXPECT_TRUE(check_name(path("a"), id, false).ok());
  std::fputs("text", file);
  std::fflush(file);
  EXPECT_TRUE(check_name(path("a"), id, false).ok()) << "longer";
  EXPECT_FALSE(check_name(path("a"), id, true).ok()) << "longer";
  EXPECT_TRUE(check_name(path("a"), id_of(file), true).ok());
  fs::rename(path("a"), path("b"));
  EXPECT_TRUE(check_name(path("b"), id, false).ok());
  ASSERT_FALSE(check_name(path("a"), id, false).ok()) << "moved";
  EXPECT_EQ(check_name(path("a"), id, false).error().file, path("a"));
  ASSERT_TRUE(write_file(path("a"), "another").ok());
  EXPECT_FALSE(check_name(path("a"), id, false).ok()) << "replaced";
  std::fclose(file);
}

TEST_F(FileWriterTest, TheNameChangesOnlyAtTheEnd) {
  ASSERT_TRUE(write_file(path("a"), "old").ok());
  FileWriter next = writer("a");
  EXPECT_TRUE(next.write("new "));
  EXPECT_EQ(text("a"), "old");
  EXPECT_TRUE(next.write("text"));
  EXPECT_TRUE(next.finish().ok());
  EXPECT_EQ(text("a"), "old");
  EXPECT_TRUE(next.commit().ok());
  EXPECT_EQ(text("a"), "new text");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileWriterTest, WithoutCommitNothingHasHappened) {
  ASSERT_TRUE(write_file(path("a"), "old").ok());
  writer("a").write("new");
  writer("b").write("new");
  EXPECT_EQ(text("a"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileWriterTest, AFolderThatMovesKeepsNothingOfIt) {
  for (const bool commits : {false, true}) {
    ASSERT_TRUE(fs::create_directory(path("here")));
    {
      FileWriter uncommitted = writer("here/a");
      uncommitted.write("text");
      fs::rename(path("here"), path("there"));
      if (commits) {
        const Status committed = uncommitted.commit();
        ASSERT_FALSE(committed.ok());
        EXPECT_EQ(committed.error().file, path("here/a"));
      }
    }
    EXPECT_TRUE(fs::is_empty(path("there"))) << commits;
    fs::remove(path("there"));
  }
}

TEST_F(FileWriterTest, TheModeIsTheUsualOneOrThatOfTheOldFile) {
  const mode_t before = ::umask(027);
  ASSERT_TRUE(write_file(path("a"), "x").ok());
  ::umask(before);
  EXPECT_EQ(fs::status(path("a")).permissions(), static_cast<fs::perms>(0640));
  fs::permissions(path("a"), static_cast<fs::perms>(0604));
  ASSERT_TRUE(write_file(path("a"), "y").ok());
  EXPECT_EQ(fs::status(path("a")).permissions(), static_cast<fs::perms>(0604));
}

TEST_F(FileWriterTest, LinksLeadToTheNewText) {
  fs::create_directory(path("d"));
  ASSERT_TRUE(write_file(path("d/a"), "old").ok());
  fs::create_symlink("d/a", path("link"));
  fs::create_symlink("link", path("link2"));
  ASSERT_TRUE(write_file(path("link2"), "new").ok());
  EXPECT_TRUE(fs::is_symlink(path("link")) && fs::is_symlink(path("link2")));
  EXPECT_EQ(text("d/a"), "new");
  fs::create_symlink("d/not yet", path("link3"));
  ASSERT_TRUE(write_file(path("link3"), "first").ok());
  EXPECT_EQ(text("d/not yet"), "first");
  fs::create_symlink("round", path("round"));
  EXPECT_FALSE(write_file(path("round"), "x").ok());
}

TEST_F(FileWriterTest, OtherHardLinksKeepTheOldText) {
  ASSERT_TRUE(write_file(path("a"), "old").ok());
  fs::create_hard_link(path("a"), path("b"));
  ASSERT_TRUE(write_file(path("a"), "new").ok());
  EXPECT_EQ(text("a"), "new");
  EXPECT_EQ(text("b"), "old");
}

TEST_F(FileWriterTest, WhatIsNoRegularFileIsWrittenDirectly) {
  EXPECT_TRUE(write_file("/dev/null", "x").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const auto full = write_file("/dev/full", "x");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().file, "/dev/full");
  EXPECT_EQ(full.error().message, "cannot be written: No space left on device");
  fs::create_symlink("/dev/full", path("full"));
  EXPECT_FALSE(write_file(path("full"), "x").ok());
  EXPECT_TRUE(fs::is_symlink(path("full")));
  // The standard output of a process may be a file, which must not get another identity.
  ASSERT_TRUE(write_file(path("out"), "").ok());
  struct stat before {
  }, after{};
  ASSERT_EQ(::stat(path("out").c_str(), &before), 0);
  if (const pid_t child = ::fork(); child == 0) {
    const bool moved = std::freopen(path("out").c_str(), "wb", stdout) != nullptr;
    ::_exit(moved && write_file("/dev/stdout", "text").ok() ? 0 : 1);
  } else {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  ASSERT_EQ(::stat(path("out").c_str(), &after), 0);
  EXPECT_EQ(before.st_ino, after.st_ino);
  EXPECT_EQ(text("out"), "text");
}

TEST_F(FileWriterTest, SaysWhyItCannotWrite) {
  const auto missing = write_file(path("no/where"), "x");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().file, path("no/where"));
  EXPECT_EQ(missing.error().message, "cannot be written: No such file or directory");
  EXPECT_FALSE(write_file(path(""), "x").ok());
  EXPECT_FALSE(write_file("", "x").ok());
  EXPECT_FALSE(write_file(path(std::string(300, 'x')), "x").ok());
  EXPECT_EQ(entries(), 0u);
  fs::create_directory(path("d"));
  EXPECT_FALSE(write_file(path("d"), "x").ok());
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileWriterTest, AFullDiskLeavesTheOldText) {
  ASSERT_TRUE(write_file(path("a"), "old").ok());
  // A limit of the size of files is the full disk that every machine has.
  if (const pid_t child = ::fork(); child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const Status written = write_file(path("a"), std::string(100000, 'x'));
    ::_exit(!written.ok() && written.error().message == "cannot be written: File too large" ? 0 : 1);
  } else {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(text("a"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileWriterTest, WriteProtectedFilesStay) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  ASSERT_TRUE(write_file(path("a"), "old").ok());
  fs::permissions(path("a"), fs::perms::owner_read);
  EXPECT_FALSE(write_file(path("a"), "new").ok());
  EXPECT_EQ(text("a"), "old");
  fs::permissions(path("a"), static_cast<fs::perms>(0600));
  fs::permissions(folder_, static_cast<fs::perms>(0500));
  EXPECT_TRUE(write_file(path("a"), "new").ok()) << "the folder takes no new file, but the file takes a new text";
  fs::permissions(folder_, static_cast<fs::perms>(0700));
  EXPECT_EQ(text("a"), "new");
}

TEST_F(FileWriterTest, UncommittedFilesCanBeDeletedAtOnce) {
  if (const pid_t child = ::fork(); child == 0) {
    FileWriter a = writer("a"), b = writer("b"), c = writer("c");
    a.write(std::string(100000, 'x'));
    const bool kept = c.commit().ok() && entries() == 3;
    remove_uncommitted_files();
    const bool removed = entries() == 1 && fs::exists(path("c"));
    FileWriter d = writer("d");
    ::_exit(kept && removed && entries() == 1 ? 0 : 1);
  } else {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
}

}  // namespace
}  // namespace gapcheck::file_writer_test
