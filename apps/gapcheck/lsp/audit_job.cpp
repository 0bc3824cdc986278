#include "lsp/audit_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>

#include "audit/fix/fix.hpp"
#include "keyword/write_back.hpp"
#include "lsp/uri.hpp"
#include "report/baseline/baseline.hpp"
#include "report/item/item.hpp"

namespace gapcheck::app::lsp {
namespace {

class Collector {
 public:
  explicit Collector(std::string deck) : deck_(std::move(deck)) {}
  void add(const std::string& file, std::uint32_t line, LineFinding finding) {
    const std::string& path = file.empty() ? deck_ : canonical_[file];
    std::vector<LineFinding>& list = result_.findings[path.empty() ? canonical_[file] = canonical(file) : path];
    finding.line = line > 0 ? line - 1 : 0;
    if (list.size() < most_of_a_file) list.push_back(std::move(finding));
  }
  void add(const Diagnostic& said) { add(said.file, said.line, {0, said.severity, {}, said.message}); }
  void add(const Report& report) {
    for (const report::ItemGroup& group : report::item_groups(report, most_of_a_rule)) add(report, group);
    if (report.baseline) add_known(report);
  }
  [[nodiscard]] Audited finish(std::string summary) && {
    result_.summary = std::move(summary);
    for (auto& [path, list] : result_.findings)
      std::stable_sort(list.begin(), list.end(),
                       [](const LineFinding& a, const LineFinding& b) { return a.line < b.line; });
    return std::move(result_);
  }

