// Any bytes as a deck whose penetrations are corrected. The corrected deck has the moved nodes where the report says.
#include <cmath>
#include <string>
#include <unordered_map>

#include "audit/fix/fix.hpp"
#include "audit/repair/repair_plan.hpp"
#include "fuzz.hpp"
#include "model/model.hpp"
#include "report/format/fix_report.hpp"
#include "report/format/repair_report.hpp"

namespace gapcheck::fuzz::fix_target {
namespace {

keyword::ReadOptions alone() {
  keyword::ReadOptions options;
  options.max_include_depth = 0;
  return options;
}

/// The corrected deck, which has one file.
std::string corrected(const keyword::Deck& deck, const audit::Fix& fix) {
  const std::string_view bytes = deck.file(FileIndex(0)).bytes;
  const keyword::LineIndex index(bytes);
  require(fix.files.size() == 1);
  return keyword::with_lines(bytes, index, fix.files.front().edits);
}

void nodes_are_there(std::string text, const FixReport& report) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(std::move(text), "fixed.k", alone(), diagnostics);
  require(deck.ok());
  const auto model = model::read_model(deck.value(), diagnostics);
  require(model.ok());
  const auto& nodes = model.value().mesh.nodes;
  std::unordered_map<std::int64_t, Vector> at;
  for (std::size_t i = 0; i < nodes.id.size(); ++i) at.emplace(nodes.id[i], nodes.x[i]);
  for (const MovedNode& moved : report.moved) {
    const auto found = at.find(moved.node);
    require(found != at.end());
    require((found->second - moved.to).norm() <= 1e-6 * (1 + moved.to.norm() + moved.from.norm()));
  }
}

/// What the plan has tried can be applied, and leaves what the plan says.
void repairs_keep_their_word(const std::string& text, const keyword::Deck& deck, const audit::FixOptions& options) {
  const audit::Reread reread = [&](const auto& texts, Diagnostics& diagnostics) {
    const auto changed = texts.find("fuzz.k");
    return keyword::read_deck_text(changed == texts.end() ? text : changed->second, "fuzz.k", alone(), diagnostics);
  };
  Diagnostics diagnostics;
  const auto plan = audit::plan_repairs(deck, options, reread, diagnostics);
  if (!plan) return;
  static_cast<void>(report::plan_text(plan.value(), {}));
  static_cast<void>(report::plan_json(plan.value()));
  if (plan.value().pairs.empty()) return;
  for (const Repair& repair : plan.value().pairs.front().repairs) {
    if (!repair.outcome.refused.empty()) continue;
    const std::vector<std::string> ids{repair.id};
    const auto applied = audit::apply_repairs(deck, ids, options, reread, diagnostics);
    require(applied.ok());
    static_cast<void>(report::applied_text(applied.value().report, {}));
    static_cast<void>(report::applied_json(applied.value().report));
    require(applied.value().report.after() >= repair.outcome.left);
    require(plan.value().pairs.size() > 1 || !repair.outcome.solves() || applied.value().report.complete());
  }
}

}  // namespace

GAPCHECK_FUZZ_TARGET(fix) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(std::string(input), "fuzz.k", alone(), diagnostics);
  if (!deck) return;
  audit::FixOptions options;
  options.rounds = 8;
  options.work = 2'000'000;
  options.recommended = input.size() % 8 == 0;
  options.free_welds = input.size() % 8 == 1;
  if (input.size() % 4 == 0) repairs_keep_their_word(std::string(input), deck.value(), options);
  const auto fixed = audit::fix_penetrations(deck.value(), options, diagnostics);
  static_cast<void>(diagnostics.sorted());
  if (!fixed) return;
  const FixReport& report = fixed.value().report;
  static_cast<void>(report::fix_text(report, {}));
  static_cast<void>(report::fix_json(report));
  require(report.moved.empty() == fixed.value().files.empty());
  if (!report.moved.empty()) nodes_are_there(corrected(deck.value(), fixed.value()), report);
}

}  // namespace gapcheck::fuzz::fix_target
