#include "fix/fix_repairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "audit/repair/deck_edits.hpp"
#include "audit/repair/repair_plan.hpp"
#include "base/parallel.hpp"
#include "changed_files.hpp"
#include "commands.hpp"
#include "common/file_guard.hpp"
#include "common/version.hpp"
#include "fix/repaired_input.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/format/repair_report.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::app {
namespace {

Status write_report(const FixArguments& arguments, const std::string& text) {
  Output output(arguments.output);
  output.write(text);
  return output.close();
}

std::string text_of(const keyword::Deck& deck, RepairPlan& plan, const FixArguments& arguments) {
  if (arguments.format == "sarif") {
    audit::take_line_ends(deck, plan);
    return report::plan_sarif(plan, version());
  }
  return arguments.format == "json" ? report::plan_json(plan) : report::plan_text(plan, arguments.text);
}

int plan(const keyword::Deck& deck, const FixArguments& arguments, RepairPlan& plan) {
  plan.input = arguments.deck;
  Status status = check_fix_report(deck, arguments, {});
  if (status.ok()) status = write_report(arguments, text_of(deck, plan, arguments));
  if (!status.ok()) {
    print(status.error());
    return failed;
  }
  return plan.penetrating + plan.too_far == 0 ? clean : findings;
}

/// Runs the deck as it is and as it is written.
Status verify(const keyword::Deck& deck, const FixArguments& arguments, RepairedInput& input,
              audit::Repaired& repaired) {
  Diagnostics repeated, warnings;  // both were read before
  auto model = model::read_model(deck, repeated);
  if (!model) return model.error();
  auto after = input.read(repaired.texts, repeated);
  if (!after) return after.error();
  auto model_after = model::read_model(after.value(), repeated);
  if (!model_after) return model_after.error();
  repaired.report.proof =
      solver::prove_repair(deck, model.value(), after.value(), model_after.value(), arguments.trial, warnings);
  return {};
}

/// The nodes that have other coordinates in the deck as it is written.
Result<std::vector<NodeMove>> moves_of(const keyword::Deck& deck, RepairedInput& input,
                                       const audit::Repaired& repaired) {
  Diagnostics repeated;  // both were read before
  const auto model = model::read_model(deck, repeated);
  if (!model) return model.error();
  const auto after = input.read(repaired.texts, repeated);
  if (!after) return after.error();
  const auto model_after = model::read_model(after.value(), repeated);
  if (!model_after) return model_after.error();
  const model::Nodes &nodes = model.value().mesh.nodes, &written = model_after.value().mesh.nodes;
  std::vector<NodeMove> moves;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (const auto same = written.lookup.find(nodes.id[n]); same && written.x[*same] != nodes.x[n])
      moves.push_back({nodes.id[n], written.x[*same]});
  return moves;
}

/// The deck before and after, if that is asked for.
Status write_pictures(const keyword::Deck& deck, const FixArguments& arguments, RepairedInput& input,
                      const audit::Repaired& repaired) {
  if (arguments.pictures.html.empty() && arguments.pictures.vtu.empty()) return {};
  auto moves = moves_of(deck, input, repaired);
  if (!moves) return moves.error();
  std::string said = report::applied_text(repaired.report, {.quiet = true});
  if (!said.empty() && said.back() == '\n') said.pop_back();
  return write(arguments.pictures, arguments.deck, arguments.read, std::move(moves.value()), std::move(said));
}

Status write(const keyword::Deck& deck, const FixArguments& arguments, RepairedInput& input,
             audit::Repaired& repaired) {
  AppliedRepairs& report = repaired.report;
  report.input = arguments.deck;
  report.dry_run = arguments.dry_run;
  Status status = arguments.dry_run ? deck.unchanged()
                                    : choose_places(deck, arguments.deck, {"-o", arguments.directory}, report.files);
  if (status.ok()) status = check_fix_report(deck, arguments, report.files);
  if (status.ok() && !arguments.dry_run) status = write_texts(deck, repaired.texts, report.files);
  if (status.ok()) status = write_pictures(deck, arguments, input, repaired);
  if (!status.ok()) return status;
  return write_report(arguments, arguments.format == "json" ? report::applied_json(report)
                                                            : report::applied_text(report, arguments.text));
}

int apply(const keyword::Deck& deck, const FixArguments& arguments, RepairedInput& input, audit::Repaired& repaired) {
  Status status = arguments.verify ? verify(deck, arguments, input, repaired) : Status();
  if (status.ok()) status = write(deck, arguments, input, repaired);
  if (!status.ok()) {
    print(status.error());
    return failed;
  }
  const AppliedRepairs& report = repaired.report;
  return report.complete() && (!report.proof || report.proof->holds()) ? clean : findings;
}

}  // namespace

bool asks_for_repairs(const FixArguments& arguments) {
  return arguments.plan || arguments.best || !arguments.apply.empty();
}

Status check_fix_report(const keyword::Deck& deck, const FixArguments& arguments, std::span<const FixedFile> written) {
  std::vector<ReadInput> read{{arguments.settings_path, "the settings file"}};
  add_deck_files(deck, read);
  std::vector<PlannedOutput> outputs{{"--output", arguments.output}};
  for (const FixedFile& file : written) outputs.push_back({"-o", file.written});
  for (const PlannedOutput& output : planned_outputs(arguments.pictures)) outputs.push_back(output);
  return check_outputs(read, outputs);
}

int repair_deck(const FixArguments& arguments) {
  const JobLimit limit(arguments.jobs);
  if (arguments.directory.empty() && !arguments.dry_run && !arguments.plan) {
    print(plain_error("give a directory for the changed files with -o, or --dry-run"));
    return failed;
  }
  RepairedInput input(arguments.deck, arguments.read);
  const audit::Reread reread = input.reread();
  Diagnostics diagnostics;
  std::optional<Progress> progress;
  progress.emplace("trying repairs of " + report::printable(arguments.deck), !arguments.text.quiet);
  const auto fail = [&](const Diagnostic& error) {
    progress.reset();
    print(diagnostics, arguments.text.quiet);
    print(error);
    return static_cast<int>(failed);
  };
  const std::map<std::string, std::string> no_texts;
  const auto deck = input.read(no_texts, diagnostics);
  if (!deck) return fail(deck.error());
  std::vector<std::string> ids = arguments.apply, notes;
  if (ids.empty()) {
    auto listed = audit::plan_repairs(deck.value(), arguments.fix, reread, diagnostics);
    if (!listed) return fail(listed.error());
    progress.reset();
    if (arguments.plan) {
      print(diagnostics, arguments.text.quiet);
      return plan(deck.value(), arguments, listed.value());
    }
    ids = listed.value().best();
    notes = listed.value().notes;
    progress.emplace("repairing " + report::printable(arguments.deck), !arguments.text.quiet);
  }
  Diagnostics repeated;
  auto repaired =
      audit::apply_repairs(deck.value(), ids, arguments.fix, reread, arguments.apply.empty() ? repeated : diagnostics);
  if (!repaired) return fail(repaired.error());
  std::vector<std::string>& all = repaired.value().report.notes;
  all.insert(all.begin(), notes.begin(), notes.end());
  progress.reset();
  print(diagnostics, arguments.text.quiet);
  if (diagnostics.has_errors()) return failed;
  return apply(deck.value(), arguments, input, repaired.value());
}

}  // namespace gapcheck::app
