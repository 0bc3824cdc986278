// Broken input: errors with file and line where the deck cannot be read, findings where it contradicts itself.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "audit/run.hpp"

namespace gapcheck::audit_test::bad_input_test {
namespace {

namespace fs = std::filesystem;

/// A small plate over a large one: four nodes penetrate by 0.3.
const std::string head = R"(*KEYWORD
*MAT_ELASTIC
         1  7.85e-09  210000.0       0.3
*SECTION_SHELL
         1         2       1.0         5
       1.0       1.0       1.0       1.0
*PART
lower plate
         1         1         1
*PART
upper plate
         2         1         1
)";
const std::string mesh = R"(*NODE
       1             0.0             0.0             0.0
       2            20.0             0.0             0.0
       3            20.0            20.0             0.0
       4             0.0            20.0             0.0
      11             4.0             4.0             0.7
      12            12.0             4.0             0.7
      13            12.0            12.0             0.7
      14             4.0            12.0             0.7
*ELEMENT_SHELL
       1       1       1       2       3       4
       2       2      11      12      13      14
)";
const std::string contact = R"(*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID
         7all parts
         0         0         5         0
       0.0
       1.0       1.0
)";

std::uint32_t lines_of(const std::string& text) {
  return static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
}

const Diagnostic* first_error(const AuditRun& run) {
  const auto found = std::find_if(run.diagnostics.begin(), run.diagnostics.end(),
                                  [](const auto& d) { return d.severity == Severity::error; });
  return found == run.diagnostics.end() ? nullptr : &*found;
}

/// Expects an error in this line of the file.
void expect_error(const AuditRun& run, const std::string& file, std::uint32_t line) {
  const auto& all = run.diagnostics;
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [&](const Diagnostic& d) {
                            return d.severity == Severity::error && fs::path(d.file).filename() == file &&
                                   d.line == line;
                          }))
      << "wanted an error in " << file << ":" << line << "; got\n"
      << describe(all);
}

/// Appends a block to a sound deck and expects an error in line `line` of that block (1 = its keyword).
void expect_error_in_block(const std::string& block, std::uint32_t line) {
  const std::string before = head + mesh + contact;
  const AuditRun run = run_text(before + block + "*END\n");
  expect_error(run, "scene.k", lines_of(before) + line);
}

std::uint64_t penetrations(const AuditRun& run) { return run.report.penetrations.size(); }

