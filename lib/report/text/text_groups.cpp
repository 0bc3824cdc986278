#include "report/text/text_groups.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/item.hpp"
#include "report/write/harmless.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t causes_in_verdict = 5;

/// Bytes that continue a character of UTF-8 take no column.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string place(const Report& report, std::string_view file, std::uint32_t line) {
  if (file.empty()) return "";
  const auto folder = std::filesystem::path(report.input).parent_path();
  std::string text = std::filesystem::path(file).lexically_proximate(folder).string();
  return printable_path(text) + (line == 0 ? "" : fmt::format(":{}", line));
}

std::string place(const Report& report, const FindingGroup& group) {
  if (group.first != nullptr) return place(report, group.first->file, group.first->line);
  const auto [file, line] = group.deepest != nullptr ? std::pair(group.deepest->file, group.deepest->line)
                                                     : std::pair(group.widest->file, group.widest->line);
  return line == 0 || file >= report.files.size() ? "" : place(report, report.files[file], line);
}

/// "part 3 in part 1"; empty if neither is known.
std::string parts_of(const FindingGroup& group) {
  std::string node = group.part != 0 ? fmt::format("part {}", group.part) : "";
  if (group.element_part == 0) return node;
  return node + (node.empty() ? "in part " : " in part ") + fmt::format("{}", group.element_part);
}

std::string_view noun(const FindingGroup& group) {
  if (group.first != nullptr) return "finding";
  return group.deepest != nullptr && group.deepest->kind == PenetrationKind::edge ? "edge" : "node";
}

/// What the line says after contact and rule: the parts, how many, and the worst of them.
std::string body(const FindingGroup& group) {
  if (const Finding* finding = group.first; finding != nullptr) {
    std::string text = printable(finding->message);
    if (group.things > finding->count) text += fmt::format(" (and {} more)", group.things - finding->count);
    return text;
  }
  std::string text = parts_of(group);
  text += (text.empty() ? "" : ": ") + count(group.things, noun(group));
  if (const TieFailure* tie = group.widest; tie != nullptr) {
    text += fmt::format(", {}", what_happened(tie->reason));
    if (tie->distance >= 0) text += fmt::format(", up to {:.6g}", tie->distance);
    if (tie->distance >= 0 && tie->allowed >= 0) text += fmt::format(" where {:.6g} ties", tie->allowed);
    if (tie->moved_far()) text += fmt::format(", thickness of both {:.6g}", tie->thickness);
    return text + fmt::format(", node {}", tie->node);
  }
  const Penetration& record = *group.deepest;
  if (record.depth > 0) text += fmt::format(", deepest {:.6g}", record.depth);
  if (record.depth > 0 && record.contact_distance > 0) text += fmt::format(" of {:.6g}", record.contact_distance);
  if (record.depth > 0 && within_rounding(record)) text += ", within the rounding of coordinates";
  text += fmt::format(", node {}", record.node);
  if (record.element != 0) text += fmt::format(" in element {}", record.element);
  return text;
}

std::string line_of(const Report& report, const FindingGroup& group, std::string_view more, const TextOptions& options,
                    const Paint& paint) {
  const std::string head = fmt::format("  {} {}", printable(group.id), printable(group.rule));
  std::string text = ": ";
  if (group.contact != 0) text += fmt::format("contact {}: ", group.contact);
  std::string tail;
  if (group.following > 0) tail += fmt::format("; {} more may follow from this", group.following);
  if (!more.empty()) tail += fmt::format("; {}", more);
  if (const std::string where = place(report, group); !where.empty()) tail += "  " + where;
  if (const std::string link = link_to(report, number_of(report, group)); !link.empty())
    tail += "  " + printable_path(link);
  text += body(group);
  if (options.width > 0) {
    const std::size_t taken = columns(head) + columns(tail), least = 20;
    text = cut(std::move(text), std::max(options.width > taken ? options.width - taken : 0, least));
    tail = cut(std::move(tail), std::max(options.width, columns(head) + columns(text) + 1) - columns(head + text));
  }
  return paint.severity(group.severity, head) + text + tail;
}

