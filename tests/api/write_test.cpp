// Reports are written as the command line writes them.
#include <gtest/gtest.h>

#include <algorithm>
#include <gapcheck/audit.hpp>
#include <gapcheck/version.hpp>
#include <gapcheck/write.hpp>
#include <regex>
#include <string>

#include "api/new_folder.hpp"
#include "audit/audit.hpp"
#include "report/export/finding_grid.hpp"
#include "report/format/formats.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::api_test::write_test {
namespace {

using api::Format;

TEST(ApiWrite, FormatsAreThoseOfTheRooms) {
  const std::string deck = data("two_plates.k");
  Diagnostics diagnostics;
  const auto internal = audit::audit_deck(deck, {}, diagnostics);
  const auto report = api::audit_deck(deck);
  ASSERT_TRUE(internal.ok() && report.ok());
  const auto written = [](const auto& writer) {
    std::string text;
    writer([&text](std::string_view piece) {
      text += piece;
      return true;
    });
    return text;
  };
  const auto& expected = internal.value();
  EXPECT_EQ(api::write(report.value(), Format::text), report::text(expected, {}));
  EXPECT_EQ(api::write(report.value(), Format::csv), written([&](const auto& sink) { report::csv(expected, sink); }));
  EXPECT_EQ(api::write(report.value(), Format::github),
            written([&](const auto& sink) { report::github(expected, 5, sink); }));
  EXPECT_EQ(api::write(report.value(), Format::gitlab),
            written([&](const auto& sink) { report::gitlab(expected, sink); }));
  const gapcheck::Severity limit = gapcheck::Severity::error;
  // The two audits do not take the same time.
  const auto timeless = [](const std::string& text) {
    return std::regex_replace(text, std::regex(" time=\"[0-9.]+\""), "");
  };
  EXPECT_EQ(timeless(api::write(report.value(), Format::junit)),
            timeless(written([&](const auto& sink) { report::junit(expected, &limit, 5, sink); })));
}

TEST(ApiWrite, AGridIsThatOfTheRooms) {
  for (const bool mesh : {false, true}) {
    audit::AuditOptions internal_options;
    internal_options.mesh = mesh;
    api::AuditOptions options;
    options.mesh = mesh;
    for (const char* name : {"two_plates.k", "tied_then_contact.k", "shell_on_solid.k"}) {
      Diagnostics diagnostics;
      const auto internal = audit::audit_deck(data(name), internal_options, diagnostics);
      const auto report = api::audit_deck(data(name), options);
      ASSERT_TRUE(internal.ok() && report.ok());
      const std::string grid = api::write(report.value(), Format::vtu);
      EXPECT_EQ(grid, report::vtu(report::finding_grid(internal.value(), {})));
      EXPECT_NE(grid.find("<VTKFile"), std::string::npos);
    }
  }
}

TEST(ApiWrite, EveryFormatHasTheFindings) {
  api::AuditOptions options;
  options.picture = true;
  const auto report = api::audit_deck(data("two_plates.k"), options);
  ASSERT_TRUE(report.ok());
  const auto text = [&](Format format) { return api::write(report.value(), format); };
  EXPECT_EQ(text(Format::json).find("{\"schema\":\"gapcheck/1\""), 0u);
  EXPECT_NE(text(Format::json).find("\"node\":1006"), std::string::npos);
  EXPECT_NE(text(Format::sarif).find("\"2.1.0\""), std::string::npos);
  EXPECT_NE(text(Format::sarif).find("\"GC101\""), std::string::npos);
  EXPECT_NE(text(Format::html).find("<html"), std::string::npos);
  EXPECT_NE(text(Format::html).find(std::string(api::version())), std::string::npos);
}

TEST(ApiWrite, Options) {
  const auto report = api::audit_deck(data("two_plates.k"));
  ASSERT_TRUE(report.ok());
  api::WriteOptions options;
  options.list = true;
  const std::string all = api::write(report.value(), Format::text, options);
  EXPECT_NE(all.find("2011"), std::string::npos);
  options.list = false;
  options.top = 1;
  const std::string one = api::write(report.value(), Format::text, options);
  EXPECT_LT(one.size(), all.size());
  options.statistics = true;
  EXPECT_NE(api::write(report.value(), Format::text, options).find("files read"), std::string::npos);
  options.fail_on = api::Severity::warning;
  EXPECT_NE(api::write(report.value(), Format::junit, options).find("<failure"), std::string::npos);
  options.fail_on = std::nullopt;
  EXPECT_EQ(api::write(report.value(), Format::junit, options).find("<failure"), std::string::npos);
}

TEST(ApiWrite, AnEmptyReport) {
  for (const Format format : {Format::text, Format::json, Format::sarif, Format::junit, Format::html})
    EXPECT_FALSE(api::write(api::Report{}, format).empty());
}

TEST(ApiVersion, HasThreeNumbers) {
  const std::string version(api::version());
  EXPECT_EQ(std::count(version.begin(), version.end(), '.'), 2) << version;
}

}  // namespace
}  // namespace gapcheck::api_test::write_test
