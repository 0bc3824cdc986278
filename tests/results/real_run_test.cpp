// The files of a published run beside the decks that the project is tried on.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "read.hpp"

namespace gapcheck::results::real_run_test {
namespace {

const std::string folder = std::string(GAPCHECK_ROOT) + "/../shared/decks/tied_plate_with_run/";

class RealRun : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder + "messag")) GTEST_SKIP() << "no decks beside the project";
    messag_ = read_bytes(folder + "messag");
    d3hsp_ = read_bytes(folder + "d3hsp");
  }

  Report read(const std::vector<std::string>& names) {
    std::vector<std::string> paths;
    for (const std::string& name : names) paths.push_back(folder + name);
    auto result = read_solver_logs(paths, {}, diagnostics_);
    EXPECT_TRUE(result.ok());
    EXPECT_TRUE(diagnostics_.sorted().empty());
    return result ? std::move(result).value() : Report{};
  }

  /// All first groups of the expression over the lines of a text.
  static std::vector<std::string> grep(const std::string& text, const std::string& expression) {
    const std::regex pattern(expression);
    std::vector<std::string> found;
    std::istringstream stream(text);
    std::smatch match;
    for (std::string line; std::getline(stream, line);)
      if (std::regex_search(line, match, pattern)) found.push_back(match[1].str());
    return found;
  }

  Diagnostics diagnostics_;
  std::string messag_, d3hsp_;
};

TEST_F(RealRun, ContactsWithTitlesAndTypes) {
  for (const auto& names : {std::vector<std::string>{"messag"}, {"messag", "d3hsp"}, {"d3hsp"}}) {
    const Report report = read(names);
    ASSERT_EQ(report.contacts.size(), 4u);
    std::string text;
    for (const ContactSummary& c : report.contacts) text += std::to_string(c.id) + "|" + c.type + "|" + c.title + "\n";
    EXPECT_EQ(text,
              "80085|2|Left_on_left_action\n8008|2|Right_on_right_action\n"
              "80086|a3|Mortar silent backup for contact      80085\n"
              "8009|a3|Mortar silent backup for contact       8008\n");
    EXPECT_EQ(report.contacts[0].contact_time_s, 8.0486e-04);
    EXPECT_EQ(report.contacts[0].segments, 15u);
  }
}

TEST_F(RealRun, NumbersAsGrepFindsThem) {
  const Report report = read({"messag"});
  const SolverRun& run = *report.run;
  const auto surfaces = grep(messag_, "surface of interface +=(.*)"), steps = grep(messag_, "surface timestep +=(.*)"),
             nodes = grep(messag_, "controlling .* node ID +=(.*)"), parts = grep(messag_, "part ID of .* node +=(.*)");
  ASSERT_EQ(surfaces.size(), 4u);
  ASSERT_EQ(run.surface_timesteps.size(), surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const SurfaceTimestep& step = run.surface_timesteps[i];
    EXPECT_EQ(report.contacts[step.contact].id, std::stoll(surfaces[i]));
    EXPECT_EQ(step.timestep, std::stod(steps[i]));
    EXPECT_EQ(step.node, std::stoll(nodes[i]));
    EXPECT_EQ(step.part, std::stoll(parts[i]));
  }
  EXPECT_EQ(run.contact_timestep, std::stod(grep(messag_, "should not exceed +(.*)").at(0)));
  EXPECT_EQ(run.problem_time, std::stod(grep(messag_, "Problem time +=(.*)").at(0)));
  EXPECT_EQ(run.cycles, std::stoll(grep(messag_, "Problem cycle +=(.*)").at(0)));
  EXPECT_EQ(run.element_timestep, 1.6611e-07);
  EXPECT_EQ(run.version, "smp d R14");
  EXPECT_EQ(run.revision, "R14.0-515-g8a12796b62");
  EXPECT_EQ(run.precision, "Double precision (I8R8)");
  EXPECT_EQ(run.title, "LS-DYNA SIMULERING AF VARME DER BUKKER PLADE - J. G");
  EXPECT_FALSE(run.mpp);
  EXPECT_EQ(run.termination, SolverRun::Termination::error);
  EXPECT_EQ(read({"d3hsp"}).run->end_time, std::stod(grep(d3hsp_, R"(termination time\.+(.*))").at(0)));
  EXPECT_FALSE(run.counts_may_be_cut);
}

TEST_F(RealRun, MessagesAsGrepFindsThem) {
  const auto codes = grep(messag_, R"(\*\*\* (?:Warning|Error) +(\d+))"),
             echoed = grep(d3hsp_, R"(\*\*\* (?:Warning|Error) +(\d+))");
  ASSERT_EQ(codes, std::vector<std::string>{"60303"});
  ASSERT_EQ(echoed, codes);
  for (const auto& names : {std::vector<std::string>{"messag"}, {"messag", "d3hsp"}, {"d3hsp"}}) {
    const Report report = read(names);
    ASSERT_EQ(report.run->messages.size(), 1u);
    const SolverMessage& message = report.run->messages[0];
    EXPECT_EQ(message.code, 60303);
    EXPECT_EQ(message.group, "IMP");
    EXPECT_EQ(message.count, 1u);
    EXPECT_EQ(
        message.text,
        "Using IGAP=1 may result in zero contact forces. If this occurs set IGAP=2. Number of uses of IGAP=1 is 2");
    EXPECT_TRUE(report.penetrations.empty());
    EXPECT_TRUE(report.tie_failures.empty());
  }
}

TEST_F(RealRun, EveryTruncationOfMessagIsSurvived) {
  std::size_t contacts = 0;
  for (std::size_t size = 1; size < messag_.size() + 97; size += 97) {
    const Read read = read_text(messag_.substr(0, size));
    ASSERT_GE(read.report.contacts.size(), contacts) << size;
    contacts = read.report.contacts.size();
  }
  EXPECT_EQ(contacts, 4u);
}

}  // namespace
}  // namespace gapcheck::results::real_run_test
