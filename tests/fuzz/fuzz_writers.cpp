// A deck, and a baseline behind a line of equals signs, through all writers of reports. What they write is as well
// formed as can be told cheaply.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "audit/registry.hpp"
#include "fuzz.hpp"
#include "report/baseline/baseline.hpp"
#include "report/export/exports.hpp"
#include "report/export/finding_grid.hpp"
#include "report/format/formats.hpp"
#include "report/html/html.hpp"

namespace gapcheck::fuzz::writers_target {
namespace {

/// The text that `write` gives to a sink.
template <class Write>
std::string written(const Write& write) {
  std::string text;
  write([&text](std::string_view piece) {
    text += piece;
    return true;
  });
  return text;
}

/// UTF-8, and no control characters but blanks and line ends: as every parser of XML demands.
bool is_clean(std::string_view text) {
  const bool control = std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r';
  });
  return !control && nlohmann::json::accept('"' + [&] {
    std::string quoted;
    for (const char c : text) quoted += c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    return quoted;
  }() + '"');
}

/// The rules without their pages, which are the same for every deck.
std::vector<report::RuleText> rules() {
  std::vector<report::RuleText> list;
  for (const auto& rule : audit::rules()) list.push_back({rule.id, rule.name, rule.severity, rule.summary, "page"});
  return list;
}

void write_for_programs(const Report& report) {
  static const std::vector<report::RuleText> texts = rules();
  const Severity limit = Severity::warning;
  require(nlohmann::json::accept(written([&](const auto& sink) { report::json(report, sink, true); })));
  require(nlohmann::json::accept(written([&](const auto& sink) { report::sarif(report, "1", texts, sink); })));
  require(nlohmann::json::accept(written([&](const auto& sink) { report::gitlab(report, sink); })));
  require(is_clean(written([&](const auto& sink) { report::junit(report, &limit, 5, sink); })));
  static_cast<void>(written([&](const auto& sink) { report::github(report, 5, sink); }));
  static_cast<void>(written([&](const auto& sink) { report::csv(report, sink); }));
}

void write_for_people(const Report& report) {
  report::TextOptions options;
  options.top = 3;
  options.color = options.stats = true;
  static_cast<void>(report::text(report, options));
  options.list = true;
  static_cast<void>(report::text(report, options));
  report::HtmlOptions page;
  page.version = "1";
  require(report::html(report, {}, page).ends_with("</html>\n"));
}

void write_for_viewers(const Report& report) {
  static_cast<void>(report::keyword_beams(report, {}));
  static_cast<void>(report::keyword_sets(report, 0));
  static_cast<void>(report::animator_session(report, true));
  static_cast<void>(report::medina_protocol(report, {}, 1000));
  static_cast<void>(report::vtu(report::finding_grid(report, {})));
}

}  // namespace

GAPCHECK_FUZZ_TARGET(writers) {
  const auto texts = parts(input);
  Diagnostics diagnostics;
  audit::AuditOptions options;
  options.read.max_include_depth = 0;
  options.scene = options.mesh = options.members = true;
  auto audited = audit::audit_text(std::string(texts.front()), "fuzz.k", options, diagnostics);
  if (!audited) return;
  Report& report = audited.value();
  if (texts.size() > 1) {
    const auto known = report::read_baseline(texts[1], "baseline");
    if (known) report.baseline = report::compare_with_baseline(report, known.value(), [](const auto&) { return true; });
  }
  const auto again = report::read_baseline(report::baseline_text(report::known_findings(report)), "written");
  require(again.ok());
  write_for_programs(report);
  write_for_people(report);
  write_for_viewers(report);
}

}  // namespace gapcheck::fuzz::writers_target
