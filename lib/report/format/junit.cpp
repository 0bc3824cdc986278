#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "report/format/formats.hpp"
#include "report/item/describe.hpp"
#include "report/item/item.hpp"
#include "report/write/harmless.hpp"
#include "report/write/stream.hpp"
#include "report/write/xml_text.hpp"

namespace gapcheck::report {
namespace {

struct Suite {
  std::string name;
  std::uint32_t contact_position = no_position;
  std::vector<const ItemGroup*> groups;
};

std::string suite_name(const ContactSummary& contact) {
  const std::string title = contact.title.empty() ? "" : ": " + contact.title;
  return xml_attribute(fmt::format("contact {}{}", contact.id, title));
}

/// One per contact in deck order, then one for findings without a contact.
std::vector<Suite> suites_of(const Report& report, bool with_deck, const std::vector<ItemGroup>& groups) {
  std::vector<Suite> suites(report.contacts.size() + 1);
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) suites[i] = {suite_name(report.contacts[i]), i, {}};
  suites.back().name = report.source == "deck" ? "model" : "run";
  for (const ItemGroup& group : groups)
    suites[group.contact_position == no_position ? report.contacts.size() : group.contact_position].groups.push_back(
        &group);
  if (with_deck)
    for (Suite& suite : suites) suite.name = xml_attribute(harmless_path(report.input) + ": ") + suite.name;
  return suites;
}

bool fails(const ItemGroup& group, const Severity* limit) {
  return limit != nullptr && group.items > 0 && group.severity >= *limit;
}

std::size_t failures(const Suite& suite, const Severity* limit) {
  std::size_t count = 0;
  for (const ItemGroup* group : suite.groups) count += fails(*group, limit) ? 1 : 0;
  return count;
}

std::string body(const ItemGroup& group) {
  std::string text;
  for (const Item& item : group.shown) {
    const std::string place = item.line == 0 ? "" : fmt::format("{}:{}: ", harmless_path(item.file), item.line);
    text += xml_text(fmt::format("{}{}\n", place, item.message));
  }
  if (group.items > group.shown.size()) text += fmt::format("and {} more\n", group.items - group.shown.size());
  if (group.known > 0) text += fmt::format("{} known from the baseline\n", group.known);
  return text;
}

bool has_case(const ItemGroup& group) { return group.items + group.known > 0; }

/// A case for findings, and one for those left out on purpose.
std::size_t cases(const Suite& suite) {
  std::size_t count = 0;
  for (const ItemGroup* group : suite.groups) count += (has_case(*group) ? 1 : 0) + (group->ignored > 0 ? 1 : 0);
  return suite.groups.empty() ? 1 : count;
}

std::size_t skipped(const Suite& suite) {
  return static_cast<std::size_t>(std::count_if(suite.groups.begin(), suite.groups.end(),
                                                [](const ItemGroup* group) { return group->ignored > 0; }));
}

void append_skipped_case(const Suite& suite, const ItemGroup& group, Stream& stream) {
  std::string why;
  for (const IgnoreSource* source : group.sources) why += (why.empty() ? "" : "; ") + describe(*source);
  if (group.sources.size() == ignore_sources_shown) why += "; …";
  stream.text(
      fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\">\n"
                  "      <skipped message=\"{}\"/>\n    </testcase>\n",
                  suite.name, xml_attribute(fmt::format("{} {} (ignored)", group.id, group.rule)),
                  xml_attribute(fmt::format("{} left out on purpose by {}", group.ignored, why))));
}

void append_case(const Suite& suite, const ItemGroup& group, const Severity* limit, Stream& stream) {
  const std::string name = xml_attribute(fmt::format("{} {}", group.id, group.rule));
  stream.text(fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\">\n", suite.name, name));
  if (fails(group, limit)) {
    stream.text(fmt::format("      <failure message=\"{} found\" type=\"{}\">{}</failure>\n", group.items,
                            report::name(group.severity), body(group)));
  } else {
    stream.text(fmt::format("      <system-out>{}</system-out>\n", body(group)));
  }
  stream.text("    </testcase>\n");
}

void append_suite(const Report& report, const Suite& suite, const Severity* limit, Stream& stream) {
  stream.text(
      fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"0\">\n",
                  suite.name, cases(suite), failures(suite, limit), skipped(suite)));
  if (suite.groups.empty()) {
    const bool contact = suite.contact_position != no_position;
    const std::string& why = contact ? report.contacts[suite.contact_position].not_checked : std::string();
    stream.text(fmt::format("    <testcase classname=\"{}\" name=\"no findings\" time=\"0\"", suite.name));
    stream.text(why.empty()
                    ? "/>\n"
                    : fmt::format(">\n      <system-out>penetrations not checked: {}</system-out>\n    </testcase>\n",
                                  xml_text(why)));
  }
  for (const ItemGroup* group : suite.groups) {
    if (has_case(*group)) append_case(suite, *group, limit, stream);
    if (group->ignored > 0) append_skipped_case(suite, *group, stream);
  }
  stream.text("  </testsuite>\n");
  stream.pause();
}

/// A deck's part of the file.
struct Document {
  const Report* report;
  std::vector<ItemGroup> groups;
  std::vector<Suite> suites;  ///< point into `groups`
};

std::vector<Document> documents_of(const Reports& reports, std::size_t top) {
  std::vector<Document> documents;
  documents.reserve(reports.all.size());
  for (const Report& report : reports.all) {
    Document& document = documents.emplace_back(Document{&report, item_groups(report, top), {}});
    document.suites = suites_of(report, reports.several(), document.groups);
  }
  return documents;
}

void append_unread(const Unread& unread, Stream& stream) {
  const std::string name = xml_attribute(harmless_path(unread.deck));
  stream.text(
      fmt::format("  <testsuite name=\"{0}\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"0\">\n"
                  "    <testcase classname=\"{0}\" name=\"read\" time=\"0\">\n"
                  "      <error message=\"{1}\" type=\"error\"/>\n"
                  "    </testcase>\n  </testsuite>\n",
                  name, xml_attribute(unread.reason)));
}

}  // namespace

void junit(const Reports& reports, const Severity* limit, std::size_t top, const Sink& sink) {
  const std::vector<Document> documents = documents_of(reports, top);
  std::size_t tests = reports.unread.size(), failed = 0;
  double time = 0;
  for (const Document& document : documents) {
    time += document.report->timing.total_s;
    for (const Suite& suite : document.suites) {
      tests += cases(suite);
      failed += failures(suite, limit);
    }
  }
  Stream stream(sink);
  stream.text(
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                  "<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
                  reports.several() ? "gapcheck" : xml_attribute(harmless_path(reports.all.front().input)), tests,
                  failed, reports.unread.size(), time));
  for (const Document& document : documents)
    for (const Suite& suite : document.suites) append_suite(*document.report, suite, limit, stream);
  for (const Unread& unread : reports.unread) append_unread(unread, stream);
  stream.text("</testsuites>\n");
  stream.flush();
}

}  // namespace gapcheck::report
