#include "results/log/run_log.hpp"

#include <gtest/gtest.h>

#include "results/log/solver_log.hpp"
#include "results/log/write_messag.hpp"

namespace gapcheck::results::run_log_test {
namespace {

const FileHeader header{"two plates", "gapcheck 0.1.0"};

ContactDefinition definition() {
  ContactDefinition contact;
  contact.id = 80085;
  contact.order = 1;
  contact.type = "a3";
  contact.title = "Left_on_left_action";
  contact.segments_a = 300;
  contact.segments_b = 15;
  return contact;
}

void expect_line(const std::string& text, const std::string& line) {
  EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << line;
}

TEST(RunLog, ContactDefinitionsAsInD3hsp) {
  const std::string text = contact_definitions(std::vector{definition()});
  expect_line(text, " Contact Interface  80085");
  expect_line(text, "Left_on_left_action                                                   ");
  expect_line(text, "       contact type.................................   a 3");
  expect_line(text, "       contact interface ID .......................     80085");
  expect_line(text, "       contact order within input deck .............        1");
  expect_line(text, "       no. of surfa segments........................      300");
  expect_line(text, "       no. of surfb segments........................       15");
  expect_line(text, "       static coefficient of friction ..............    0.00000E+00");
  expect_line(text, "       scale factor on surfb thickness (def.=1.0)...    0.10000E+01");
  expect_line(text, "       death time ..................................    0.10000E+21");
  expect_line(text,
              "        1       80085    a 3 Left_on_left_action                                                   ");
  EXPECT_EQ(contact_definitions({}), "");
}

TEST(RunLog, TimeStepsAsInMessag) {
  ContactSummary contact;
  contact.id = 80086;
  Timesteps steps;
  steps.surface_timesteps = {{0, 'A', "a3", 1.669e-7, 1, 1}, {0, 'B', "a3", 1.605e-6, 19394, 2}};
  const std::string text = surface_timesteps(steps, std::vector{contact});
  EXPECT_EQ(text.substr(0, text.find("\n The")),
            "\n"
            "     surfa surface of interface   = 80086\n"
            "     type                         =       a 3\n"
            "     surface timestep             = 1.669E-07\n"
            "     controlling surfa node ID    = 1\n"
            "     part ID of surfa node        = 1\n"
            "     current minimum time step    = 1.669E-07\n"
            "\n"
            "     surfb surface of interface   = 80086\n"
            "     type                         =       a 3\n"
            "     surface timestep             = 1.605E-06\n"
            "     controlling surfb node ID    = 19394\n"
            "     part ID of surfb node        = 2\n"
            "     current minimum time step    = 1.669E-07\n");
  EXPECT_NE(text.find(" should not exceed     1.669E-07\n"), std::string::npos);
  expect_line(smallest_timesteps(std::vector{ElementStep{"solid", 14351, 1, 1.6611e-7}}),
              " solid          14351                   1  1.6611E-07");
}

TEST(RunLog, IsReadBack) {
  Report report;
  ContactSummary contact;
  contact.id = 80085;
  report.contacts = {contact};
  Penetration p;
  p.node = 14;
  p.segment = {1, 2, 3, 4};
  p.segment_number = 7;
  p.depth = 0.5;
  p.contact_distance = 1;
  p.outcome = Outcome::moved;
  p.moved_to = {0, 0, 0.501};
  report.penetrations = {p};
  Timesteps steps;
  steps.surface_timesteps = {{0, 'A', "a3", 1.669e-7, 1, 1}};
  const std::string text =
      log_banner(header) + contact_definitions(std::vector{definition()}) + message_blocks(report) +
      surface_timesteps(steps, report.contacts) + smallest_timesteps(std::vector{ElementStep{"shell", 5, 2, 2.5e-7}}) +
      cycle_line(1, 0, 2.12e-4, "write d3plot file") + log_end(true, "termination time reached", 0.125, 1234);
  Diagnostics diagnostics;
  const Report read = read_solver_log_text(text, "d3hsp", {}, diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty());
  ASSERT_EQ(read.contacts.size(), 1u);
  EXPECT_EQ(read.contacts[0].id, 80085);
  EXPECT_EQ(read.contacts[0].type, "a3");
  EXPECT_EQ(read.contacts[0].title, "Left_on_left_action");
  EXPECT_EQ(read.contacts[0].segments, 15u);
  ASSERT_EQ(read.penetrations.size(), 1u);
  EXPECT_EQ(read.penetrations[0].node, 14);
  EXPECT_EQ(read.penetrations[0].moved_to.z(), 0.501);
  ASSERT_TRUE(read.run);
  EXPECT_EQ(read.run->version, "gapcheck 0.1.0");
  EXPECT_EQ(read.run->title, "two plates");
  EXPECT_EQ(read.run->termination, SolverRun::Termination::normal);
  EXPECT_EQ(read.run->problem_time, 0.125);
  EXPECT_EQ(read.run->cycles, 1234);
  EXPECT_EQ(read.run->contact_timestep, 1.669e-7);
  EXPECT_EQ(read.run->element_timestep, 2.5e-7);
  ASSERT_EQ(read.run->surface_timesteps.size(), 1u);
}

TEST(RunLog, AnErrorIsReadBack) {
  const std::string text = log_banner(header) + error_block("solid 5 has no positive volume at time 0.1") +
                           log_end(false, "termination due to an error", 0.1, 10);
  Diagnostics diagnostics;
  const Report read = read_solver_log_text(text, "messag", {}, diagnostics);
  EXPECT_EQ(read.run->termination, SolverRun::Termination::error);
  ASSERT_EQ(read.run->messages.size(), 1u);
  EXPECT_EQ(read.run->messages[0].text, "solid 5 has no positive volume at time 0.1");
}

}  // namespace
}  // namespace gapcheck::results::run_log_test
