#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/ids.hpp"
#include "report/export/exports.hpp"
#include "report/export/exports_groups.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"

namespace gapcheck::report {
namespace {

using Segment = std::array<std::int64_t, 4>;

constexpr std::int64_t most_short_id = 9'999'999'999;
constexpr std::int64_t most_set_id = 999'999'999'999'999'999;
constexpr std::size_t longest_set_title = 80;

/// What the findings of one rule in one contact name.
struct SetMembers {
  std::string_view id, rule;
  std::vector<std::int64_t> nodes;  ///< ascending, each once, once `finish` has run
  std::vector<Segment> segments;    ///< so are these
  double deepest = 0;
  std::uint64_t not_listed = 0;  ///< things that findings count but do not list
  std::uint64_t without_id = 0;  ///< nodes and segments with invalid ids
};

std::size_t corners(const Segment& segment) { return std::set<std::int64_t>(segment.begin(), segment.end()).size(); }

template <class Value>
void sort_once(std::vector<Value>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

void finish(SetMembers& members) {
  std::erase_if(members.segments, [&](const Segment& segment) {
    if (corners(segment) >= 3) return false;
    members.nodes.insert(members.nodes.end(), segment.begin(), segment.end());
    return true;
  });
  members.without_id += std::erase_if(members.nodes, [](std::int64_t node) { return node <= 0; });
  members.without_id += std::erase_if(members.segments, [](const Segment& segment) {
    return std::any_of(segment.begin(), segment.end(), [](std::int64_t node) { return node <= 0; });
  });
  sort_once(members.nodes);
  sort_once(members.segments);
}

/// By contact, those of none last, then by rule.
class FindingGroups {
 public:
  explicit FindingGroups(const Report& report) : report_(report) {
    for (std::uint32_t i = 0; i < report.contacts.size(); ++i) position_.emplace(report.contacts[i].id, i);
    for (const Penetration& record : report.penetrations) add(record);
    for (const TieFailure& failure : report.tie_failures) add(failure);
    for (const Finding& finding : report.findings) add(finding);
    for (auto& [key, members] : groups_) finish(members);
  }

  using Key = std::pair<std::uint32_t, std::string_view>;  ///< position of the contact, id of the rule
  [[nodiscard]] const std::map<Key, SetMembers>& all() const { return groups_; }
  [[nodiscard]] std::uint64_t without_place() const { return without_place_; }

 private:
  SetMembers& group(std::uint32_t contact, std::string_view id, std::string_view rule) {
    SetMembers& members = groups_[{contact < report_.contacts.size() ? contact : no_position, id}];
    members.id = id;
    members.rule = rule;
    return members;
  }

  void add(const Penetration& record) {
    const RuleIdentity& rule = rule_of(record.kind);
    SetMembers& members = group(record.contact, rule.id, rule.name);
    members.nodes.push_back(record.node);
    // Solver files do not always say which segment it is.
    if (record.segment != Segment{}) members.segments.push_back(record.segment);
    if (record.depth > members.deepest && std::isfinite(record.depth)) members.deepest = record.depth;
  }

  void add(const TieFailure& failure) {
    const RuleIdentity rule = rule_of(failure);
    group(failure.contact, rule.id, rule.name).nodes.push_back(failure.node);
  }

  void add(const Finding& finding) {
    const FindingMembers& listed = finding.members;
    if (finding.node == 0 && listed.nodes.empty() && listed.segments.empty()) {
      ++without_place_;
      return;
    }
    const auto contact = position_.find(finding.contact);
    SetMembers& members = group(finding.contact != 0 && contact != position_.end() ? contact->second : no_position,
                                finding.id, finding.rule);
    const std::size_t before = members.nodes.size();
    if (finding.node != 0) members.nodes.push_back(finding.node);
    members.nodes.insert(members.nodes.end(), listed.nodes.begin(), listed.nodes.end());
    const bool names_nodes = members.nodes.size() > before;
    for (const Segment& segment : listed.segments) {
      members.segments.push_back(segment);
      if (!names_nodes) members.nodes.insert(members.nodes.end(), segment.begin(), segment.end());
    }
    if (finding.penetration > members.deepest && std::isfinite(finding.penetration))
      members.deepest = finding.penetration;
    const auto things = std::max<std::uint64_t>({1, listed.nodes.size(), listed.segments.size()});
    if (finding.count > things) members.not_listed += finding.count - things;
  }

  const Report& report_;
  std::unordered_map<std::int64_t, std::uint32_t> position_;  ///< of a contact's id; the first of equal ones
  std::map<Key, SetMembers> groups_;
  std::uint64_t without_place_ = 0;
};

/// Without the characters that begin parameters and expressions, cut without splitting a UTF-8 character.
std::string title_text(std::string_view text) {
  std::string title = printable(text);
  for (char& c : title)
    if (c == '&' || c == '<' || c == '>') c = '_';
  title.resize(beginning(title, longest_set_title).size());
  return title;
}

/// "GC101 initial-penetration contact 3: 17 nodes, deepest 0.5; hood on hinge".
std::string title_of(const Report& report, std::uint32_t contact, const SetMembers& members, std::size_t count,
                     std::string_view what) {
  std::string title = fmt::format("{} {}", members.id, members.rule);
  const bool known = contact < report.contacts.size();
  if (known) title += fmt::format(" contact {}", report.contacts[contact].id);
  title += fmt::format(": {} {}{}", count, what, count == 1 ? "" : "s");
  if (members.deepest > 0) title += fmt::format(", deepest {:.3g}", members.deepest);
  if (known && !report.contacts[contact].title.empty()) title += "; " + report.contacts[contact].title;
  return title_text(title);
}

std::int64_t free_set_id(const Report& report) {
  if (report.highest_set > 0 && report.highest_set < most_set_id) return report.highest_set + 1;
  return report.source == "deck" ? 1 : first_free_id(report);
}

class SetFile {
 public:
  SetFile(const Report& report, std::int64_t first_id) : report_(report), groups_(report) {
    id_ = first_id > 0 ? first_id : free_set_id(report);
    std::int64_t highest = id_ + static_cast<std::int64_t>(groups_.all().size());
    for (const auto& [key, members] : groups_.all()) {
      if (!members.nodes.empty()) highest = std::max(highest, members.nodes.back());
      for (const Segment& segment : members.segments)
        highest = std::max(highest, *std::max_element(segment.begin(), segment.end()));
    }
    width_ = highest > most_short_id ? 20 : 10;
  }

  std::string text() {
    // The format is named: a deck that includes the file may have another one.
    line(width_ == 10 ? "*KEYWORD LONG=S" : "*KEYWORD LONG=Y");
    comment(fmt::format("Nodes and segments of the findings in {}", printable(report_.input)));
    comment("The sets of one rule in one contact have the same id.");
    if (groups_.without_place() > 0)
      comment(fmt::format("{} findings name no node and no segment: they are in no set", groups_.without_place()));
    for (const auto& [key, members] : groups_.all()) write(key.first, members);
    line("*END");
    return fmt::to_string(out_);
  }

 private:
  void write(std::uint32_t contact, const SetMembers& members) {
    if (members.not_listed > 0)
      comment(fmt::format("{}: {} more are counted in the report and in no set", members.id, members.not_listed));
    if (members.without_id > 0)
      comment(fmt::format("{}: {} more have numbers that are no ids", members.id, members.without_id));
    if (members.nodes.empty() && members.segments.empty()) return;
    if (!members.nodes.empty()) write_nodes(title_of(report_, contact, members, members.nodes.size(), "node"), members);
    if (!members.segments.empty())
      write_segments(title_of(report_, contact, members, members.segments.size(), "segment"), members);
    ++id_;
  }

  void write_nodes(std::string_view title, const SetMembers& members) {
    line("*SET_NODE_LIST_TITLE");
    line(title);
    field(id_);
    for (std::size_t i = 0; i < members.nodes.size(); ++i) {
      if (i % ids_per_card == 0) line("");
      field(members.nodes[i]);
    }
    line("");
  }

  void write_segments(std::string_view title, const SetMembers& members) {
    line("*SET_SEGMENT_TITLE");
    line(title);
    field(id_);
    line("");
    for (const Segment& segment : members.segments) {
      for (const std::int64_t node : segment) field(node);
      line("");
    }
  }

  void line(std::string_view text) {
    out_.append(text);
    out_.push_back('\n');
  }
  void comment(std::string_view text) { fmt::format_to(fmt::appender(out_), "$ {}\n", text); }
  void field(std::int64_t value) { fmt::format_to(fmt::appender(out_), "{:>{}}", value, width_); }

  const Report& report_;
  FindingGroups groups_;
  std::int64_t id_ = 1;
  int width_ = 10;
  fmt::memory_buffer out_;
};

}  // namespace

std::string keyword_sets(const Report& report, std::int64_t first_id) { return SetFile(report, first_id).text(); }

}  // namespace gapcheck::report
