#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "report/compare/compare.hpp"
#include "report/item/describe.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

std::string note(const ContactComparison& contact) {
  if (contact.not_checked) return contact.ties_compared ? "tied" : "not checked in one of them";
  if (contact.tied) return "tied";
  std::string text = contact.counts_only ? "only numbers of nodes are known" : "";
  const auto add = [&](std::string_view part) { text += (text.empty() ? "" : ", ") + std::string(part); };
  if (contact.by_number > 0) add(fmt::format("{} of them by number, unlisted in one", contact.by_number));
  if (contact.missing_in_first) add("not in A");
  if (contact.missing_in_second) add("not in B");
  return text;
}

std::string depth(double value) {
  if (value < 0) return "-";
  return value > 0 ? fmt::format("{:.6g}", value) : "?";
}

void append_contacts(const Comparison& comparison, std::string& out) {
  constexpr std::array columns{Column{"contact"}, Column{"type"},   Column{"agree"},      Column{"depth differs"},
                               Column{"only A"},  Column{"only B"}, Column{"by at most"}, Column{"", Align::left}};
  append_table(
      columns, comparison.contacts.size(),
      [&](std::size_t i, auto& row) {
        const ContactComparison& c = comparison.contacts[i];
        row = {fmt::format("{}", c.id),
               c.type.empty() ? "-" : printable(c.type),
               fmt::format("{}", c.agree),
               fmt::format("{}", c.depth_differs),
               fmt::format("{}", c.only_first),
               fmt::format("{}", c.only_second),
               fmt::format("{:.3g}", c.largest_difference),
               note(c)};
      },
      "  ", out);
}

/// The largest differences of one contact, which are consecutive.
void append_differences(std::span<const Difference> differences, std::size_t top, std::string& out) {
  constexpr std::array columns{Column{"node"}, Column{"A"}, Column{"B"}};
  const std::size_t rows = std::min(top, differences.size());
  out += fmt::format("\ncontact {}: {} node{} differ{}", differences.front().contact, differences.size(),
                     differences.size() == 1 ? "" : "s", differences.size() == 1 ? "s" : "");
  out += rows < differences.size() ? fmt::format(", largest {}\n", rows) : "\n";
  if (rows == 0) return;
  append_table(
      columns, rows,
      [&](std::size_t i, auto& row) {
        row = {fmt::format("{}", differences[i].node), depth(differences[i].first), depth(differences[i].second)};
      },
      "  ", out);
}

void append_tie_counts(const Comparison& comparison, std::string& out) {
  std::vector<const ContactComparison*> tied;
  for (const ContactComparison& contact : comparison.contacts)
    if (contact.ties_compared) tied.push_back(&contact);
  if (tied.empty()) return;
  constexpr std::array columns{Column{"untied nodes of contact"},
                               Column{"agree"},
                               Column{"other reason"},
                               Column{"only A"},
                               Column{"only B"},
                               Column{"", Align::left}};
  out += '\n';
  append_table(
      columns, tied.size(),
      [&](std::size_t i, auto& row) {
        const ContactComparison& c = *tied[i];
        row = {fmt::format("{}", c.id),
               fmt::format("{}", c.ties_agree),
               fmt::format("{}", c.ties_other_reason),
               fmt::format("{}", c.ties_only_first),
               fmt::format("{}", c.ties_only_second),
               c.ties_out_of_reach > 0 ? fmt::format("{} out of reach", c.ties_out_of_reach) : ""};
      },
      "  ", out);
}

void append_tie_differences(std::span<const TieDifference> differences, std::size_t top, std::string& out) {
  constexpr std::array columns{Column{"node"}, Column{"A", Align::left}, Column{"B", Align::left}};
  const std::size_t rows = std::min(top, differences.size());
  out += fmt::format("\ncontact {}: {} untied node{} differ{}", differences.front().contact, differences.size(),
                     differences.size() == 1 ? "" : "s", differences.size() == 1 ? "s" : "");
  out += rows < differences.size() ? fmt::format(", first {}\n", rows) : "\n";
  if (rows == 0) return;
  const auto reason = [](const std::optional<TieReason>& r) { return r ? std::string(name(*r)) : std::string("-"); };
  append_table(
      columns, rows,
      [&](std::size_t i, auto& row) {
        row = {fmt::format("{}", differences[i].node), reason(differences[i].first), reason(differences[i].second)};
      },
      "  ", out);
}

