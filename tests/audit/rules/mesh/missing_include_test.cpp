#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::missing_include_test {
namespace {

audit::AuditOptions of(const std::string& rules) {
  audit::AuditOptions options;
  options.read.skip_missing_includes = true;
  options.select = {rules};
  return options;
}

TEST(MissingInclude, EachWithItsPlace) {
  const AuditRun run = run_text("*KEYWORD\n*INCLUDE\nnot_here.k\nnor_here.k\n*END\n", of("GC901"));
  ASSERT_EQ(run.report.findings.size(), 2U);
  EXPECT_EQ(run.report.findings[0].severity, Severity::warning);  // --missing-includes skip
  EXPECT_EQ(run.report.findings[0].line, 3U);
  EXPECT_NE(run.report.findings[0].message.find("include \"not_here.k\" was not found"), std::string::npos);
  EXPECT_EQ(run.report.findings[1].line, 4U);
}

TEST(MissingInclude, AnErrorUnlessItIsSkippedOnPurpose) {
  audit::AuditOptions options;
  options.select = {"GC901"};
  const AuditRun run = run_text("*KEYWORD\n*INCLUDE\nnot_here.k\n*END\n", options);
  ASSERT_EQ(run.report.findings.size(), 1U);
  EXPECT_EQ(run.report.findings[0].severity, Severity::error);
}

TEST(MissingInclude, AWarningWhereAnEarlierCaseWritesIt) {
  audit::AuditOptions options;
  options.select = {"GC901"};
  const AuditRun run = run_text(
      "*KEYWORD\n*CASE_BEGIN_1\n*CASE_END_1\n*CASE_BEGIN_2\n*INCLUDE\ncase1.dynain\nnot_here.k\n*CASE_END_2\n*END\n",
      options);
  ASSERT_EQ(run.report.findings.size(), 2U);
  EXPECT_EQ(run.report.findings[0].severity, Severity::warning);
  EXPECT_EQ(run.report.findings[0].message,
            "include \"case1.dynain\" is written by the run of *CASE 1: what starts from there is judged without it");
  EXPECT_EQ(run.report.findings[1].severity, Severity::error);
}

TEST(MissingInclude, TenInFullAndTheRestCounted) {
  std::string names;
  for (int i = 0; i < 13; ++i) names += fmt::format("not_here_{}.k\n", i);
  const AuditRun run = run_text("*KEYWORD\n*INCLUDE\n" + names + "*END\n", of("GC901"));
  ASSERT_EQ(run.report.findings.size(), 11U);
  EXPECT_EQ(run.report.findings[10].count, 3U);
}

/// A single-surface contact of part set 5, of whose members `defined` exists.
std::string deck(const std::string& include) {
  return "*KEYWORD\n" + include +
         "*SET_PART_LIST\n5\n10,11\n*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n3\n5,0,2,0\n0.\n1.,1.\n*END\n";
}

const Finding* find(const Report& report, const std::string& id) {
  for (const Finding& finding : report.findings)
    if (finding.id == id) return &finding;
  return nullptr;
}

TEST(MissingInclude, WhatIsNotDefinedFollowsFromIt) {
  const AuditRun run = run_text(deck("*INCLUDE\nnot_here.k\n"), of("GC"));
  const Finding* include = find(run.report, "GC901");
  ASSERT_NE(include, nullptr);
  EXPECT_NE(include->key, 0U);
  for (const char* id : {"GC502", "GC503"}) {
    const Finding* finding = find(run.report, id);
    ASSERT_NE(finding, nullptr) << id;
    EXPECT_EQ(finding->cause, include->key) << id;
  }
}

TEST(MissingInclude, WithoutItAnEmptySurfaceFollowsFromItsSet) {
  const AuditRun run = run_text(deck(""), of("GC"));
  const Finding *reference = find(run.report, "GC502"), *surface = find(run.report, "GC503");
  ASSERT_TRUE(reference != nullptr && surface != nullptr);
  EXPECT_EQ(reference->cause, 0U);
  EXPECT_NE(reference->key, 0U);
  EXPECT_EQ(surface->cause, reference->key);
}

// The part exists and has no elements: that its set names another one that does not exist is not why it is empty.
TEST(MissingInclude, ASetWithMembersIsNoCause) {
  const AuditRun run =
      run_text("*KEYWORD\n*NODE\n1,0,0,0\n*PART\nempty\n10\n" + deck("").substr(sizeof("*KEYWORD\n") - 1), of("GC"));
  const Finding* surface = find(run.report, "GC503");
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->cause, 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::missing_include_test
