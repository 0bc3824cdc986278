// Files as a full disk, a killed job or an editor leaves them: what can be read is in the report, what is wrong is said
// with file and line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fixtures.hpp"
#include "read.hpp"
#include "results/log/write_messag.hpp"

namespace gapcheck::results::bad_input_test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

std::ptrdiff_t line_at(const std::string& text, std::size_t offset) {
  return std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n') + 1;
}

TEST(BadInput, EmptyBinaryAndOtherFiles) {
  EXPECT_NE(first_error(read_text("")).find("messag:0: is empty"), std::string::npos);
  std::string binary(4096, '\0');
  for (std::size_t i = 0; i < binary.size(); i += 2) binary[i] = static_cast<char>(i);
  EXPECT_NE(first_error(read_text(binary)).find("is binary"), std::string::npos);
  EXPECT_NE(first_error(read_text("*KEYWORD\n*NODE\n       1             0.0\n*END\n")).find("no line of it"),
            std::string::npos);
}

TEST(BadInput, EveryTruncationIsSurvivedAndCutBlocksAreSaid) {
  const std::string& whole = fixtures::smp_penetrations;
  const std::size_t first = whole.find(" *** Warning"), second = whole.find(" *** Warning", first + 1);
  const std::size_t first_end = whole.find(" \n", first + 1), second_end = whole.find(" contracting");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Read read = read_text(whole.substr(0, size));
    const bool in_first = size > first + 13 && size<first_end, in_second = size> second + 13;
    const bool in_block = in_first || (in_second && size < second_end);
    // A block may end with the original coordinates: the node was not moved then.
    if (in_block && whole.compare(size, 13, "     modified") != 0) {
      EXPECT_NE(first_error(read).find(fmt::format("messag:{}: ", line_at(whole, in_first ? first : second))),
                std::string::npos)
          << size;
    }
    // What is whole is there, and nothing is there before its block has begun.
    const std::size_t least = size >= second_end ? 2 : size >= first_end ? 1 : 0;
    const std::size_t most = size <= first ? 0 : size <= second ? 1 : 2;
    EXPECT_GE(read.report.penetrations.size(), least) << size;
    EXPECT_LE(read.report.penetrations.size(), most) << size;
  }
}

TEST(BadInput, MixedLineEnds) {
  std::string text;
  int line = 0;
  for (const char c : fixtures::smp_penetrations) {
    if (c != '\n')
      text += c;
    else
      text += ++line % 3 == 0 ? "\n" : line % 3 == 1 ? "\r\n" : "\r";
  }
  const Read read = read_text(text), plain = read_text(fixtures::smp_penetrations);
  EXPECT_FALSE(read.errors) << first_error(read);
  EXPECT_EQ(write_messag(read.report), write_messag(plain.report));
  EXPECT_EQ(read.report.penetrations.at(1).line, plain.report.penetrations.at(1).line);
}

TEST(BadInput, NulBytes) {
  const std::string text = fixtures::smp_penetrations + std::string(100, '\0') + "\n";
  const Read read = read_text(text);
  EXPECT_EQ(read.report.penetrations.size(), 2u);
  EXPECT_NE(first_error(read).find(fmt::format("messag:{}: holds NUL bytes", line_at(text, text.size() - 2))),
            std::string::npos)
      << first_error(read);
}

TEST(BadInput, LineOfTenMegabytes) {
  const Read read = read_text(std::string(10'000'000, 'x') + "\n" + fixtures::smp_penetrations);
  EXPECT_EQ(read.report.penetrations.size(), 2u);
  EXPECT_NE(first_error(read).find("messag:1: is longer than"), std::string::npos) << first_error(read);
  const Read inside = read_text(
      replaced(fixtures::smp_penetrations, "     Initialization\n", "     " + std::string(10'000'000, 'y') + "\n"));
  EXPECT_EQ(inside.report.penetrations.size(), 2u);
  EXPECT_NE(first_error(inside).find("messag:5: is longer than"), std::string::npos);
}