/// A folder of its own for each test.
class BadFile : public testing::Test {
 protected:
  BadFile() : folder_(fs::path(testing::TempDir()) / ("gapcheck_bad_input_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~BadFile() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    const fs::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
  fs::path folder_;
};

TEST(BadInput, TheDeckItselfIsSound) {
  const AuditRun run = run_text(head + mesh + contact + "*END\n");
  ASSERT_TRUE(clean(run));
  for (const Finding& f : run.report.findings) EXPECT_EQ(f.severity, Severity::note) << f.id << " " << f.message;
  EXPECT_EQ(penetrations(run), 4u);
}

TEST(BadInput, MissingInclude) {
  expect_error_in_block("*INCLUDE\nnot_there.k\n", 2);
  const AuditRun run = run_text(head + mesh + "*INCLUDE\nnot_there.k\n" + contact);
  ASSERT_NE(first_error(run), nullptr);
  EXPECT_NE(first_error(run)->message.find("not_there.k"), std::string::npos);
}

TEST_F(BadFile, IncludeCycle) {
  const std::string main = write("a.k", head + mesh + contact + "*INCLUDE\nb.k\n*END\n");
  (void)write("b.k", "*KEYWORD\n*INCLUDE\na.k\n*END\n");
  const AuditRun run = run_file(main);
  expect_error(run, "b.k", 3);
}

TEST_F(BadFile, IncludesItself) {
  const std::string main = write("a.k", "*KEYWORD\n*INCLUDE\na.k\n*END\n");
  expect_error(run_file(main), "a.k", 3);
}

TEST(BadInput, TruncatedCard) { expect_error_in_block("*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         8cut off\n", 1); }

TEST(BadInput, LettersInANumber) {
  expect_error_in_block("*NODE\n      21             1.0             2.x             3.0\n", 2);
  expect_error_in_block("*NODE\n      2a             1.0             2.0             3.0\n", 2);
  expect_error_in_block("*ELEMENT_SHELL\n       3       1       1       2       three   4\n", 2);
  expect_error_in_block("*SECTION_SHELL\n         9         2       1.0         5\n       one\n", 3);
}

TEST(BadInput, IdOutOfRange) {
  expect_error_in_block("*NODE\n99999999999999999999,1.0,2.0,3.0\n", 2);
  expect_error_in_block("*ELEMENT_SHELL\n3,1,1,2,99999999999999999999,4\n", 2);
}

TEST(BadInput, NotANumber) {
  expect_error_in_block("*NODE\n      21             nan             2.0             3.0\n", 2);
  expect_error_in_block("*NODE\n      21             inf             2.0             3.0\n", 2);
  expect_error_in_block("*NODE\n      21           1e400             2.0             3.0\n", 2);
}

TEST(BadInput, HugeCoordinates) {
  const std::string far =
      "*NODE\n      21           1e300             0.0             0.0\n"
      "      22           1e300           1e300             0.0\n"
      "      23           1e300             0.0          -1e300\n"
      "*ELEMENT_SHELL\n       3       1      21      22      23      23\n";
  const AuditRun run = run_text(head + mesh + far + contact + "*END\n");
  ASSERT_TRUE(run.ok);
  // Five fields are refused, each with its line.
  const std::uint32_t before = lines_of(head + mesh);
  EXPECT_EQ(run.errors(), 5u) << describe(run.diagnostics);
  for (std::uint32_t line = 2; line <= 4; ++line) expect_error(run, "scene.k", before + line);
}

TEST_F(BadFile, Empty) {
  const std::string path = write("empty.k", "");
  const AuditRun run = run_file(path);
  EXPECT_FALSE(run.ok);
  expect_error(run, "empty.k", 0);
}

TEST_F(BadFile, Binary) {
  std::string bytes(4096, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>((i * 37 + i / 7) & 0xff);
  const AuditRun run = run_file(write("binary.k", bytes));
  EXPECT_FALSE(run.ok);
  expect_error(run, "binary.k", 0);
}

TEST_F(BadFile, Directory) {
  const AuditRun run = run_file(folder_.string());
  EXPECT_FALSE(run.ok);
  EXPECT_EQ(run.errors(), 1u) << describe(run.diagnostics);
  ASSERT_NE(first_error(run), nullptr);
  EXPECT_EQ(first_error(run)->file, folder_.string());
}

TEST_F(BadFile, Missing) {
  const AuditRun run = run_file((folder_ / "missing.k").string());
  EXPECT_FALSE(run.ok);
  expect_error(run, "missing.k", 0);
}

TEST_F(BadFile, NoPermission) {
  constexpr uid_t nobody = 65534;
  const std::string path = write("secret.k", head);
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  // Root may read everything, so it acts as somebody else here.
  const bool root = geteuid() == 0;
  if (root && seteuid(nobody) != 0) GTEST_SKIP() << "root may read everything; run as another user";
  const AuditRun run = run_file(path);
  if (root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  EXPECT_FALSE(run.ok);
  expect_error(run, "secret.k", 0);
}

TEST(BadInput, UndefinedParameter) {
  expect_error_in_block("*SECTION_SHELL\n         9         2       1.0         5\n    &thick\n", 3);
  expect_error_in_block("*NODE\n      21              &x             2.0             3.0\n", 2);
}

TEST(BadInput, ParameterOfTheWrongType) {
  expect_error_in_block(
      "*PARAMETER\nC    word      text\n*SECTION_SHELL\n         9         2       1.0         5\n"
      "     &word\n",
      5);
  expect_error_in_block("*PARAMETER\nR      x       1.x\n", 2);
}

TEST(BadInput, DivisionByZero) {
  expect_error_in_block("*PARAMETER_EXPRESSION\nR      x 1.0/0.0\n", 2);
  expect_error_in_block("*PARAMETER\nR      z       0.0\n*PARAMETER_EXPRESSION\nR      x 1.0/z\n", 4);
}

/// The finding of the rule in the line given, as an error; and the rest of the model is judged as before.
void expect_finding(const std::string& block, const std::string& id, std::uint32_t line) {
  const std::string before = head + mesh;
  const AuditRun run = run_text(before + block + contact + "*END\n");
  ASSERT_TRUE(clean(run));
  EXPECT_EQ(penetrations(run), 4u);
  const auto& all = run.report.findings;
  const auto match = std::find_if(all.begin(), all.end(),
                                  [&](const Finding& f) { return f.id == id && f.line == lines_of(before) + line; });
  std::string lines;
  for (const Finding& f : all) lines += fmt::format("{} in line {}, ", f.id, f.line - lines_of(before));
  ASSERT_NE(match, all.end()) << "no " << id << " for\n" << block << lines;
  EXPECT_EQ(match->severity, Severity::error);
  EXPECT_EQ(match->file, "scene.k");
  EXPECT_FALSE(match->message.empty());
}

TEST(Contradiction, DuplicateNode) {
  expect_finding("*NODE\n      11             4.0             4.0             9.0\n", "GC501", 2);
}

TEST(Contradiction, DuplicateElement) {
  expect_finding("*ELEMENT_SHELL\n       2       2      11      12      13      14\n", "GC501", 2);
}

TEST(Contradiction, DuplicatePart) {
  expect_finding("*PART\nanother lower plate\n         1         1         1\n", "GC501", 3);
}

TEST(Contradiction, DuplicateSet) {
  const std::string set = "*SET_PART_LIST\n         5\n         1\n";
  expect_finding(set + set, "GC501", 5);
}

TEST(Contradiction, UnknownNode) {
  expect_finding("*ELEMENT_SHELL\n       3       1       1       2       3    4711\n", "GC502", 2);
}

TEST(Contradiction, UnknownPart) { expect_finding("*SET_PART_LIST\n         5\n         1        99\n", "GC502", 2); }

TEST(Contradiction, UnknownSet) {
  expect_finding(
      "*CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID\n         3\n        77         1         2         3\n"
      "       0.0\n       1.0\n",
      "GC502", 1);
}

TEST(Contradiction, EmptySurface) {
  expect_finding(
      "*PART\nno elements\n         3         1         1\n"
      "*CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID\n         3\n         3         1         3         3\n"
      "       0.0\n       1.0\n",
      "GC503", 4);
}

TEST(Contradiction, ThousandsOfThem) {
  std::string block = "*ELEMENT_SHELL\n";
  for (int i = 0; i < 5000; ++i) block += "       2       2      11      12      13      14\n";
  const AuditRun run = run_text(head + mesh + block + contact + "*END\n");
  ASSERT_TRUE(clean(run));
  EXPECT_EQ(penetrations(run), 4u);
  std::uint64_t again = 0, lines = 0;
  for (const Finding& f : run.report.findings)
    if (f.id == "GC501") again += f.count, ++lines;
  EXPECT_EQ(again, 5000u) << "each of them is counted";
  EXPECT_EQ(lines, 11u) << "ten in full and one line for the rest";
}

}  // namespace
}  // namespace gapcheck::audit_test::bad_input_test
