#include "results/log/solver_log.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "results/fixtures.hpp"
#include "results/read.hpp"

namespace gapcheck::results::solver_log_test {
namespace {

TEST(SolverLog, PenetrationRecordsOfSmp) {
  const Read read = read_text(fixtures::smp_penetrations);
  EXPECT_FALSE(read.errors) << first_error(read);
  const Report& report = read.report;
  EXPECT_EQ(report.source, "messag");
  EXPECT_EQ(contact_ids(report), (std::vector<std::int64_t>{1, 2}));
  ASSERT_EQ(report.penetrations.size(), 2u);
  const Penetration& quad = report.penetrations[0];
  EXPECT_EQ(quad.node, 14);
  EXPECT_EQ(quad.segment_number, 223u);
  EXPECT_EQ(quad.segment, (std::array<std::int64_t, 4>{22124, 22164, 22165, 22125}));
  EXPECT_EQ(quad.depth, 0.5);
  EXPECT_EQ(quad.contact_distance, 1.0);
  EXPECT_EQ(quad.s, -0.23980);
  EXPECT_EQ(quad.t, -0.080082);
  EXPECT_EQ(quad.original, Vector(-28.868, -4.9561, 0));
  EXPECT_EQ(quad.moved_to, Vector(-28.868, -4.9561, 0.501));
  EXPECT_NEAR((quad.point - Vector(-28.868, -4.9561, -0.5)).norm(), 0, 1e-12);
  EXPECT_EQ(quad.outcome, Outcome::moved);
  EXPECT_EQ(quad.feature, Feature::face);
  EXPECT_EQ(quad.kind, PenetrationKind::initial);
  EXPECT_EQ(quad.line, 4u);
  const Penetration& corner = report.penetrations[1];
  EXPECT_EQ(corner.segment, (std::array<std::int64_t, 4>{21597, 21130, 21600, 21600}));
  EXPECT_EQ(corner.feature, Feature::corner);
  EXPECT_NEAR(corner.contact_distance, 1.0, 1e-12);
  EXPECT_EQ(report.contacts[0].penetrations, 1u);
  EXPECT_EQ(report.contacts[0].max_penetration, 0.5);
  EXPECT_EQ(report.contacts[1].max_penetration, 0.749);
  EXPECT_TRUE(report.run->messages.empty());
}

TEST(SolverLog, WithoutModifiedCoordinatesTheNodeIsOnlyReported) {
  std::string text = fixtures::smp_penetrations;
  const std::size_t begin = text.find("     modified"), end = text.find(" \n", begin);
  text.erase(begin, end - begin);
  const Read read = read_text(text);
  EXPECT_FALSE(read.errors) << first_error(read);
  const Penetration& record = read.report.penetrations.at(0);
  EXPECT_EQ(record.outcome, Outcome::reported);
  EXPECT_EQ(record.moved_to, record.original);
  EXPECT_EQ(record.point, record.original);
}

/// The lines of a block wrap, join and lose their blanks on the way through other programs.
TEST(SolverLog, WrappedLinesOfARecord) {
  const Read plain = read_text(fixtures::smp_penetrations);
  const auto same = [&](const std::string& before, const std::string& after) {
    std::string text = fixtures::smp_penetrations;
    const std::size_t at = text.find(before);
    ASSERT_NE(at, std::string::npos) << before;
    text.replace(at, before.size(), after);
    const Read read = read_text(text);
    EXPECT_FALSE(read.errors) << after << ": " << first_error(read);
    ASSERT_EQ(read.report.penetrations.size(), 2u) << after;
    const Penetration &a = read.report.penetrations[0], &b = plain.report.penetrations[0];
    EXPECT_EQ(std::tuple(a.node, a.segment, a.s, a.t, a.depth, a.contact_distance, a.moved_to),
              std::tuple(b.node, b.segment, b.s, b.t, b.depth, b.contact_distance, b.moved_to))
        << after;
  };
  same(" 22124 22164 22165 22125\n", " 22124 22164\n 22165 22125\n");
  same(" 22124 22164 22165 22125\n", "     22124\n     22164\n     22165\n     22125\n");
  same("= -2.3980E-01 -8.0082E-02\n", "=\n      -2.3980E-01 -8.0082E-02\n");
  same("= -2.3980E-01 -8.0082E-02\n", "= -2.3980E-01\n      -8.0082E-02\n");
  same("penetrating node #  ", "Penetrating  node # ");
  same("remaining distance to shell midsurface =  5.0000E-01\n",
       "remaining distance to shell midsurface =\n      5.0000E-01\n");
}

TEST(SolverLog, IdsThatTouch) {
  std::string text = fixtures::smp_penetrations;
  const std::string ids = " 22124 22164 22165 22125\n";
  text.replace(text.find(ids), ids.size(), "   221241000000220000003   22125\n");
  const Read read = read_text(text);
  EXPECT_FALSE(read.errors) << first_error(read);
  EXPECT_EQ(read.report.penetrations.at(0).segment, (std::array<std::int64_t, 4>{22124, 10000002, 20000003, 22125}));
}

TEST(SolverLog, IdsOfElevenDigits) {
  std::string text = fixtures::smp_penetrations;
  const std::string ids = " 22124 22164 22165 22125\n";
  text.replace(text.find(ids), ids.size(), "  12345678901 22345678902 32345678903\n");
  const Read read = read_text(text);
  EXPECT_EQ(read.report.penetrations.at(0).segment,
            (std::array<std::int64_t, 4>{12345678901, 22345678902, 32345678903, 32345678903}));
}

/// What cannot be read is not made up.
TEST(SolverLog, NumbersThatAreNone) {
  std::string text = fixtures::smp_penetrations;
  const std::string depth = "= -5.0000E-01\n", place = "= -2.3980E-01 -8.0082E-02\n";
  text.replace(text.find(depth), depth.size(), "= ************\n");
  text.replace(text.find(place), place.size(), "= ************\n");
  const Read read = read_text(text);
  EXPECT_TRUE(read.errors);
  ASSERT_EQ(read.report.penetrations.size(), 2u);
  const auto& records = read.report.penetrations;
  const Penetration& record = records[0].node == 14 ? records[0] : records[1];
  EXPECT_EQ(record.contact_distance, 0);
  EXPECT_TRUE(std::isnan(record.s) && std::isnan(record.t));
}

TEST(SolverLog, ContactsOfD3hspInDeckOrder) {
  const Read read = read_text(fixtures::d3hsp_contacts + fixtures::smp_penetrations);
  EXPECT_FALSE(read.errors) << first_error(read);
  EXPECT_EQ(contact_ids(read.report), (std::vector<std::int64_t>{7, 3, 12, 1, 2}));
  EXPECT_EQ(read.report.contacts[0].title, "Door on sill");
  EXPECT_EQ(read.report.contacts[0].type, "a3");
  EXPECT_EQ(read.report.contacts[0].segments, 15u);
  EXPECT_EQ(read.report.contacts[1].title, "");
  EXPECT_EQ(read.report.contacts[1].type, "13");
  EXPECT_EQ(read.report.contacts[1].segments, 120u);
  EXPECT_EQ(read.report.contacts[2].type, "o2");
  EXPECT_EQ(read.report.contacts[2].title, "Weld line");
  EXPECT_EQ(read.report.contacts[2].order, 3u);
  EXPECT_EQ(read.report.penetrations.at(0).contact, 3u);
  EXPECT_EQ(read.report.run->element_timestep, 1.6611e-07);
}

TEST(SolverLog, EchoOfSettingsIsNoFinding) {
  const Read read = read_text(fixtures::d3hsp_contacts);
  EXPECT_FALSE(read.errors) << first_error(read);
  EXPECT_TRUE(read.report.penetrations.empty());
  EXPECT_TRUE(read.report.run->messages.empty());
  for (const ContactSummary& summary : read.report.contacts) EXPECT_EQ(summary.reported_penetrations, 0u);
  // The same lines where nothing says that the file is a d3hsp.
  const Read bare = read_text(
      " expanding   memory to 1\n    track initial penetrations in auto contacts....       2\n"
      "          eq.1:  yes, initial penetrations remain      \n Open include file: penetration.k\n");
  EXPECT_TRUE(bare.report.run->messages.empty());
}

TEST(SolverLog, TieReasonsOfAllVersions) {
  using fixtures::tie;
  const std::string text =
      " expanding   memory to 1\n" +
      tie("40538 (SOL+538)", "Slave node is not constrained\n     no segment was found in bucket sort.", "slave", 4,
          1) +
      tie("40538 (SOL+538)", "Tracked node is not constrained\n     no segment was found in bucket sort.", "tracked", 4,
          2) +
      tie("40533 (SOL+533)", "Tracked node is not constrained since it is\n     too far from segment.", "tracked", 4,
          3) +
      tie("50135 (XXX+135)", "Tracked node is not constrained since it is\n     not found on a segment.", "tracked", 92,
          4) +
      tie("50136 (XXX+136)", "Tracked node is not constrained since it is\n     too far from segment.", "tracked", 101,
          43, 31) +
      tie("40552 (SOL+552)", "Slave node is already constrained.", "slave", 5, 6) +
      tie("30455 (INI+455)", "Slave node is already constrained.", "slave", 5, 7) +
      tie("49001 (SOL+9001)", "Slave node is not constrained since it\n     would shorten a beam.", "slave", 5, 8) +
      tie("49002 (SOL+9002)", "Slave node is not constrained since it is\n     a rigid node.", "slave", 5, 9, 3) +
      tie("49003 (SOL+9003)", "Slave node is not constrained since its\n     segment has a rigid node.", "slave", 5,
          10);
  const Read read = read_text(text);
  EXPECT_FALSE(read.errors) << first_error(read);
  std::string found;
  for (const TieFailure& failure : read.report.tie_failures)
    found += fmt::format("{}:{}:{} ", read.report.contacts[failure.contact].id, failure.node, name(failure.reason));
  EXPECT_EQ(found,
            "4:3:far 4:1:notfound 4:2:notfound 5:8:short 5:9:rigslav 5:10:rigmast 5:6:conflict 5:7:conflict "
            "92:4:notfound 101:43:far ");
  EXPECT_EQ(contact_of(read.report, 101)->untied, 1u);
  EXPECT_EQ(read.report.tie_failures.back().segment_number, 31u);
  EXPECT_TRUE(read.report.run->messages.empty());
}

TEST(SolverLog, OtherMessagesAreListedWhetherUnderstoodOrNot) {
  const Read read = read_text(R"( 
 *** Warning 20535 (STR+535)
     contact interface # 2 was switched from SOFT=2 to SOFT=1
     and the value of DEPTH was switched to the default value.
 contracting memory to        3538 d     3600686 contact segment data 1
 
 *** Warning 30364 (INI+364)
     Contact ID 3 is an ERODING contact. A side effect of
     ERODING contact is that a negative volume failure criterion
     is automatically enabled for all solid parts.
 
 *** Error 98765 (ZZZ+765)
     nobody knows = this
)");
  EXPECT_FALSE(read.errors) << first_error(read);
  const auto& messages = read.report.run->messages;
  ASSERT_EQ(messages.size(), 3u);
  EXPECT_EQ(messages[0].kind, "soft2-switched-off");
  EXPECT_EQ(messages[0].line, 2u);
  EXPECT_EQ(messages[0].text,
            "contact interface # 2 was switched from SOFT=2 to SOFT=1 and the value of DEPTH was switched to the "
            "default value.");
  EXPECT_EQ(messages[1].kind, "eroding-contact-side-effect");
  EXPECT_EQ(messages[2].kind, "");
  EXPECT_EQ(messages[2].group, "ZZZ");
  EXPECT_EQ(messages[2].severity, Severity::error);
}

TEST(SolverLog, RigidWalls) {
  const Read read =
      read_text(" \n *** Warning 30226 (INI+226)\n     node 17 (rigidwall 2) init. penetration= 3.9500E+01\n \n");
  ASSERT_EQ(read.report.run->rigidwalls.size(), 1u);
  EXPECT_EQ(read.report.run->rigidwalls[0].node, 17);
  EXPECT_EQ(read.report.run->rigidwalls[0].wall, 2);
  EXPECT_EQ(read.report.run->rigidwalls[0].depth, 39.5);
}

// As an R13 run prints it after the blocks of an interface; two blocks of one interface are its two sides.
TEST(SolverLog, SummariesOfInitialPenetrations) {
  const auto summary = [](int interface, int nodes, int eliminated, const char* least, const char* greatest) {
    return fmt::format(
        " summary of initial penetration for interface #= {}\n"
        "   number of warning messages                  = {}\n"
        "   number of penetrating nodes                 = {}\n"
        "   number of penetrating node eliminated       = {}\n"
        "   min penetration distance                    =  {}\n"
        "   max penetration distance                    =  {}\n",
        interface, nodes, nodes, eliminated, least, greatest);
  };
  const Read read =
      read_text(fixtures::smp_penetrations + summary(1, 2128, 0, "5.0000E-01", "5.0000E-01") +
                summary(1, 49, 0, "1.0000E-01", "6.0000E-01") + summary(1, 0, 10, "1.0000E-03", "9.0000E-01") +
                summary(7, 0, 562, "2.0000E-02", "3.0000E-02"));
  const auto of = [&](std::int64_t id) {
    for (const ContactSummary& contact : read.report.contacts)
      if (contact.id == id) return contact;
    return ContactSummary{};
  };
  ASSERT_TRUE(of(1).initial_summary);
  EXPECT_EQ(of(1).initial_summary->nodes, 2177u);
  EXPECT_EQ(of(1).initial_summary->messages, 2177u);
  EXPECT_EQ(of(1).initial_summary->least, 0.1) << "not of those that a later block eliminates";
  EXPECT_EQ(of(1).initial_summary->greatest, 0.6);
  EXPECT_EQ(of(1).initial_summary->eliminated, 10U);
  EXPECT_EQ(of(1).reported_penetrations, 2177u) << "more than are listed";
  ASSERT_TRUE(of(7).initial_summary);
  EXPECT_EQ(of(7).initial_summary->nodes, 0u);
  EXPECT_EQ(of(7).initial_summary->eliminated, 562u);
  EXPECT_TRUE(read.report.run->messages.empty()) << "the summaries are no messages of their own";
}

// The text of 40571 is not known; with the lines of 40565 it says the same.
TEST(SolverLog, TheOtherNumberOfInitialPenetrations) {
  std::string text = fixtures::smp_penetrations;
  for (std::size_t at = text.find("40565 (SOL+565)"); at != std::string::npos; at = text.find("40565 (SOL+565)"))
    text.replace(at, 15, "40571 (SOL+571)");
  const Read read = read_text(text), usual = read_text(fixtures::smp_penetrations);
  ASSERT_EQ(read.report.penetrations.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.report.penetrations[i].node, usual.report.penetrations[i].node);
    EXPECT_EQ(read.report.penetrations[i].depth, usual.report.penetrations[i].depth);
  }
}

TEST(SolverLog, SurfaceTimestepsOfBothVocabularies) {
  const Read read = read_text(R"(
     slave surface of interface   = 10001
     type                         =        13
     surface timestep             = 3.179E-04
     controlling slave node ID    = 100030
     part ID of slave node        = 10
     current minimum time step    = 3.179E-04

     surfb surface of interface   = 80086
     type                         =       a 3
     surface timestep             = 1.000E+16
     controlling surfb node ID    = 0
     part ID of surfb node        = 0
     current minimum time step    = 1.669E-07

 The LS-DYNA time step size should not exceed     3.179E-04
 to avoid contact instabilities.  If the step size is
 bigger then scale the penalty of the offending surface.
)");
  EXPECT_FALSE(read.errors) << first_error(read);
  const SolverRun& run = *read.report.run;
  ASSERT_EQ(run.surface_timesteps.size(), 2u);
  EXPECT_EQ(run.surface_timesteps[0].side, 'A');
  EXPECT_EQ(run.surface_timesteps[0].timestep, 3.179e-04);
  EXPECT_EQ(run.surface_timesteps[0].node, 100030);
  EXPECT_EQ(run.surface_timesteps[0].part, 10);
  EXPECT_EQ(run.surface_timesteps[1].side, 'B');
  EXPECT_EQ(run.surface_timesteps[1].type, "a3");
  EXPECT_EQ(run.surface_timesteps[1].timestep, 1e16);
  EXPECT_EQ(run.contact_timestep, 3.179e-04);
  EXPECT_EQ(contact_of(read.report, 80086)->type, "a3");
}

TEST(SolverLog, RunFacts) {
  const Read read = read_text(R"(     |  LS-DYNA, A Program for Nonlinear Dynamic         |
     |  Version : mpp s R16                              |
     |  Revision: R16.1.1-20-g0c90cad538                 |
     |  AnLicVer: 2025 R2 (20250506+dl-73-g4dde854)      |
     |  Platform   : OpenMPI 4.0.5 x86-64                |
     |  Precision  : Single precision (I4R4)             |
 MPP execution with       8 procs

 Crash of a box                                                          
                    ls-dyna mpp s R16 R16.1_20_0c90cad date 07/09/2025
       9 t 1.0000E-01 dt 0.00E+00 write d3plot file            05/15/26 13:26:17
    Interf. ID         7 8.0486E-04    0.01     8.0900E-04    0.01
 Problem time       =    1.2000E-01
 Problem cycle      =        11
    termination time...............................    0.2400E+03
    termination cycle..............................       0
 Elapsed time   47971 seconds for54773890 cycles using  2 SMP threads
 N o r m a l    t e r m i n a t i o n                          05/15/26 13:26:17
)");
  const SolverRun& run = *read.report.run;
  EXPECT_EQ(run.version, "mpp s R16");
  EXPECT_EQ(run.revision, "R16.1.1-20-g0c90cad538");
  EXPECT_EQ(run.platform, "OpenMPI 4.0.5 x86-64");
  EXPECT_EQ(run.precision, "Single precision (I4R4)");
  EXPECT_EQ(run.end_time, 240);
  EXPECT_EQ(run.title, "Crash of a box");
  EXPECT_TRUE(run.mpp);
  EXPECT_EQ(run.ranks, 8u);
  EXPECT_EQ(run.termination, SolverRun::Termination::normal);
  EXPECT_EQ(run.problem_time, 0.12);
  EXPECT_EQ(run.cycles, 11);
  EXPECT_EQ(contact_of(read.report, 7)->contact_time_s, 8.0486e-04);
}

TEST(SolverLog, VersionFromTheStampAlone) {
  const SolverRun now =
      *read_text(" A title\n                    ls-dyna smp d R14 R14.0_515_8a12796 date 12/12/2022\n").report.run;
  EXPECT_EQ(now.version, "smp d R14");
  EXPECT_EQ(now.revision, "R14.0_515_8a12796");
  const SolverRun old = *read_text(" T\n              ls-dyna smp.78769 d            date 01/02/2013\n").report.run;
  EXPECT_EQ(old.version, "smp d");
  EXPECT_EQ(old.revision, "78769");
}

TEST(SolverLog, CountsAndNodesOfMpp) {
  const Read read = read_text(R"( Parallel execution with 2 MPP procs
       0 initial penetrations were found for interface          2
       1 initial penetration was found for interface          3
      12 initial penetrations were found for interface          4
 Moved node 1234 of interface 4 penetration = -0.25
 node 77 has penetration 1.5000E-01 interface # 4
 node without number has penetration
Summary of warning messages for interface # =  4
number of warning messages                  =  2
)");
  EXPECT_FALSE(read.errors) << first_error(read);
  EXPECT_EQ(contact_ids(read.report), (std::vector<std::int64_t>{2, 3, 4}));
  EXPECT_EQ(contact_of(read.report, 2)->reported_penetrations, 0u);
  EXPECT_EQ(contact_of(read.report, 3)->reported_penetrations, 1u);
  EXPECT_EQ(contact_of(read.report, 4)->reported_penetrations, 12u);
  ASSERT_EQ(read.report.penetrations.size(), 2u);
  EXPECT_EQ(read.report.penetrations[0].node, 1234);
  EXPECT_EQ(read.report.penetrations[0].depth, 0.25);
  EXPECT_EQ(read.report.penetrations[0].outcome, Outcome::moved);
  EXPECT_EQ(read.report.penetrations[1].depth, 0.15);
  EXPECT_EQ(read.report.penetrations[1].outcome, Outcome::kept);
  const auto& messages = read.report.run->messages;
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[0].kind + messages[1].kind, "interface-warning-count");
}