TEST(BadInput, NumbersThatRunTogetherAndExponentsWithoutLetter) {
  std::string text = replaced(fixtures::smp_penetrations, "= -2.3980E-01 -8.0082E-02", "= -2.3980E-01-8.0082E-02");
  text = replaced(text, "=  5.0100E-01\n \n", "=  5.0100-301\n \n");
  const Read read = read_text(text);
  EXPECT_FALSE(read.errors) << first_error(read);
  EXPECT_EQ(read.report.penetrations.at(0).s, -0.2398);
  EXPECT_EQ(read.report.penetrations.at(0).t, -0.080082);
  EXPECT_EQ(read.report.penetrations.at(0).moved_to.z(), 5.01e-301);
}

TEST(BadInput, OverflowOfAField) {
  const Read depth = read_text(replaced(fixtures::smp_penetrations, "= -5.0000E-01", "= ***********"));
  EXPECT_EQ(depth.report.penetrations.size(), 2u);
  EXPECT_NE(first_error(depth).find("messag:9: the value of 'penetration' is not a number: '***********'"),
            std::string::npos)
      << first_error(depth);
  // Without its node it is no record; its text is listed.
  const Read node =
      read_text(replaced(fixtures::smp_penetrations, "node #                     = 14", "node # = ********"));
  EXPECT_EQ(node.report.penetrations.size(), 1u);
  EXPECT_NE(first_error(node).find("messag:7: "), std::string::npos) << first_error(node);
  EXPECT_EQ(node.report.run->messages.size(), 1u);
}

TEST(BadInput, BlockCutInTheMiddleByAnother) {
  const std::string& whole = fixtures::smp_penetrations;
  const std::string text = replaced(whole, whole.substr(whole.find("     penetration  "), 600), " \n");
  const Read read = read_text(text);
  EXPECT_NE(first_error(read).find("does not say the penetration"), std::string::npos) << first_error(read);
}

TEST(BadInput, TruncatedTables) {
  const std::string& d3hsp = fixtures::d3hsp_contacts;
  const Read summary = read_text(d3hsp.substr(0, d3hsp.find("        3          12")));
  EXPECT_NE(first_error(summary).find("ends inside the contact summary"), std::string::npos);
  EXPECT_EQ(summary.report.contacts.size(), 2u);
  const Read timestep = read_text("     surfa surface of interface   = 80086\n     type                 =  a 3\n");
  EXPECT_NE(first_error(timestep).find("messag:1: the file ends inside a surface time step block"), std::string::npos);
}

TEST(BadInput, MissingTerminationAloneIsNoError) {
  const Read read = read_text(" expanding   memory to 1\n");
  EXPECT_TRUE(read.diagnostics.empty());
}

TEST(BadInput, Mutations) {
  std::string seed = fixtures::d3hsp_contacts + fixtures::smp_penetrations +
                     fixtures::tie("40533 (SOL+533)", "too far from segment.", "slave", 4, 3) +
                     "       3 initial penetrations were found for interface          2\n"
                     "     surfa surface of interface   = 80086\n     surface timestep             = 1.669E-07\n";
  const std::vector<std::string> tokens{"=",
                                        "\n",
                                        "\r",
                                        " *** Warning ",
                                        "-",
                                        "********",
                                        "99999999999999999999",
                                        "1.5-3",
                                        " *** Error 10246 (KEY+246)\n of file\n p\n -----\n",
                                        "(",
                                        ")",
                                        "\t",
                                        "nan",
                                        std::string(1, '\0'),
                                        "Contact summary\n",
                                        "node",
                                        "interface",
                                        "e"};
  std::mt19937 random(11);
  for (int round = 0; round < 4000; ++round) {
    std::string text = seed;
    for (auto changes = 1 + random() % 5; changes > 0; --changes) {
      const std::size_t at = random() % (text.size() + 1);
      switch (random() % 4) {
        case 0:
          text.insert(at, tokens[random() % tokens.size()]);
          break;
        case 1:
          text.erase(at, random() % 60);
          break;
        case 2:
          if (at < text.size()) text[at] = static_cast<char>(random());
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 300));
      }
    }
    const Read read = read_text(text);
    for (const Penetration& record : read.report.penetrations) ASSERT_LT(record.contact, read.report.contacts.size());
    for (const TieFailure& record : read.report.tie_failures) ASSERT_LT(record.contact, read.report.contacts.size());
    for (const SurfaceTimestep& step : read.report.run->surface_timesteps)
      ASSERT_LT(step.contact, read.report.contacts.size());
  }
}

}  // namespace
}  // namespace gapcheck::results::bad_input_test