/// Heading of the groups that a group belongs to.
std::string heading(const Report& report, const FindingGroup& group, GroupBy by) {
  switch (by) {
    case GroupBy::severity:
      return std::string(name(group.severity)) + "s";
    case GroupBy::rule:
      return fmt::format("{} {}", printable(group.id), printable(group.rule));
    case GroupBy::contact: {
      if (group.contact == 0) return "in no contact";
      std::string text = fmt::format("contact {}", group.contact);
      if (group.contact_position < report.contacts.size())
        if (const std::string& title = report.contacts[group.contact_position].title; !title.empty())
          text += fmt::format(" \"{}\"", printable(title));
      return text;
    }
    case GroupBy::part:
      return group.part != 0           ? fmt::format("part {}", group.part)
             : group.element_part != 0 ? fmt::format("part {}", group.element_part)
                                       : "in no part";
    case GroupBy::file: {
      const std::string where = place(report, group);
      return where.empty() ? "in no file" : where.substr(0, where.rfind(':'));
    }
  }
  return "";
}

/// Consecutive groups of one rule under one heading, and how many of them get a line.
struct Block {
  std::size_t section = 0;  ///< of the heading
  std::span<const FindingGroup* const> groups;
  std::size_t shown = 0;
};

/// Hands out lines: one to each block, then one more to each as long as there are any. A heading takes one as well.
void hand_out(std::vector<Block>& blocks, std::size_t sections, LineLimits limits) {
  std::vector<bool> has_heading(sections);
  for (bool given = true; given;) {
    given = false;
    for (Block& block : blocks) {
      const std::size_t lines = has_heading[block.section] ? 1 : 2;
      if (limits.all < lines || block.shown == std::min(block.groups.size(), limits.per_rule)) continue;
      has_heading[block.section] = given = true;
      ++block.shown, limits.all -= lines;
    }
  }
}

/// "12 more in 3 lines" of the groups that a block does not show.
std::string rest_of(const Block& block) {
  std::uint64_t things = 0;
  for (const FindingGroup* group : block.groups.subspan(block.shown)) things += group->things;
  return things == 0 ? "" : fmt::format("and {} more like this (--all)", things);
}

/// "contact 3", "contacts 3, 5 and 20 more".
std::string contacts_of(std::span<const FindingGroup> groups) {
  std::vector<std::int64_t> ids;
  for (const FindingGroup& group : groups)
    if (group.contact != 0 && std::find(ids.begin(), ids.end(), group.contact) == ids.end())
      ids.push_back(group.contact);
  constexpr std::size_t named = 3;
  if (ids.empty()) return "";
  std::string text = ids.size() == 1 ? " in contact " : " in contacts ";
  for (std::size_t i = 0; i < std::min(named, ids.size()); ++i) text += fmt::format("{}{}", i > 0 ? ", " : "", ids[i]);
  return text + (ids.size() > named ? fmt::format(" and {} more", ids.size() - named) : "");
}

/// The consecutive groups of equal rule and severity at the beginning.
std::span<const FindingGroup> first_rule(std::span<const FindingGroup> groups) {
  const FindingGroup& first = groups.front();
  const auto end = std::find_if(groups.begin(), groups.end(), [&](const FindingGroup& group) {
    return group.id != first.id || group.severity != first.severity;
  });
  return groups.first(static_cast<std::size_t>(end - groups.begin()));
}

std::uint64_t things_in(std::span<const FindingGroup> groups) {
  std::uint64_t sum = 0;
  for (const FindingGroup& group : groups) sum += group.things;
  return sum;
}

}  // namespace

