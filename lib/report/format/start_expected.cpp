#include "report/format/start_expected.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/item/describe.hpp"
#include "report/text/paint.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

std::string expected_part(std::int64_t part) { return part == 0 ? "no part" : fmt::format("part {}", part); }

/// The margin, or between which it lies.
std::string margin_text(const ExpectedContact& e) {
  if (e.margin) return fmt::format("{:.4g}", *e.margin);
  if (e.low && e.high) return fmt::format("{:.3g} to {:.3g}", *e.low, *e.high);
  if (e.low) return fmt::format("above {:.3g}", *e.low);
  if (e.high) return fmt::format("below {:.3g}", *e.high);
  return "-";
}

/// What would give a margin of 2.
std::string remedies_text(const ExpectedContact& e) {
  std::string text;
  const auto add = [&](const std::string& one) { text += (text.empty() ? "" : ", or ") + one; };
  if (e.thickness) add(fmt::format("{} {:.4g}", e.thickness_card, *e.thickness));
  if (e.sofscl) add(fmt::format("SOFT 1 with a SOFSCL of {:.3g}", *e.sofscl));
  if (e.step) add(fmt::format("a step of {:.3g}", *e.step));
  return text.empty() ? text : fmt::format("; {}: {}", e.alone ? "2 of the nodes alone" : "2", text);
}

std::string verdict(const ExpectedContact& e) {
  std::string text;
  if (e.never_released)
    text = "never released";
  else if (e.lost())
    text = "lost";
  else if (e.held())
    text = "held";
  else
    text = "not certain";
  if (e.crossing > 0) text += fmt::format(", {} cross 0.8 h in one step", count(e.crossing, "node"));
  if (!e.reason.empty() && e.reason != crossing_reason) text += ", " + e.reason;
  return text + remedies_text(e);
}

void append_walls(const ExpectedContacts& expected, std::size_t top, std::string& out) {
  const std::size_t shown = std::min(top, expected.walls.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const ExpectedWall& wall = expected.walls[i];
    out += fmt::format("  rigid wall {}: {} of {}, the first, {}, at {:.6g}; speed at most {:.6g}\n", wall.wall,
                       count(wall.nodes, "node"), expected_part(wall.part), wall.node, wall.time, wall.speed);
  }
  if (expected.walls.size() > shown)
    out += fmt::format("  and {} more\n", count(expected.walls.size() - shown, "rigid wall"));
}

}  // namespace

void append_expected(const StartReport& report, std::size_t top, std::string& out) {
  if (!report.expected) return;
  const ExpectedContacts& expected = *report.expected;
  out += fmt::format(
      "\nexpected along straight lines up to {:.6g}{}, if nothing but contact acts\n", expected.until,
      expected.until < expected.end ? fmt::format(" of {:.6g}: beyond that too much meets", expected.end) : "");
  constexpr std::array<Column, 10> columns{{{"contact"},
                                            {"nodes of", Align::left},
                                            {"meet", Align::left},
                                            {"nodes"},
                                            {"first at"},
                                            {"speed"},
                                            {"in a step"},
                                            {"margin"},
                                            {"nodes alone"},
                                            {"that is", Align::left}}};
  const std::size_t shown = std::min(top, expected.contacts.size());
  if (shown > 0)
    append_table(
        columns, shown,
        [&](std::size_t i, Row<10>& row) {
          const ExpectedContact& e = expected.contacts[i];
          row = {std::to_string(report.contacts[e.contact].id),
                 expected_part(e.part),
                 expected_part(e.other_part),
                 std::to_string(e.nodes),
                 fmt::format("{:.6g}", e.time),
                 fmt::format("{:.6g}", e.speed),
                 e.in_step ? fmt::format("{:.3g}", *e.in_step) : "-",
                 margin_text(e),
                 e.alone ? fmt::format("{:.4g}", *e.alone) : "-",
                 verdict(e)};
        },
        "  ", out);
  if (expected.contacts.size() > shown)
    out += fmt::format("  and {} more\n", count(expected.contacts.size() - shown, "pair"));
  append_walls(expected, top, out);
  if (expected.contacts.empty() && expected.walls.empty()) out += "  nothing meets\n";
  for (const std::string& what : expected.not_looked_at) out += "  not looked at: " + printable(what) + '\n';
}

}  // namespace gapcheck::report
