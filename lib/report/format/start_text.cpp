#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "report/format/start_expected.hpp"
#include "report/format/start_report.hpp"
#include "report/item/describe.hpp"
#include "report/text/paint.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

std::string start_number(double value) { return fmt::format("{:.6g}", value); }

std::string start_part(std::int64_t part) { return part == 0 ? "no part" : fmt::format("part {}", part); }

/// Appends "  and 3 nodes more" where a list was cut.
void append_rest(std::size_t all, std::size_t shown, std::string_view what, std::string& out) {
  if (all > shown) out += fmt::format("  and {} more\n", count(all - shown, what));
}

void append_scores(const StartReport& report, std::string& out) {
  constexpr std::array<Column, 6> columns{
      {{"contact"}, {"moved"}, {"forgiven"}, {"forced"}, {"released"}, {"score", Align::left}}};
  append_table(
      columns, report.contacts.size(),
      [&](std::size_t i, Row<6>& row) {
        const StartContact& c = report.contacts[i];
        row = {std::to_string(c.id),     std::to_string(c.moved),    std::to_string(c.kept),
               std::to_string(c.forced), std::to_string(c.released), printable(score(c))};
      },
      "  ", out);
}

/// The bins that are not empty.
std::string histogram_text(const StartCounts& counts) {
  std::string text;
  const double width = counts.largest_move / static_cast<double>(start_bins);
  for (std::size_t bin = 0; bin < start_bins; ++bin)
    if (counts.histogram[bin] > 0)
      text += fmt::format("{}{} by {:.4g} to {:.4g}", text.empty() ? "" : ", ", counts.histogram[bin],
                          width * static_cast<double>(bin), width * static_cast<double>(bin + 1));
  return text;
}

void append_shapes(const StartReport& report, const StartShapes& shapes, std::string_view indent, std::string& out) {
  if (shapes.touched == 0) return;
  out += fmt::format("{}{} touched, {} changed, {} collapsed\n", indent, count(shapes.touched, "element"),
                     shapes.changed, shapes.collapsed);
  const auto line = [&](std::string_view what, const std::optional<std::size_t>& at, const auto& value) {
    if (!at) return;
    const StartElement& e = report.elements[*at];
    out += fmt::format("{}  {} {} to {}: {} {} of {}\n", indent, what, start_number(value(e.before)),
                       start_number(value(e.after)), e.kind, e.id, start_part(e.part));
  };
  line("edge ratio", shapes.edge_ratio, [](const StartElement::Shape& s) { return s.edge_ratio; });
  line("warp", shapes.warp, [](const StartElement::Shape& s) { return s.warp; });
  line("step", shapes.step, [](const StartElement::Shape& s) { return s.step; });
}

void append_pair(const StartReport& report, const StartPair& pair, std::string& out) {
  out += fmt::format("\ncontact {}, {} in {}\n", report.contacts[pair.contact].id, start_part(pair.part),
                     start_part(pair.other_part));
  if (pair.moved > 0)
    out += fmt::format("  {} moved: at most {:.6g}, on average {:.6g}; {}\n", count(pair.moved, "node"),
                       pair.largest_move, pair.total_move / static_cast<double>(pair.moved), histogram_text(pair));
  append_shapes(report, pair.shapes, "    ", out);
  if (pair.kept > 0)
    out +=
        fmt::format("  {} forgiven: at most {:.6g} deep{}\n", count(pair.kept, "node"), pair.deepest_kept,
                    pair.least_share ? fmt::format(", {:.4g} % of the thickness left", 100 * *pair.least_share) : "");
  if (pair.forced > 0)
    out += fmt::format("  {} with a force from nothing: at most {:.6g} deep, energy {}\n", count(pair.forced, "node"),
                       pair.deepest_forced,
                       report.contacts[pair.contact].no_energy.empty() ? start_number(pair.energy) : "not known");
  if (pair.released > 0)
    out += fmt::format("  {} released: without contact until they have moved out by up to {:.6g}\n",
                       count(pair.released, "node"), pair.way_out);
  if (pair.to_release) out += fmt::format("  {:.6g} further in, and the first node loses contact\n", *pair.to_release);
}

void append_elements(const StartReport& report, std::size_t top, std::string& out) {
  const std::size_t shown = std::min(top, report.elements.size());
  if (shown == 0) return;
  out += fmt::format("\n{} changed by moved nodes\n", count(report.elements.size(), "element"));
  constexpr std::array<Column, 7> columns{
      {{"element"}, {"part"}, {"contact"}, {"edge ratio"}, {"warp"}, {"size"}, {"step"}}};
  const auto change = [](double before, double after) {
    return before == after ? start_number(after) : start_number(before) + " to " + start_number(after);
  };
  append_table(
      columns, shown,
      [&](std::size_t i, Row<7>& row) {
        const StartElement& e = report.elements[i];
        row = {fmt::format("{}{} {}",
                           e.inverted ? "inside out: "
                           : e.flat   ? "flat: "
                                      : "",
                           e.kind, e.id),
               id_or_dash(e.part),
               id_or_dash(e.contact),
               change(e.before.edge_ratio, e.after.edge_ratio),
               change(e.before.warp, e.after.warp),
               change(e.before.size, e.after.size),
               change(e.before.step, e.after.step)};
      },
      "  ", out);
  append_rest(report.elements.size(), shown, "element", out);
}

