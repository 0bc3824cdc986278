#include <gapcheck/version.hpp>
#include <gapcheck/write.hpp>
#include <limits>
#include <vector>

#include "api/convert.hpp"
#include "api/report_store.hpp"
#include "audit/registry.hpp"
#include "report/export/finding_grid.hpp"
#include "report/format/formats.hpp"
#include "report/html/html.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::api {
namespace {

/// The rules as SARIF has them.
std::vector<report::RuleText> texts_of_rules() {
  std::vector<report::RuleText> texts;
  for (const auto& rule : audit::rules())
    texts.push_back({rule.id, rule.name, rule.severity, rule.summary, audit::page(rule)});
  return texts;
}

std::string text_of(const gapcheck::Report& report, const WriteOptions& options) {
  report::TextOptions text;
  text.top = options.top;
  text.list = options.list;
  text.stats = options.statistics;
  return report::text(report, text);
}

/// Every record of a deck knows where its node is; nothing else is read for the page.
std::string page_of(const gapcheck::Report& report) {
  report::HtmlOptions page;
  page.version = version();
  return report::html(report, {}, page);
}

}  // namespace

std::string write(const Report& report, Format format, const WriteOptions& options) {
  const gapcheck::Report none;
  const gapcheck::Report& internal = report.store ? report.store->report : none;
  const std::size_t top = options.list ? std::numeric_limits<std::size_t>::max() : options.top;
  std::string result;
  const report::Sink sink = [&result](std::string_view piece) {
    result += piece;
    return true;
  };
  switch (format) {
    case Format::text:
      return text_of(internal, options);
    case Format::html:
      return page_of(internal);
    case Format::vtu:
      return report::vtu(report::finding_grid(internal, {}));
    case Format::json:
      report::json(internal, sink, options.statistics);
      break;
    case Format::sarif:
      report::sarif(internal, version(), texts_of_rules(), sink);
      break;
    case Format::junit: {
      const gapcheck::Severity limit = converted(options.fail_on.value_or(Severity::error));
      report::junit(internal, options.fail_on ? &limit : nullptr, top, sink);
      break;
    }
    case Format::github:
      report::github(internal, top, sink);
      break;
    case Format::gitlab:
      report::gitlab(internal, sink);
      break;
    case Format::csv:
      report::csv(internal, sink);
      break;
  }
  return result;
}

}  // namespace gapcheck::api
