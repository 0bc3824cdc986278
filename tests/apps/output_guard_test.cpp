// No command writes over what it reads.
#include <algorithm>
#include <utility>
#include <vector>

#include "apps/program.hpp"

namespace gapcheck::output_guard_test {
namespace {

namespace fs = std::filesystem;

class OutputGuard : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::create_directories(folder_ / "D/sub");
    file("D/m.k", "*KEYWORD\n*INCLUDE\nmesh.inc\n*END\n");
    file("D/mesh.inc", content(project / "data/two_plates.k"));
  }
  /// Every file below the folder, with its text.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> all_files() const {
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.is_regular_file() && entry.path().filename() != ".stderr")
        files.emplace_back(entry.path().string(), content(entry.path()));
    std::sort(files.begin(), files.end());
    return files;
  }
  void refuses(const std::string& arguments, const std::string& why) const {
    const auto before = all_files();
    const Ended run = gapcheck(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_NE(run.err.find(why), std::string::npos) << arguments << ": " << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(all_files(), before) << arguments;
  }
};

TEST_F(OutputGuard, Audit) {
  refuses("audit D/m.k --key D/mesh.inc", "--key D/mesh.inc is a file that D/m.k includes; give another file to write");
  refuses("audit D/m.k --html D/sub/../mesh.inc", "is a file that D/m.k includes, D/mesh.inc");
  refuses("audit D/m.k --output D/m.k", "--output D/m.k is the deck itself");
  refuses("audit D/m.k --html x --key x", "--html x and --key x are one file; give each its own");
  refuses("audit D/m.k --key ./new --output new", "--output new and --key ./new are one file; give each its own");
  fs::create_hard_link(folder_ / "D/mesh.inc", folder_ / "other_name");
  refuses("audit D/m.k --vtu other_name", "is a file that D/m.k includes, D/mesh.inc");
}

TEST_F(OutputGuard, NamesOfDecksThatAreIncludes) {
  file("D/two.k", "*KEYWORD\n*INCLUDE\nout/D/m\n*END\n");
  fs::create_directories(folder_ / "D/out/D");
  file("D/out/D/m", content(project / "data/two_plates.k"));
  refuses("audit D/m.k D/two.k --key 'D/out/{deck}'", "--key D/out/D/m is a file that D/two.k includes");
}

TEST_F(OutputGuard, SettingsAndBaselines) {
  file("D/gapcheck.toml", "top = 3\n");
  refuses("audit D/m.k --output D/gapcheck.toml", "is the settings file");
  refuses("fix D/m.k --dry-run --output D/gapcheck.toml", "is the settings file");
  EXPECT_EQ(gapcheck("audit D/m.k --quiet --write-baseline known").code, 0);
  refuses("audit D/m.k --baseline known --output known", "--output known is the baseline to compare with");
  refuses("audit D/m.k --baseline known --write-baseline known --key known", "are one file");
  EXPECT_EQ(gapcheck("audit D/m.k --quiet --baseline known --write-baseline known").code, 0);
}

TEST_F(OutputGuard, Fix) {
  refuses("fix D/m.k --dry-run --output D/mesh.inc", "--output D/mesh.inc is a file that the deck includes");
  refuses("fix D/m.k -o o --output D/m.k", "--output D/m.k is the deck itself");
  refuses("fix D/m.k -o o --output o/mesh.inc", "--output o/mesh.inc and -o o/mesh.inc are one file");
}

TEST_F(OutputGuard, MessagAndCompare) {
  use("smp");
  for (const char* option : {"--key", "--html", "--vtu", "--sets", "--output"}) {
    refuses(std::string("messag messag ") + option + " messag", std::string(option) + " messag is a log that is read");
    refuses(std::string("messag messag --deck D/m.k ") + option + " D/mesh.inc", "is a file that D/m.k includes");
  }
  refuses("messag . --output ./messag", "is a log that is read");
  refuses("compare D/m.k messag --output D/m.k", "--output D/m.k is the deck itself");
  refuses("compare D/m.k D/mesh.inc --output D/mesh.inc", "D/mesh.inc");
  refuses("compare messag D/m.k --output messag", "--output messag is one of those compared");
}

TEST_F(OutputGuard, CheckC) {
  use("smp");
  const std::string log = content(folder_ / "messag");
  const auto refuses = [&](const std::string& arguments, const std::string& why) {
    const auto before = all_files();
    const Ended run = check_c(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_NE(run.err.find(why), std::string::npos) << arguments << ": " << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(all_files(), before) << arguments;
  };
  for (const auto& [option, name] : {std::pair("-key", "check-c.key"), std::pair("-ani", "check-c.ses"),
                                     std::pair("-a4sel", "check-c.ses"), std::pair("-medina", "check-c.prt")}) {
    const std::string words = std::string(option) + ": " + name + " is ";
    fs::rename(folder_ / "messag", folder_ / name);
    refuses(std::string(option) + ' ' + name, words + "a file that is read");
    refuses(std::string(option) + " ./D/../" + name, words + "a file that is read");
    fs::rename(folder_ / name, folder_ / "messag");
    fs::create_symlink("messag", folder_ / name);
    refuses(std::string(option) + " messag", words + "a file that is read, messag");
    fs::remove(folder_ / name);
    fs::create_hard_link(folder_ / "d3hsp", folder_ / name);
    refuses(std::string(option) + " messag", words + "a file of the run, d3hsp");
    fs::remove(folder_ / name);
    fs::create_hard_link(folder_ / "D/mesh.inc", folder_ / name);
    refuses(std::string(option) + " --deck D/m.k messag", words + "a file that D/m.k includes");
    fs::remove(folder_ / name);
    file("table", "kind soft2-intersection\ncodes 49999\n");
    fs::create_symlink("table", folder_ / name);
    refuses(std::string(option) + " --messages table messag", words + "a table of messages");
    fs::remove(folder_ / name);
  }
  EXPECT_EQ(check_c("-key -a4sel -medina messag").code, 1);
  EXPECT_EQ(check_c("-key -a4sel -medina messag").code, 1) << "its own old files are replaced";
}

TEST_F(OutputGuard, StreamsTakeWhatComes) {
  const Ended run = gapcheck("audit D/m.k --quiet --output /dev/stdout --html /dev/null --key /dev/null");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("D/m.k: ", 0), 0u) << run.out;
  for (int i = 0; i < 2; ++i) EXPECT_EQ(gapcheck("audit D/m.k --quiet --output again --html page.html").code, 0);
}

}  // namespace
}  // namespace gapcheck::output_guard_test
