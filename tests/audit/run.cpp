#include "audit/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace gapcheck::audit_test {
namespace {

AuditRun finish(Result<Report> result, const Diagnostics& diagnostics) {
  AuditRun run;
  run.ok = result.ok();
  run.diagnostics = diagnostics.sorted();
  if (result.ok())
    run.report = std::move(result).value();
  else
    run.diagnostics.push_back(result.error());
  return run;
}

std::string bits(const Vector& v) { return fmt::format("{:a} {:a} {:a}", v.x(), v.y(), v.z()); }

}  // namespace

std::size_t AuditRun::errors() const {
  return static_cast<std::size_t>(std::count_if(diagnostics.begin(), diagnostics.end(),
                                                [](const auto& d) { return d.severity == Severity::error; }));
}

AuditRun run_text(const std::string& text, const audit::AuditOptions& options) {
  Diagnostics diagnostics;
  auto result = audit::audit_text(text, "scene.k", options, diagnostics);
  return finish(std::move(result), diagnostics);
}

AuditRun run_file(const std::string& path, const audit::AuditOptions& options) {
  Diagnostics diagnostics;
  auto result = audit::audit_deck(path, options, diagnostics);
  return finish(std::move(result), diagnostics);
}

std::string dump(const Report& report) {
  std::string text;
  auto out = std::back_inserter(text);
  for (const auto& c : report.contacts) {
    fmt::format_to(out, "contact {} {} {} {} nodes {} segments {} found {} {} {} deepest {:a} {}\n", c.id, c.order,
                   c.keyword, c.type, c.tracked_nodes, c.segments, c.penetrations, c.released, c.edge_zone,
                   c.max_penetration, c.not_checked);
    fmt::format_to(out, "  ties {} untied {} out of reach {}\n", c.ties, c.untied, c.out_of_reach);
  }
  for (const auto& p : report.penetrations) {
    fmt::format_to(out, "{} node {} part {} segment {} {} {} {} {} element {} {} depth {:a} of {:a} st {:a} {:a} ",
                   p.contact, p.node, p.part, p.segment_number, p.segment[0], p.segment[1], p.segment[2], p.segment[3],
                   p.element, p.element_part, p.depth, p.contact_distance, p.s, p.t);
    fmt::format_to(out, "{} > {} > {} line {} {} kind {} {} {} {} {}\n", bits(p.original), bits(p.point),
                   bits(p.moved_to), p.file, p.line, static_cast<int>(p.kind), name(p.outcome), name(p.feature),
                   name(p.node_rule), name(p.segment_rule));
  }
  for (const auto& t : report.tie_failures)
    fmt::format_to(out, "{} node {} part {} segment {} {} separation {:a} of {:a} line {} {}\n", t.contact, t.node,
                   t.part, t.segment_number, name(t.reason), t.distance, t.allowed, t.file, t.line);
  for (const auto& f : report.findings)
    fmt::format_to(out, "{} {} {}:{} {}\n", f.id, f.contact, f.file, f.line, f.message);
  return text;
}

std::string describe(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const auto& d : diagnostics) {
    const char* severity = d.severity == Severity::error     ? "error"
                           : d.severity == Severity::warning ? "warning"
                                                             : "note";
    text += fmt::format("{}:{}: {}: {}\n", d.file, d.line, severity, d.message);
  }
  return text;
}

testing::AssertionResult clean(const AuditRun& run) {
  if (run.ok && run.errors() == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << (run.ok ? "errors:\n" : "no report:\n") << describe(run.diagnostics);
}

}  // namespace gapcheck::audit_test
