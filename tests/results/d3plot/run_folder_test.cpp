#include "results/d3plot/run_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "folder_test.hpp"
#include "results/curves/glstat.hpp"
#include "results/d3plot/d3plot_write.hpp"
#include "results/log/run_log.hpp"

namespace gapcheck::results::run_folder_test {
namespace {

namespace fs = std::filesystem;

class RunFolder : public FolderTest {
 protected:
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string foreign() const {
    std::string names;
    for (const std::string& path : foreign_results(folder_.string())) names += fs::path(path).filename().string() + ' ';
    return names;
  }
  void own_plot(int word_bytes) const {
    D3plot mesh;
    mesh.title = "a model";
    mesh.node_ids = {1};
    mesh.coordinates = {{0, 0, 0}};
    D3plotWriteSettings settings;
    settings.word_bytes = word_bytes;
    ASSERT_TRUE(D3plotWriter::create((folder_ / "d3plot").string(), mesh, {{1, "part"}}, settings).ok());
  }
};

TEST_F(RunFolder, OwnResultsAreKnownByTheirMarks) {
  const FileHeader header{"a model", "gapcheck 0.1.0"};
  file("messag", log_banner(header));
  file("glstat", glstat_header(header));
  for (const int word_bytes : {4, 8}) {
    own_plot(word_bytes);
    file("d3plot01", "states");
    file("sleout", "");
    file("notes", "of the user");
    EXPECT_EQ(foreign(), "");
    EXPECT_EQ(result_files(folder_.string()).size(), 5u);
  }
}

TEST_F(RunFolder, OthersAreForeign) {
  file("messag", "     |  LS-DYNA, A Program for Nonlinear Dynamic      |\n");
  file("glstat", " gapcheck 0.1.0\n                         ls-dyna mpp.123456 d\n");
  file("rcforc", "x");
  file("d3plot", std::string(4096, '\1'));
  file("d3plot02", "states");
  file("d3plot2a", "nothing of a run");
  EXPECT_EQ(foreign(), "d3plot d3plot02 glstat messag rcforc ");
  own_plot(4);
  EXPECT_EQ(foreign(), "glstat messag rcforc ");
  fs::remove(folder_ / "d3plot");
  file("d3plot07", "states of nobody knows what");
  fs::create_directory(folder_ / "nodout");
  EXPECT_EQ(foreign(), "d3plot07 glstat messag nodout rcforc ");
  EXPECT_TRUE(foreign_results((folder_ / "none").string()).empty());
}

// The reader takes all members up to the first that is missing: an old one behind a gap would follow the new ones.
TEST_F(RunFolder, OldMembersAreRemovedAlsoBehindAGap) {
  for (const char* name : {"d3plot", "d3plot01", "d3plot03", "d3plot104", "d3plot1x", "d3plots"}) file(name, "old");
  fs::create_hard_link(folder_ / "d3plot", folder_ / "kept");
  own_plot(4);
  for (const char* name : {"d3plot01", "d3plot03", "d3plot104"}) EXPECT_FALSE(fs::exists(folder_ / name)) << name;
  for (const char* name : {"d3plot", "d3plot1x", "d3plots"}) EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_EQ(fs::file_size(folder_ / "kept"), 3u) << "what is linked to an old result stays";
}

}  // namespace
}  // namespace gapcheck::results::run_folder_test