std::string cut(std::string text, std::size_t width) {
  if (width == 0 || columns(text) <= width) return text;
  std::size_t end = 0;
  for (std::size_t column = 0; end < text.size(); ++end) {
    if ((static_cast<unsigned char>(text[end]) & 0xC0) != 0x80 && ++column == width) break;
  }
  return text.substr(0, end) + "…";
}

std::vector<std::string> verdict_lines(const Report& report, std::span<const FindingGroup> groups, std::size_t width,
                                       const Paint& paint) {
  std::vector<std::string> lines;
  std::size_t more = 0;
  while (!groups.empty() && groups.front().severity != Severity::note) {
    const auto rule = first_rule(groups);
    groups = groups.subspan(rule.size());
    const FindingGroup& first = rule.front();
    if (first.consequence.empty()) continue;
    if (lines.size() == causes_in_verdict) {
      ++more;
      continue;
    }
    const std::string number = count(things_in(rule), noun(first));
    const std::string where = fmt::format(" ({}{}, {})", number, contacts_of(rule), printable(first.id));
    const std::size_t left = width > 0 ? std::max(width, columns(where) + 10) - columns(where) : 0;
    lines.push_back(paint.severity(first.severity, cut("  " + printable(first.consequence), left)) + where);
  }
  if (lines.empty()) return lines;
  if (more > 0) lines.back() += fmt::format("; {} further cause{} below", more, more == 1 ? "" : "s");
  lines.insert(lines.begin(), paint.bold(report.source == "deck" ? "If this deck runs:" : "In this run:"));
  return lines;
}

std::vector<std::string> group_lines(const Report& report, std::span<const FindingGroup> groups,
                                     const TextOptions& options, LineLimits limits, const Paint& paint) {
  std::vector<std::string> titles;
  std::map<std::string, std::vector<const FindingGroup*>> sections;
  for (const FindingGroup& group : groups) {
    const std::string title = heading(report, group, options.group_by);
    auto& section = sections[title];
    if (section.empty()) titles.push_back(title);
    section.push_back(&group);
  }
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < titles.size(); ++i)
    for (std::span<const FindingGroup* const> rest = sections[titles[i]]; !rest.empty();) {
      const auto end =
          std::find_if(rest.begin(), rest.end(), [&](const FindingGroup* group) { return group->id != rest[0]->id; });
      blocks.push_back({i, rest.first(static_cast<std::size_t>(end - rest.begin())), 0});
      rest = rest.subspan(blocks.back().groups.size());
    }
  --limits.all;  // the line that says how much has none
  hand_out(blocks, titles.size(), limits);
  std::vector<std::string> lines;
  std::uint64_t hidden = 0;
  for (std::size_t i = 0, section = titles.size(); i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    for (const FindingGroup* group : block.groups) hidden += block.shown == 0 ? group->things : 0;
    if (block.shown == 0) continue;
    if (block.section != section) lines.push_back(paint.bold(cut(titles[section = block.section], options.width)));
    for (std::size_t k = 0; k < block.shown; ++k)
      lines.push_back(line_of(report, *block.groups[k], k + 1 == block.shown ? rest_of(block) : "", options, paint));
  }
  if (hidden > 0) lines.push_back(fmt::format("  … and {} more (--all)", hidden));
  return lines;
}

std::vector<std::string> rule_sum_lines(std::span<const FindingGroup> groups, std::size_t width, const Paint& paint) {
  std::vector<std::string> lines;
  std::size_t used = 0;
  while (!groups.empty()) {
    const auto rule = first_rule(groups);
    groups = groups.subspan(rule.size());
    const std::string text = fmt::format("{} {} {}", printable(rule[0].id), printable(rule[0].rule), things_in(rule));
    if (lines.empty() || used + 2 + columns(text) > width) {
      if (!lines.empty()) lines.back() += ',';
      lines.emplace_back("  ");
      used = 2;
    } else {
      lines.back() += ", ";
      used += 2;
    }
    lines.back() += paint.severity(rule[0].severity, text);
    used += columns(text);
  }
  return lines;
}

}  // namespace gapcheck::report
