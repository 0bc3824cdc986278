#include "report/format/json_run.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "report/item/describe_tie.hpp"
#include "report/item/fingerprint.hpp"

namespace gapcheck::report {
namespace {

std::string_view termination_name(SolverRun::Termination termination) {
  switch (termination) {
    case SolverRun::Termination::unknown:
      return "unknown";
    case SolverRun::Termination::normal:
      return "normal";
    case SolverRun::Termination::error:
      return "error";
  }
  return "?";
}

/// Appends an array of objects, one per line; fill(item, object) writes the members.
template <class Items, class Fill>
void append_list(Members& parent, std::string_view key, const Items& items, const Fill& fill, Buffer& out) {
  if (items.empty()) return;
  parent.key(key);
  out.push_back('[');
  bool first = true;
  for (const auto& item : items) {
    out.append(std::string_view(std::exchange(first, false) ? "\n  " : ",\n  "));
    Members object(out);
    fill(item, object);
    object.close();
  }
  out.push_back(']');
}

void append_place(const Report& report, std::uint32_t file, std::uint32_t line, Members& object) {
  if (line == 0 || file >= report.files.size()) return;
  object.string("file", report.files[file]);
  object.integer("line", line);
}

void append_facts(const SolverRun& run, Members& object) {
  const auto text = [&](std::string_view key, const std::string& value) {
    if (!value.empty()) object.string(key, value);
  };
  text("version", run.version);
  text("revision", run.revision);
  text("precision", run.precision);
  text("platform", run.platform);
  text("title", run.title);
  object.raw("mpp", run.mpp ? "true" : "false");
  if (run.ranks > 0) object.integer("ranks", run.ranks);
  object.plain("termination", termination_name(run.termination));
  if (run.contact_timestep > 0) object.number("contact_timestep", run.contact_timestep);
  if (run.element_timestep > 0) object.number("element_timestep", run.element_timestep);
  if (run.problem_time > 0) object.number("problem_time", run.problem_time);
  if (run.cycles > 0) object.integer("cycles", run.cycles);
  object.raw("counts_may_be_cut", run.counts_may_be_cut ? "true" : "false");
}

void append_timestep(const SurfaceTimestep& step, Members& entry) {
  entry.plain("side", std::string_view(&step.side, 1));
  if (!step.type.empty()) entry.string("type", step.type);
  entry.number("timestep", step.timestep);
  if (step.node != 0) entry.integer("node", step.node);
  if (step.part != 0) entry.integer("part", step.part);
}

}  // namespace

void append_run(const Report& report, Buffer& out) {
  const SolverRun& run = *report.run;
  Members object(out);
  append_facts(run, object);
  const auto timestep = [&](const SurfaceTimestep& step, Members& entry) {
    if (step.contact < report.contacts.size()) entry.integer("contact", report.contacts[step.contact].id);
    append_timestep(step, entry);
  };
  const auto wall = [&](const RigidwallPenetration& penetration, Members& entry) {
    entry.integer("node", penetration.node);
    if (penetration.wall != 0) entry.integer("rigidwall", penetration.wall);
    entry.number("penetration", penetration.depth);
    append_place(report, penetration.file, penetration.line, entry);
  };
  const auto message = [&](const SolverMessage& block, Members& entry) {
    entry.plain("severity", name(block.severity));
    if (block.code != 0) entry.integer("code", block.code);
    if (!block.group.empty()) entry.string("group", block.group);
    if (!block.kind.empty()) entry.string("kind", block.kind);
    entry.string("text", block.text);
    entry.integer("count", block.count);
    append_place(report, block.file, block.line, entry);
  };
  append_list(object, "surface_timesteps", run.surface_timesteps, timestep, out);
  append_list(object, "rigidwalls", run.rigidwalls, wall, out);
  append_list(object, "messages", run.messages, message, out);
  object.close();
}

void append_predicted_timesteps(const Report& report, std::uint32_t contact, Members& object, Buffer& out) {
  if (!report.predicted) return;
  const auto& steps = report.predicted->surface_timesteps;
  const auto before = [](const SurfaceTimestep& step, std::uint32_t c) { return step.contact < c; };
  const auto first = std::lower_bound(steps.begin(), steps.end(), contact, before);
  const auto last = std::lower_bound(first, steps.end(), contact + 1, before);
  append_list(object, "surface_timesteps", std::span(first, last), append_timestep, out);
}

void append_predicted_limits(const Report& report, Buffer& out) {
  if (!report.predicted) return;
  out.append(std::string_view(",\n\"timesteps\":"));
  Members object(out);
  if (report.predicted->contact_timestep > 0) object.number("contact_timestep", report.predicted->contact_timestep);
  if (report.predicted->element_timestep > 0) object.number("element_timestep", report.predicted->element_timestep);
  object.close();
}

void append_tie_failure(const Report& report, const TieFailure& failure, const std::vector<std::string>& files,
                        std::optional<BaselineState> state, Buffer& out) {
  const RuleIdentity rule = rule_of(report, failure);
  const bool contact_known = failure.contact < report.contacts.size();
  const std::int64_t contact = contact_known ? report.contacts[failure.contact].id : 0;
  const std::string text = gapcheck::report::message(failure);
  Members object(out);
  object.plain("rule", rule.name);
  object.plain("id", rule.id);
  object.plain("severity", name(rule.severity));
  object.plain("message", text);
  object.plain("reason", gapcheck::name(failure.reason));
  if (contact_known) object.integer("contact", contact);
  object.integer("node", failure.node);
  if (failure.part != 0) object.integer("part", failure.part);
  if (failure.segment_number != 0) object.integer("segment_number", failure.segment_number);
  if (failure.distance >= 0) object.number("separation", failure.distance);
  if (failure.allowed >= 0) object.number("tie_distance", failure.allowed);
  if (failure.position)
    object.array("point", std::array{failure.position->x(), failure.position->y(), failure.position->z()});
  if (failure.line != 0 && failure.file < files.size()) {
    object.raw("file", files[failure.file]);
    object.integer("line", failure.line);
  }
  object.fingerprint(fingerprint(failure, contact));
  append_state(state, object);
  object.close();
}

}  // namespace gapcheck::report