void append_timesteps(const TimestepComparison& steps, std::size_t top, std::string& out) {
  const std::uint64_t compared = steps.agree + steps.other_node + steps.differ;
  if (compared == 0) return;
  out += fmt::format("\nsurface time steps: {} compared, {} differ{}", compared, steps.differ,
                     steps.differ == 1 ? "s" : "");
  if (steps.other_node > 0) out += fmt::format(", {} with another node of the same step", steps.other_node);
  if (steps.only_first + steps.only_second > 0)
    out += fmt::format(", {} only in A, {} only in B", steps.only_first, steps.only_second);
  out += '\n';
  constexpr std::array columns{Column{"contact"}, Column{"side", Align::left}, Column{"A"}, Column{"node"}, Column{"B"},
                               Column{"node"}};
  const auto step = [](double value) {
    return value < no_timestep_limit ? fmt::format("{:.3E}", value) : std::string("no limit");
  };
  const std::size_t rows = std::min(top, steps.differences.size());
  if (rows == 0) return;
  append_table(
      columns, rows,
      [&](std::size_t i, auto& row) {
        const TimestepDifference& d = steps.differences[i];
        row = {fmt::format("{}", d.contact),    std::string(1, d.side), step(d.first),
               fmt::format("{}", d.node_first), step(d.second),         fmt::format("{}", d.node_second)};
      },
      "  ", out);
  if (rows < steps.differences.size()) out += fmt::format("  … and {} more\n", steps.differences.size() - rows);
}

/// Calls `append` with the consecutive entries of one contact.
template <class Difference, class Append>
void by_contact(std::span<const Difference> rest, const Append& append) {
  while (!rest.empty()) {
    const auto end =
        std::find_if(rest.begin(), rest.end(), [&](const Difference& d) { return d.contact != rest.front().contact; });
    const auto length = static_cast<std::size_t>(end - rest.begin());
    append(rest.first(length));
    rest = rest.subspan(length);
  }
}

void append_only(std::string_view side, const std::vector<std::string>& names, std::size_t top, std::string& out) {
  if (names.empty()) return;
  const std::size_t shown = std::min(top, names.size());
  out += fmt::format("  only in {}: ", side);
  for (std::size_t i = 0; i < shown; ++i) out += (i > 0 ? ", " : "") + printable(names[i]);
  out += shown < names.size() ? fmt::format("{}{} more\n", shown > 0 ? " and " : "", names.size() - shown) : "\n";
}

void append_curve_pairs(const CurveComparison& curves, std::size_t rows, std::string& out) {
  constexpr std::array columns{
      Column{"curve", Align::left}, Column{"rating"},  Column{"relative"},  Column{"L2"},
      Column{"by at most"},         Column{"at time"}, Column{"largest A"}, Column{"largest B"},
      Column{"", Align::left}};
  append_table(
      columns, rows,
      [&](std::size_t i, auto& row) {
        const CurvePair& p = curves.pairs[i];
        row = {printable(p.name),
               p.rating ? fmt::format("{:.3f}", p.rating->overall()) : "-",
               fmt::format("{:.2e}", p.relative_difference),
               fmt::format("{:.2e}", p.l2_difference),
               fmt::format("{:.5g}", p.largest_difference),
               fmt::format("{:.6g}", p.time),
               fmt::format("{:.5g}", p.largest_first),
               fmt::format("{:.5g}", p.largest_second),
               p.not_numbers ? "NaN in one of them" : ""};
      },
      "  ", out);
}

void append_curves(const CurveComparison& curves, std::size_t top, std::string& out) {
  out += fmt::format("\ncurves: {} compared, {} differ{} by more than {:g} of the larger one\n",
                     curves.agree + curves.differ, curves.differ, curves.differ == 1 ? "s" : "", curves.tolerance);
  if (const std::size_t rows = std::min(top, curves.differ); rows > 0) {
    append_curve_pairs(curves, rows, out);
    if (rows < curves.differ) out += fmt::format("  … and {} more\n", curves.differ - rows);
  }
  if (curves.end_first != curves.end_second)
    out += fmt::format("  A ends at time {:g}, B at {:g}\n", curves.end_first, curves.end_second);
  if (curves.without_common_times > 0) out += fmt::format("  without common times: {}\n", curves.without_common_times);
  append_only("A", curves.only_first, top, out);
  append_only("B", curves.only_second, top, out);
}

