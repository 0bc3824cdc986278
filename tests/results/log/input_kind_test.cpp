#include "results/log/input_kind.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace gapcheck::results::input_kind_test {
namespace {

namespace fs = std::filesystem;

class InputKindTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "gapcheck_XXXXXX";
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) {
    const fs::path path = folder_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

TEST_F(InputKindTest, DecksByExtensionOrFirstLine) {
  for (const char* name : {"a.k", "a.KEY", "a.dyn"}) EXPECT_TRUE(recognise(write(name, "")).value().deck) << name;
  for (const char* text : {"*KEYWORD\n", "$ comment\n\n \n*NODE\n", "$ comment\r*NODE\r", "\xEF\xBB\xBF*KEYWORD\n"})
    EXPECT_TRUE(recognise(write("plain", text)).value().deck) << text;
  for (const char* text : {"", " *** Warning 40565\n", "*\n", "Date: 1\n*KEYWORD\n"}) {
    const InputKind kind = recognise(write("plain", text)).value();
    EXPECT_FALSE(kind.deck) << text;
    EXPECT_FALSE(kind.directory);
    EXPECT_EQ(kind.files, std::vector{path("plain")});
  }
  EXPECT_FALSE(recognise(path("missing")).ok());
}

TEST_F(InputKindTest, LogsOfADirectory) {
  EXPECT_EQ(recognise(folder_.string()).error().message,
            "the directory has no messag, mes0000 or d3hsp; name the file");
  write("d3hsp", "");
  EXPECT_EQ(recognise(folder_.string()).value().files, std::vector{path("d3hsp")});
  for (const char* name : {"mes0001", "mes0000", "mesage"}) write(name, "");
  EXPECT_EQ(recognise(folder_.string()).value().files, (std::vector{path("mes0000"), path("mes0001")}));
  write("messag", "");
  const InputKind kind = recognise(folder_.string()).value();
  EXPECT_EQ(kind.files, std::vector{path("messag")});
  EXPECT_TRUE(kind.directory);
  EXPECT_FALSE(kind.deck);
}

TEST_F(InputKindTest, DirectoriesAmongLogs) {
  const std::string run = write("run/messag", ""), other = path("other");
  EXPECT_EQ(log_files({other, path("run")}).value(), (std::vector{other, run}));
  fs::create_directory(folder_ / "empty");
  EXPECT_EQ(log_files({other, path("empty")}).error().file, path("empty"));
}

}  // namespace
}  // namespace gapcheck::results::input_kind_test