TEST(SolverLog, MortarLines) {
  const Read read = read_text(
      " Contact sliding interface 1010\n Number of contact pairs 2784\n Maximum penetration is 0.1122220E-02 between\n"
      " elements 14606 and 10263 on this processor\n \n"
      " *** Warning Penetration is close to maximum before release\n \n");
  EXPECT_FALSE(read.errors) << first_error(read);
  EXPECT_NE(contact_of(read.report, 1010), nullptr);
  ASSERT_EQ(read.report.run->messages.size(), 2u);
  std::string kinds;
  for (const auto& message : read.report.run->messages) kinds += message.kind + " ";
  EXPECT_EQ(kinds, "mortar-penetration mortar-near-release ");
}

TEST(SolverLog, PenetrationOutsideOfAnyKnownShapeIsListed) {
  const Read read = read_text(" expanding   memory to 1\n deep penetrations somewhere\n");
  ASSERT_EQ(read.report.run->messages.size(), 1u);
  EXPECT_EQ(read.report.run->messages[0].kind, "");
  EXPECT_EQ(read.report.run->messages[0].line, 2u);
}

TEST(SolverLog, TitleOfTheRunIsNoMessage) {
  const Read read = read_text(" Penetration study\n                    ls-dyna smp d R14 R14.0_515 date 12/12/2022\n");
  EXPECT_TRUE(read.report.run->messages.empty());
  EXPECT_EQ(read.report.run->title, "Penetration study");
}