void append_crossings(const StartReport& report, std::size_t top, std::string& out) {
  if (report.crossings.empty()) return;
  out += fmt::format("\n{} of elements cross that do not cross in the deck\n", count(report.crossings.size(), "pair"));
  const std::size_t shown = std::min(top, report.crossings.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const StartCrossing& c = report.crossings[i];
    out += fmt::format("  {} {} of {} and {} {} of {}, {:.6g} deep: contact {} moved their nodes\n", c.a.kind, c.a.id,
                       start_part(c.a.part), c.b.kind, c.b.id, start_part(c.b.part), c.depth, id_or_dash(c.moved_by));
  }
  append_rest(report.crossings.size(), shown, "pair", out);
}

void append_repeats(const StartReport& report, std::size_t top, std::string& out) {
  if (report.repeats.empty()) return;
  out += fmt::format("\n{} moved more than once\n", count(report.repeats.size(), "node"));
  const std::size_t shown = std::min(top, report.repeats.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const StartRepeat& r = report.repeats[i];
    std::string by;
    for (const std::uint32_t contact : r.contacts)
      by += fmt::format("{}{}", by.empty() ? "" : ", ", report.contacts[contact].id);
    out += fmt::format("  node {} by contacts {}: {:.6g} in all, {:.6g} from its place in the deck{}\n", r.node, by,
                       r.path, r.net, r.back ? "; it is pushed back" : "");
  }
  append_rest(report.repeats.size(), shown, "node", out);
}

void append_run(const StartReport& report, std::string& out) {
  out += '\n';
  out += report.first_cycle ? "followed through the first cycle of the run\n"
                            : "followed through the initialisation of the contacts; there is no first cycle\n";
  for (const StartRefusal& r : report.refused) {
    out += "run refuses the deck: ";
    if (!r.file.empty()) out += fmt::format("{}:{}: ", printable_path(r.file), r.line);
    if (!r.keyword.empty()) out += fmt::format("*{}: ", printable(r.keyword));
    out += printable(r.why) + '\n';
  }
  for (const StartContact& c : report.contacts)
    if (!c.no_energy.empty()) out += fmt::format("contact {}: no energy, since {}\n", c.id, c.no_energy);
  if (report.kinetic) out += fmt::format("kinetic energy {:.6g}, of contacts {:.6g}\n", *report.kinetic, report.energy);
  if (report.first_step) out += fmt::format("first step {:.6g}\n", *report.first_step);
  if (std::isfinite(report.step_before))
    out += fmt::format("smallest step of an element {:.6g} in the deck, {:.6g} at the start\n", report.step_before,
                       report.step_after);
  for (const std::string& note : report.notes) out += "note: " + printable(note) + '\n';
}

std::string start_last_line(const StartReport& report) {
  const auto clean =
      std::ranges::count_if(report.contacts, [](const StartContact& c) { return c.not_known.empty() && c.clean(); });
  const std::string moved =
      report.moved > 0 ? fmt::format("{} moved by at most {:.6g}", count(report.moved, "node"), report.largest_move)
                       : "no node moved";
  const std::string energy = report.energy > 0 ? fmt::format("; energy {:.6g} from nothing", report.energy) : "";
  return fmt::format("{} of {} contacts start clean; {}{}\n", clean, report.contacts.size(), moved, energy);
}

}  // namespace

std::string start_text(const StartReport& report, const StartTextOptions& options) {
  std::string out;
  if (!options.quiet) {
    out = printable_path(report.input) + "\n\n";
    append_scores(report, out);
    const std::size_t shown = std::min(options.top, report.pairs.size());
    for (std::size_t i = 0; i < shown; ++i) append_pair(report, report.pairs[i], out);
    if (report.pairs.size() > shown) out += '\n';
    append_rest(report.pairs.size(), shown, "pair", out);
    append_elements(report, options.top, out);
    append_crossings(report, options.top, out);
    append_repeats(report, options.top, out);
    append_expected(report, options.top, out);
    append_run(report, out);
    for (const std::string& file : report.written) out += "written: " + printable_path(file) + '\n';
    if (!report.written.empty())
      out += fmt::format("written nodes are within {:.3g} of where they start\n", report.rounding);
    out += '\n';
  }
  return out + start_last_line(report);
}

}  // namespace gapcheck::report
