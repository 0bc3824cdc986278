#include "audit/fix/fix.hpp"

#include <filesystem>
#include <gapcheck/fix.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "api/convert.hpp"
#include "api/option_check.hpp"
#include "api/watched.hpp"
#include "report/format/fix_report.hpp"

namespace gapcheck::api {

struct FixStore {
  FixReport report;
};

namespace {

namespace fs = std::filesystem;

Result<audit::FixOptions> fix_settings(const FixOptions& options) {
  OptionCheck check;
  audit::FixOptions settings;
  for (const Lock& lock : options.locks) {
    if (lock.first < 1 || lock.last < lock.first)
      check.fault("locks: ids are 1 or more, and the last is not below the first");
    settings.locks.push_back({lock.of == Lock::Of::nodes, lock.first, lock.last});
  }
  for (const Priority& priority : options.priorities) {
    if (priority.part < 1 || !(priority.factor >= 1e-6 && priority.factor <= 1e6))
      check.fault("priorities: a part's id is 1 or more, and its factor between 1e-6 and 1e6");
    settings.priorities.emplace_back(priority.part, priority.factor);
  }
  settings.recommended = options.recommended;
  settings.free_welds = options.free_welds;
  if (!check.message().empty()) return plain_error(check.message());
  return settings;
}

/// Where a file is below the folder of the main file; its name alone if it is elsewhere.
std::string place_below(const std::string& main, const std::string& file) {
  std::error_code error;
  const fs::path home = fs::weakly_canonical(fs::path(main), error).parent_path();
  const fs::path below = fs::weakly_canonical(fs::path(file), error).lexically_relative(home);
  return below.empty() || *below.begin() == ".." ? fs::path(file).filename().string() : below.string();
}

std::vector<ChangedFile> changed_files(const std::string& main, const keyword::Deck& deck, const audit::Fix& fix) {
  std::vector<ChangedFile> list;
  for (std::size_t i = 0; i < fix.files.size(); ++i) {
    const FixedFile& changed = fix.report.changed[i];
    const std::string_view bytes = deck.file(fix.files[i].file).bytes;
    const keyword::LineIndex index(bytes);
    list.push_back({changed.path, place_below(main, changed.path), changed.lines,
                    keyword::with_lines(bytes, index, fix.files[i].edits)});
  }
  return list;
}

FixContact contact_with(const gapcheck::FixContact& from) {
  const auto state = [](const gapcheck::FixContact::State& s) {
    return FixContact::State{s.penetrations, s.released, s.deepest};
  };
  return {from.id,           from.keyword,     from.title,        from.not_checked, state(from.before),
          state(from.after), from.by_segments, from.edges_before, from.edges_after};
}

MovedNode moved_node(const gapcheck::MovedNode& from) {
  MovedNode moved;
  moved.node = from.node;
  copy(from.from, moved.from);
  copy(from.to, moved.to);
  moved.onto_tie = from.onto_tie;
  moved.file = from.file;
  moved.line = from.line;
  return moved;
}

UnfixedNode unfixed_node(const gapcheck::UnfixedNode& from, const FixReport& report) {
  UnfixedNode node;
  node.contact = report.contacts[from.contact].id;
  node.node = from.node;
  node.part = from.part;
  node.element = from.element;
  node.element_part = from.element_part;
  node.depth = from.depth;
  node.contact_distance = from.contact_distance;
  node.released = from.released;
  node.reason = gapcheck::name(from.reason);
  return node;
}

FixWall wall_of(const gapcheck::FixWall& from) {
  FixWall wall{
      from.id, from.title, from.before.penetrations, from.after.penetrations, from.before.deepest, from.after.deepest,
      {}};
  for (const gapcheck::UnfixedNode& each : from.unfixed) {
    UnfixedNode& node = wall.unfixed.emplace_back();
    node.node = each.node;
    node.depth = each.depth;
    node.reason = gapcheck::name(each.reason);
  }
  return wall;
}

FixProposal proposal_of(const gapcheck::FixProposal& from) {
  FixProposal proposal;
  proposal.contact = from.contact;
  proposal.part = from.part;
  proposal.other_part = from.other_part;
  proposal.penetrations = from.penetrations;
  proposal.deepest = from.deepest;
  proposal.thickness = from.thickness;
  for (const FixAlternative& each : from.alternatives) proposal.alternatives.push_back({each.text, each.card});
  return proposal;
}

Fix public_fix(FixReport from) {
  Fix fix;
  fix.solved = gapcheck::complete(from);
  fix.files = from.files;
  for (const gapcheck::FixContact& contact : from.contacts) fix.contacts.push_back(contact_with(contact));
  for (const gapcheck::FixWall& each : from.walls) fix.walls.push_back(wall_of(each));
  for (const gapcheck::MovedNode& node : from.moved) fix.moved.push_back(moved_node(node));
  for (const gapcheck::UnfixedNode& node : from.unfixed) fix.unfixed.push_back(unfixed_node(node, from));
  for (const gapcheck::FixProposal& proposal : from.proposals) fix.proposals.push_back(proposal_of(proposal));
  fix.largest_move = from.largest_move;
  fix.total_move = from.total_move;
  fix.elements_touched = from.elements_touched;
  fix.elements_worsened = from.elements_worsened;
  fix.cut_short = from.cut_short;
  fix.notes = from.notes;
  fix.store = std::make_shared<const FixStore>(FixStore{std::move(from)});
  return fix;
}

const FixReport& report_in(const Fix& fix) {
  static const FixReport none;
  return fix.store ? fix.store->report : none;
}

Result<Fix> fixed(const std::string& path, const FixOptions& options, const audit::FixOptions& settings) {
  gapcheck::Diagnostics diagnostics;
  const auto deck = keyword::read_deck(path, read_options(options.includes), diagnostics);
  if (!deck) return error_of(deck.error(), diagnostics);
  auto corrected = audit::fix_penetrations(deck.value(), settings, diagnostics);
  if (!corrected) return error_of(corrected.error(), diagnostics);
  // What was not understood may be what the nodes hang on.
  if (diagnostics.has_errors()) return first_error(diagnostics);
  corrected.value().report.input = path;
  corrected.value().report.dry_run = true;
  std::vector<ChangedFile> changed = changed_files(path, deck.value(), corrected.value());
  if (const Status same = deck.value().unchanged(); !same.ok()) return error_of(same.error(), diagnostics);
  Fix fix = public_fix(std::move(corrected.value().report));
  fix.changed = std::move(changed);
  fix.diagnostics = listed(diagnostics);
  return fix;
}

}  // namespace

Result<Fix> fix_deck(const std::string& path, const FixOptions& options) {
  const auto settings = fix_settings(options);
  if (!settings) return settings.error();
  const Jobs jobs(options.jobs);
  return watched(options.watch, "the correction was stopped", [&] { return fixed(path, options, settings.value()); });
}

std::string text(const Fix& fix, std::size_t top) {
  report::FixTextOptions options;
  options.top = top;
  return report::fix_text(report_in(fix), options);
}

std::string json(const Fix& fix) { return report::fix_json(report_in(fix)); }

}  // namespace gapcheck::api