TEST(SolverLog, OnlyTheContactsAskedFor) {
  LogOptions options;
  options.contacts = {2};
  const Read read = read_text(fixtures::smp_penetrations, options);
  EXPECT_EQ(contact_ids(read.report), (std::vector<std::int64_t>{2}));
  ASSERT_EQ(read.report.penetrations.size(), 1u);
  EXPECT_EQ(read.report.penetrations[0].contact, 0u);
}

TEST(SolverLog, CutMessages) {
  EXPECT_FALSE(read_text(fixtures::smp_penetrations).report.run->counts_may_be_cut);
  EXPECT_TRUE(
      read_text(" \n *** Warning 1 (SOL+1)\n     no more messages of this number\n \n").report.run->counts_may_be_cut);
  std::string limited = "total # of *X.......       0\n    Maximum number of messages.....................      -5\n";
  for (int i = 0; i < 5; ++i) limited += fmt::format(" \n *** Warning 30062 (INI+62)\n     segment {}\n", i);
  EXPECT_TRUE(read_text(limited).report.run->counts_may_be_cut);
  EXPECT_FALSE(
      read_text(limited + " \n *** Warning 30062 (INI+62)\n     segment 6\n \n").report.run->counts_may_be_cut);
}

TEST(SolverLog, MessagesOfAUser) {
  const Folder folder("user-messages");
  LogOptions options;
  options.message_files = {
      folder.write("kinds.txt", "kind weld\ncodes 77777\nrecord tie short\ncontact weld contact\nnode weld node\n")};
  const std::string text = " \n *** Warning 77777 (SOL+7)\n     weld contact = 5\n     weld node = 9\n \n";
  const Read read = read_text(text, options);
  ASSERT_EQ(read.report.tie_failures.size(), 1u);
  EXPECT_EQ(read.report.tie_failures[0].reason, TieReason::too_short);
  EXPECT_EQ(read_text(text).report.tie_failures.size(), 0u);
  options.message_files = {folder.file("missing.txt")};
  EXPECT_TRUE(read_text(text, options).errors);
}

}  // namespace
}  // namespace gapcheck::results::solver_log_test