void append_motion_parts(const MotionComparison& motion, std::size_t rows, std::string& out) {
  constexpr std::array columns{Column{"part"},    Column{"nodes"}, Column{"by at most"},      Column{"of the largest"},
                               Column{"at time"}, Column{"node"},  Column{"mean at the end"}, Column{"", Align::left}};
  append_table(
      columns, rows,
      [&](std::size_t i, auto& row) {
        const PartMotion& p = motion.parts[i];
        const double largest = motion.largest_displacement;
        row = {id_or_dash(p.part),
               fmt::format("{}", p.nodes),
               fmt::format("{:.5g}", p.largest_distance),
               largest > 0 ? fmt::format("{:.2e}", p.largest_distance / largest) : "-",
               fmt::format("{:.6g}", p.time),
               id_or_dash(p.node),
               fmt::format("{:.5g}", p.mean.empty() ? 0 : p.mean.back()),
               p.not_numbers ? "NaN in one of them" : ""};
      },
      "  ", out);
}

void append_motion(const MotionComparison& motion, std::size_t top, std::string& out) {
  if (motion.times.empty()) {
    out += "\nmotion: the d3plots have no states in a common range of time\n";
    return;
  }
  out += fmt::format(
      "\nmotion: {} state{} compared, {} of {} part{} differ{} by more than {:g} of the largest displacement, {:.5g}\n",
      motion.times.size(), motion.times.size() == 1 ? "" : "s", motion.differ, motion.parts.size(),
      motion.parts.size() == 1 ? "" : "s", motion.differ == 1 ? "s" : "", motion.tolerance,
      motion.largest_displacement);
  if (const std::size_t rows = std::min(top, motion.differ); rows > 0) {
    append_motion_parts(motion, rows, out);
    if (rows < motion.differ) out += fmt::format("  … and {} more\n", motion.differ - rows);
  }
  if (motion.only_first > 0) out += fmt::format("  nodes only in A: {}\n", motion.only_first);
  if (motion.only_second > 0) out += fmt::format("  nodes only in B: {}\n", motion.only_second);
}

}  // namespace

std::string comparison_text(const Comparison& comparison, const Report& first, const Report& second, std::size_t top,
                            const RunComparison& runs) {
  const CurveComparison* curves = runs.curves;
  std::string out = fmt::format("A: {}\nB: {}\n\n", printable_path(first.input), printable_path(second.input));
  append_contacts(comparison, out);
  append_tie_counts(comparison, out);
  by_contact(std::span(comparison.differences), [&](auto part) { append_differences(part, top, out); });
  by_contact(std::span(comparison.tie_differences), [&](auto part) { append_tie_differences(part, top, out); });
  append_timesteps(comparison.timesteps, top, out);
  if (curves != nullptr) append_curves(*curves, top, out);
  if (runs.motion != nullptr) append_motion(*runs.motion, top, out);
  const auto open = std::count_if(comparison.contacts.begin(), comparison.contacts.end(),
                                  [](const ContactComparison& c) { return c.not_checked && !c.ties_compared; });
  std::uint64_t agree = 0;
  for (const ContactComparison& contact : comparison.contacts) agree += contact.agree + contact.ties_agree;
  const bool equal = comparison.equal() && runs.equal();
  out += equal ? "\nno differences" : "\nthe two differ";
  out += fmt::format(", {} node{} agree{}", agree, agree == 1 ? "" : "s", agree == 1 ? "s" : "");
  if (curves != nullptr)
    out += fmt::format(", {} curve{} agree{}", curves->agree, curves->agree == 1 ? "" : "s",
                       curves->agree == 1 ? "s" : "");
  if (open > 0) out += fmt::format(", {} contact{} not compared", open, open == 1 ? "" : "s");
  return out + '\n';
}

}  // namespace gapcheck::report
