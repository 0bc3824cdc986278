#include "report/text/text_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "report/item/describe.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

std::string times(std::uint64_t count) { return fmt::format("{} time{}", count, count == 1 ? "" : "s"); }

std::string message_place(const Report& report, const SolverMessage& message) {
  if (message.line == 0 || message.file >= report.files.size()) return "";
  return fmt::format("  {}:{}", printable_path(report.files[message.file]), message.line);
}

/// "Warning 60303 (IMP), implicit-gap-flag".
std::string header(const SolverMessage& message) {
  std::string text = message.severity == Severity::error ? "Error" : "Warning";
  if (message.code != 0) text += fmt::format(" {}", message.code);
  if (!message.group.empty()) text += fmt::format(" ({})", printable(message.group));
  return text + ", " + (message.kind.empty() ? "not understood" : printable(message.kind));
}

/// Of a message that is not understood so much is shown without being asked for.
constexpr std::size_t longest_unknown = 400;

}  // namespace

std::string run_line(const SolverRun& run) {
  std::string line;
  const auto add = [&line](std::string_view text) {
    if (!text.empty()) line += (line.empty() ? "" : ", ") + printable(text);
  };
  add(run.version);
  add(run.revision);
  add(run.precision);
  if (run.mpp) add(run.ranks > 0 ? fmt::format("{} ranks", run.ranks) : "MPP");
  if (run.termination == SolverRun::Termination::normal) add("normal termination");
  if (run.termination == SolverRun::Termination::error) add("error termination");
  if (line.empty()) return "";
  return (run.version.starts_with("gapcheck") ? "  " : "  LS-DYNA ") + line + '\n';
}

const Timesteps* timesteps(const Report& report) {
  if (report.run) return &*report.run;
  return report.predicted ? &*report.predicted : nullptr;
}

void append_surface_timesteps(const Timesteps& steps, std::uint32_t contact, std::string& out) {
  const auto& all = steps.surface_timesteps;  // by contact
  const auto before = [](const SurfaceTimestep& step, std::uint32_t position) { return step.contact < position; };
  for (auto at = std::lower_bound(all.begin(), all.end(), contact, before); at != all.end() && at->contact == contact;
       ++at) {
    const SurfaceTimestep& step = *at;
    if (step.timestep >= no_timestep_limit) {
      out += fmt::format("  surface {}: no time step limit: no node has both mass and a segment of shells or solids\n",
                         step.side);
      continue;
    }
    out += fmt::format("  surface {}: time step {:.3E}, controlled by node {} of part {}\n", step.side, step.timestep,
                       id_or_dash(step.node), id_or_dash(step.part));
  }
}

void append_timestep_limits(const Timesteps& steps, std::string& out) {
  if (steps.contact_timestep > 0)
    out += fmt::format("\ncontact: the time step should not exceed {:.3E}\n", steps.contact_timestep);
  if (steps.element_timestep > 0) out += fmt::format("elements: smallest time step {:.3E}\n", steps.element_timestep);
}

void append_rigidwalls(const SolverRun& run, std::size_t limit, std::string& out) {
  if (run.rigidwalls.empty()) return;
  std::vector<RigidwallPenetration> walls = run.rigidwalls;
  std::stable_sort(walls.begin(), walls.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
  const std::size_t rows = std::min(limit, walls.size());
  out += fmt::format("\nrigid walls: {} penetrating node{}", walls.size(), walls.size() == 1 ? "" : "s");
  out += rows < walls.size() ? fmt::format(", top {}\n", rows) : "\n";
  constexpr std::array columns{Column{"node"}, Column{"rigid wall"}, Column{"penetration"}};
  if (rows == 0) return;
  append_table(
      columns, rows,
      [&](std::size_t i, auto& row) {
        row = {fmt::format("{}", walls[i].node), id_or_dash(walls[i].wall), fmt::format("{:.4E}", walls[i].depth)};
      },
      "    ", out);
}

void append_messages(const Report& report, bool list, std::string_view option, std::string& out) {
  const SolverRun& run = *report.run;
  if (!run.messages.empty()) out += "\nother messages of the solver\n";
  for (std::size_t i = 0, next = 0; i < run.messages.size(); i = next) {
    const std::string title = header(run.messages[i]);
    std::uint64_t count = 0;
    for (; next < run.messages.size() && header(run.messages[next]) == title; ++next) {
      const SolverMessage& message = run.messages[next];
      count += message.count;
      if (!list) continue;
      out += "  " + title + message_place(report, message) + (message.count > 1 ? ", " + times(message.count) : "");
      out += "\n    " + printable(message.text) + '\n';
    }
    if (!list) out += fmt::format("  {}: {}\n", title, times(count));
    if (!list && run.messages[i].kind.empty())
      out += fmt::format("    {}\n", printable(beginning(run.messages[i].text, longest_unknown)));
  }
  const bool unknown = std::any_of(run.messages.begin(), run.messages.end(),
                                   [](const SolverMessage& message) { return message.kind.empty(); });
  if (unknown)
    out +=
        "  not understood: please send the text and the solver's version; --messages FILE adds a meaning of your own\n";
  if (!list && !run.messages.empty()) out += fmt::format("  {} shows their text\n", option);
  if (run.counts_may_be_cut) out += "\nThe solver left messages out: every count here is \"at least\".\n";
}

}  // namespace gapcheck::report