 private:
  void add(const Report& report, const report::ItemGroup& group) {
    for (const report::Item& item : group.shown) add(report, item);
    if (group.items > group.shown.size())
      add_more(report, group.contact_position, std::string(group.id), group, group.items, false);
  }
  /// How many more there are than those that are listed.
  void add_more(const Report& report, std::uint32_t position, const std::string& id, const report::ItemGroup& group,
                std::size_t all, bool known) {
    const bool of_contact = position != no_position;
    const ContactSummary none, &contact = of_contact ? report.contacts[position] : none;
    LineFinding more{0, group.severity, id,
                     fmt::format("{}: {} more in contact {}", group.rule, all - most_of_a_rule, contact.id),
                     contact.id};
    more.known = known;
    add(contact.file, contact.line, std::move(more));
  }
  void add(const Report& report, const report::Item& item) {
    LineFinding finding{0,         item.severity, std::string(item.id), item.message, item.contact,
                        item.node, item.part,     item.element};
    finding.penetrates = item.penetration >= 0;
    finding.known = !item.counts();
    finding.repair = audit::repair_target(report, item.number);
    result_.repairable = result_.repairable || finding.repair;
    add(std::string(item.file), item.line, std::move(finding));
  }
  /// Those that the baseline has equally bad.
  void add_known(const Report& report) {
    std::map<std::pair<std::uint32_t, std::string>, report::ItemGroup> groups;  // by contact and rule
    report::for_each_item(report, [&](const report::Item& item) {
      if (item.counts()) return true;
      report::ItemGroup& group = groups[{item.contact_position, std::string(item.id)}];
      group.rule = item.rule;
      if (group.known++ < most_of_a_rule) add(report, item);
      return true;
    });
    for (const auto& [key, group] : groups)
      if (group.known > most_of_a_rule) add_more(report, key.first, key.second, group, group.known, true);
  }
  std::string deck_;
  std::map<std::string, std::string> canonical_;
  Audited result_;
};

std::string summary_of(const Report& report, const Diagnostics& diagnostics, double seconds) {
  std::size_t errors = 0, warnings = 0, notes = 0;
  const auto count = [&](Severity severity) {
    ++(severity == Severity::error ? errors : severity == Severity::warning ? warnings : notes);
  };
  report::for_each_item(report, [&](const report::Item& item) {
    count(item.severity);
    return true;
  });
  for (const Diagnostic& said : diagnostics.sorted()) count(said.severity);
  const std::string known =
      report.baseline ? "; against the baseline: " + report::summary(*report.baseline) : std::string();
  return fmt::format("{}: {} errors, {} warnings, {} notes, {:.2f} s{}", report.input, errors, warnings, notes, seconds,
                     known);
}

}  // namespace

bool is_structure(const Keyword& keyword) {
  const std::string_view name = keyword.name;
  return name.starts_with("PARAMETER") || name.starts_with("INCLUDE") || name == "KEYWORD" || name == "END" ||
         name.starts_with("DEFINE_TRANSFORM");
}

std::string skeleton(const Text& text, std::span<const Keyword> outline) {
  std::string bones;
  std::uint32_t line = 0;
  for (const Keyword& keyword : outline) {
    bones.append(keyword.line - line, '\n');
    line = keyword.line;
    const std::uint32_t end = is_structure(keyword) ? keyword.end : keyword.line + 1;
    text.for_each_line(keyword.line, end, [&](std::uint32_t, std::string_view each) {
      bones += each;
      bones += '\n';
      ++line;
      return true;
    });
  }
  return bones;
}

std::shared_ptr<const keyword::Deck> deck_for_editor(const std::string& deck, keyword::ReadOptions read,
                                                     const std::map<std::string, std::string>& changed) {
  std::map<std::string, std::string> texts = changed;
  read.replaced = &texts;
  read.skip_missing_includes = true;
  for (bool again = true;;) {
    Diagnostics ignored;  // the audit says the same
    auto result = keyword::read_deck(deck, read, ignored);
    if (!result) return nullptr;
    // Files may have been opened by another path than that of the editor.
    const std::size_t known = texts.size();
    for (const keyword::SourceFile& file : result.value().files())
      if (const auto same = changed.find(canonical(file.path)); same != changed.end())
        texts.emplace(file.path, same->second);
    again = again && texts.size() > known;
    if (again) continue;
    auto kept = std::make_shared<keyword::Deck>(std::move(result).value());
    kept->drop_text([](std::string_view name) { return !name.starts_with("INCLUDE"); });
    return kept;
  }
}

std::optional<Audited> audit_for_editor(const std::string& deck, const OptionsOf& options_of,
                                        const std::function<bool()>& go_on) {
  const auto start = std::chrono::steady_clock::now();
  Collector collector(canonical(deck));
  Diagnostics diagnostics;
  std::string summary;
  try {
    DeckOptions options = options_of(deck);
    for (const Diagnostic& fault : options.faults) collector.add(fault);
    options.audit.watch = [&go_on](const audit::AuditStep&) { return go_on(); };
    auto report = audit::audit_deck(deck, options.audit, diagnostics);
    if (!go_on()) return std::nullopt;
    if (report) {
      if (options.compare)
        if (const Status compared = options.compare(report.value()); !compared.ok()) collector.add(compared.error());
      collector.add(report.value());
      summary = summary_of(report.value(), diagnostics,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    } else {
      collector.add(report.error());
      summary = fmt::format("{}: {}", deck, report.error().message);
    }
  } catch (const std::exception& error) {  // too little memory
    collector.add(Diagnostic{Severity::error, deck, 0, fmt::format("the deck was not audited: {}", error.what())});
    summary = fmt::format("{}: {}", deck, error.what());
  }
  for (const Diagnostic& said : diagnostics.sorted()) collector.add(said);
  return std::move(collector).finish(std::move(summary));
}

Result<FixedLines> fix_for_editor(const std::string& deck, const OptionsOf& options_of) try {
  const DeckOptions given = options_of(deck);
  if (!given.faults.empty()) return given.faults.front();
  Diagnostics diagnostics;
  const auto input = keyword::read_deck(deck, given.audit.read, diagnostics);
  if (!input) return input.error();
  for (const Diagnostic& said : diagnostics.sorted())
    if (said.severity == Severity::error) return said;
  audit::FixOptions options;
  options.proposals = false;
  const auto fix = audit::fix_penetrations(input.value(), options, diagnostics);
  if (!fix) return fix.error();
  FixedLines lines;
  std::size_t count = 0;
  for (const audit::ChangedLines& changed : fix.value().files) {
    const keyword::SourceFile& file = input.value().file(changed.file);
    const keyword::LineIndex index(file.bytes);
    for (const keyword::LineEdit& edit : changed.edits)
      lines.edits[canonical(file.path)].push_back({edit.line - 1, std::string(index.line(edit.line)), edit.text});
    count += changed.edits.size();
  }
  lines.summary = fmt::format("{}: {} lines of nodes change", deck, count);
  return lines;
} catch (const std::exception& error) {  // too little memory
  return Diagnostic{Severity::error, deck, 0, error.what()};
}

}  // namespace gapcheck::app::lsp
